// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "core/formulae/formulae.h"

namespace patina {
namespace {

/// A mode and its published definition (cb backdrop, cs source), from the specification's text.
struct Mode {
    std::string name;
    std::function<float(float, float)> formula;
    std::function<double(double, double)> published;
};

double published_hard_light(double cb, double cs) {
    return cs <= 0.5 ? cb * 2 * cs : cb + (2 * cs - 1) - cb * (2 * cs - 1);
}

double published_soft_light(double cb, double cs) {
    const double d = cb <= 0.25 ? ((16 * cb - 12) * cb + 4) * cb : std::sqrt(cb);
    return cs <= 0.5 ? cb - (1 - 2 * cs) * cb * (1 - cb) : cb + (2 * cs - 1) * (d - cb);
}

const std::vector<Mode>& modes() {
    static const std::vector<Mode> all = {
        {"normal", formulae::blend_normal, [](double, double cs) { return cs; }},
        {"multiply", formulae::blend_multiply, [](double cb, double cs) { return cb * cs; }},
        {"screen", formulae::blend_screen,
         [](double cb, double cs) { return 1 - (1 - cb) * (1 - cs); }},
        {"hard light", formulae::blend_hard_light, published_hard_light},
        {"overlay", formulae::blend_overlay,
         [](double cb, double cs) { return published_hard_light(cs, cb); }},
        {"add", formulae::blend_add, [](double cb, double cs) { return cb + cs; }},
        {"subtract", formulae::blend_subtract, [](double cb, double cs) { return cb - cs; }},
        {"soft light", formulae::blend_soft_light_w3c, published_soft_light},
        {"darken", formulae::blend_darken, [](double cb, double cs) { return std::min(cb, cs); }},
        {"lighten", formulae::blend_lighten, [](double cb, double cs) { return std::max(cb, cs); }},
        {"difference", formulae::blend_difference,
         [](double cb, double cs) { return std::abs(cb - cs); }},
    };
    return all;
}

/// Every pair of 8-bit values has each branch point beside it on both sides.
template <typename Check>
void for_each_pair_of_bytes(const Check& check) {
    for (int backdrop = 0; backdrop <= 255; ++backdrop)
        for (int source = 0; source <= 255; ++source)
            check(static_cast<float>(backdrop) / 255.0f, static_cast<float>(source) / 255.0f);
}

TEST(Blend, EveryModeIsItsPublishedDefinitionOnAllPairsOfBytes) {
    for (const Mode& mode : modes()) {
        double worst = 0;
        for_each_pair_of_bytes([&](float cb, float cs) {
            worst = std::max(worst, std::abs(mode.formula(cb, cs) - mode.published(cb, cs)));
        });
        EXPECT_LE(worst, 3e-7) << mode.name;
    }
}

TEST(Blend, EveryModeIsItsPublishedDefinitionAtTheBranchPoints) {
    for (const Mode& mode : modes())
        for (const float cb : {0.0f, 0.25f, std::nextafter(0.25f, 1.0f), 0.5f, 1.0f})
            for (const float cs : {0.0f, 0.25f, 0.5f, std::nextafter(0.5f, 1.0f), 1.0f})
                EXPECT_NEAR(mode.formula(cb, cs), mode.published(cb, cs), 2e-7)
                    << mode.name << " of " << cb << " and " << cs;
}

TEST(Blend, ModesOtherThanAddAndSubtractStayWithinZeroToOne) {
    for (const Mode& mode : modes()) {
        if (mode.name == "add" || mode.name == "subtract") continue;
        for_each_pair_of_bytes([&](float cb, float cs) {
            ASSERT_GE(mode.formula(cb, cs), -1e-7f) << mode.name << " of " << cb << ", " << cs;
            ASSERT_LE(mode.formula(cb, cs), 1.0f + 1e-7f)
                << mode.name << " of " << cb << ", " << cs;
        });
    }
}

TEST(Blend, NeutralSourcesReturnTheBackdrop) {
    for (int byte = 0; byte <= 255; ++byte) {
        const float cb = static_cast<float>(byte) / 255.0f;
        EXPECT_EQ(formulae::blend_multiply(cb, 1.0f), cb);
        EXPECT_EQ(formulae::blend_darken(cb, 1.0f), cb);
        EXPECT_EQ(formulae::blend_screen(cb, 0.0f), cb);
        EXPECT_EQ(formulae::blend_add(cb, 0.0f), cb);
        EXPECT_EQ(formulae::blend_subtract(cb, 0.0f), cb);
        EXPECT_EQ(formulae::blend_lighten(cb, 0.0f), cb);
        EXPECT_EQ(formulae::blend_difference(cb, 0.0f), cb);
        EXPECT_EQ(formulae::blend_hard_light(cb, 0.5f), cb);
        EXPECT_EQ(formulae::blend_soft_light_w3c(cb, 0.5f), cb);
        EXPECT_NEAR(formulae::blend_overlay(cb, 0.5f), cb, 1e-7f);
    }
}

TEST(Blend, CommutativeModesCommuteExactly) {
    for_each_pair_of_bytes([](float cb, float cs) {
        ASSERT_EQ(formulae::blend_multiply(cb, cs), formulae::blend_multiply(cs, cb));
        ASSERT_EQ(formulae::blend_screen(cb, cs), formulae::blend_screen(cs, cb));
        ASSERT_EQ(formulae::blend_add(cb, cs), formulae::blend_add(cs, cb));
        ASSERT_EQ(formulae::blend_darken(cb, cs), formulae::blend_darken(cs, cb));
        ASSERT_EQ(formulae::blend_lighten(cb, cs), formulae::blend_lighten(cs, cb));
        ASSERT_EQ(formulae::blend_difference(cb, cs), formulae::blend_difference(cs, cb));
    });
}

}  // namespace
}  // namespace patina
