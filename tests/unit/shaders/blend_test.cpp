// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "core/formulae/formulae.h"
#include "shaders/published_modes.h"

namespace patina {
namespace {

using formulae::Real3;
using test_support::published_blend;

using Separable = float (*)(float, float);
const std::map<BlendMode, Separable>& separable_modes() {
    using enum BlendMode;
    static const std::map<BlendMode, Separable> modes = {
        {Normal, formulae::blend_normal},
        {Replace, formulae::blend_normal},
        {Darken, formulae::blend_darken},
        {Multiply, formulae::blend_multiply},
        {ColorBurn, formulae::blend_color_burn},
        {LinearBurn, formulae::blend_linear_burn},
        {Lighten, formulae::blend_lighten},
        {Screen, formulae::blend_screen},
        {ColorDodge, formulae::blend_color_dodge},
        {Add, formulae::blend_add},
        {Overlay, formulae::blend_overlay},
        {SoftLightW3c, formulae::blend_soft_light_w3c},
        {SoftLightPegtop, formulae::blend_soft_light_pegtop},
        {HardLight, formulae::blend_hard_light},
        {VividLight, formulae::blend_vivid_light},
        {LinearLight, formulae::blend_linear_light},
        {PinLight, formulae::blend_pin_light},
        {HardMix, formulae::blend_hard_mix},
        {Difference, formulae::blend_difference},
        {Exclusion, formulae::blend_exclusion},
        {Subtract, formulae::blend_subtract},
        {InverseSubtract, formulae::blend_inverse_subtract},
        {Divide, formulae::blend_divide},
        {InverseDivide, formulae::blend_inverse_divide},
        {SignedAdd, formulae::blend_signed_add},
        {Average, formulae::blend_average},
    };
    return modes;
}

using OfColors = Real3 (*)(Real3, Real3);
const std::map<BlendMode, OfColors>& color_modes() {
    using enum BlendMode;
    static const std::map<BlendMode, OfColors> modes = {
        {HueW3c, formulae::blend_hue_w3c},     {SaturationW3c, formulae::blend_saturation_w3c},
        {ColorW3c, formulae::blend_color_w3c}, {LuminosityW3c, formulae::blend_luminosity_w3c},
        {TintHsv, formulae::blend_tint_hsv},   {SaturationHsv, formulae::blend_saturation_hsv},
        {ColorHsv, formulae::blend_color_hsv}, {ValueHsv, formulae::blend_value_hsv},
    };
    return modes;
}

/// Every pair of 8-bit values has each branch point beside it on both sides.
template <typename Check>
void for_each_pair_of_bytes(const Check& check) {
    for (int backdrop = 0; backdrop <= 255; ++backdrop)
        for (int source = 0; source <= 255; ++source)
            check(static_cast<float>(backdrop) / 255.0f, static_cast<float>(source) / 255.0f);
}

/// All colours whose components are among `levels` steps, in pairs.
template <typename Check>
void for_each_pair_of_colors(int levels, const Check& check) {
    std::vector<glm::vec3> colors;
    const auto level = [&](int i) {
        return static_cast<float>(i) / static_cast<float>(levels - 1);
    };
    for (int r = 0; r < levels; ++r)
        for (int g = 0; g < levels; ++g)
            for (int b = 0; b < levels; ++b) colors.emplace_back(level(r), level(g), level(b));
    for (const glm::vec3& backdrop : colors)
        for (const glm::vec3& source : colors) check(backdrop, source);
}

glm::dvec3 blended(OfColors formula, const glm::vec3& backdrop, const glm::vec3& source) {
    const Real3 result =
        formula({backdrop.x, backdrop.y, backdrop.z}, {source.x, source.y, source.z});
    return {result.x, result.y, result.z};
}

TEST(Blend, EveryModeOfColoursAndScalarsIsTested) {
    for (const BlendModeInfo& row : kBlendModes) {
        if (!applies_to(row.mode, Channel::BaseColor)) continue;
        EXPECT_NE(separable_modes().contains(row.mode), color_modes().contains(row.mode)) << row.id;
        EXPECT_EQ(color_modes().contains(row.mode), test_support::is_non_separable(row.mode))
            << row.id;
    }
}

TEST(Blend, EveryModeIsItsPublishedDefinitionOnAllPairsOfBytes) {
    for (const auto& [mode, formula] : separable_modes()) {
        double worst = 0;
        for_each_pair_of_bytes([&, &formula = formula, &mode = mode](float cb, float cs) {
            // At the step of hard mix the rounding of the sum decides.
            if (mode == BlendMode::HardMix && std::abs(cb + cs - 1) < 1e-6f) return;
            const double published =
                published_blend(mode, static_cast<double>(cb), static_cast<double>(cs));
            worst = std::max(worst, std::abs(static_cast<double>(formula(cb, cs)) - published));
        });
        EXPECT_LE(worst, 4e-7) << info(mode).id;
    }
}

TEST(Blend, EveryModeIsItsPublishedDefinitionAtTheBranchPoints) {
    for (const auto& [mode, formula] : separable_modes())
        for (const float cb : {0.0f, 0.25f, std::nextafter(0.25f, 1.0f), 0.5f, 1.0f})
            for (const float cs : {0.0f, 0.25f, 0.5f, std::nextafter(0.5f, 1.0f), 1.0f})
                EXPECT_NEAR(static_cast<double>(formula(cb, cs)),
                            published_blend(mode, static_cast<double>(cb), static_cast<double>(cs)),
                            3e-7)
                    << info(mode).id << " of " << cb << " and " << cs;
}

TEST(Blend, EveryModeStaysWithinZeroToOne) {
    for (const auto& [mode, formula] : separable_modes())
        for_each_pair_of_bytes([&, &formula = formula, &mode = mode](float cb, float cs) {
            ASSERT_GE(formula(cb, cs), -1e-7f) << info(mode).id << " of " << cb << ", " << cs;
            ASSERT_LE(formula(cb, cs), 1.0f + 1e-7f) << info(mode).id << " of " << cb << ", " << cs;
        });
}

TEST(Blend, ModesOfWholeColoursAreTheirPublishedDefinitionsOverAGrid) {
    for (const auto& [mode, formula] : color_modes()) {
        double worst = 0;
        for_each_pair_of_colors(
            9, [&, &formula = formula, &mode = mode](const glm::vec3& cb, const glm::vec3& cs) {
                const glm::dvec3 difference = blended(formula, cb, cs) -
                                              published_blend(mode, glm::dvec3(cb), glm::dvec3(cs));
                for (int k = 0; k < 3; ++k) worst = std::max(worst, std::abs(difference[k]));
            });
        EXPECT_LE(worst, 2e-6) << info(mode).id;
    }
}

TEST(Blend, ModesOfTheLuminosityFamilyKeepTheLuminosityThatTheyName) {
    const auto luminosity = [](const glm::dvec3& c) { return 0.3 * c.r + 0.59 * c.g + 0.11 * c.b; };
    for_each_pair_of_colors(6, [&](const glm::vec3& cb, const glm::vec3& cs) {
        for (const BlendMode mode :
             {BlendMode::HueW3c, BlendMode::SaturationW3c, BlendMode::ColorW3c})
            ASSERT_NEAR(luminosity(blended(color_modes().at(mode), cb, cs)),
                        luminosity(glm::dvec3(cb)), 1e-6)
                << info(mode).id;
        ASSERT_NEAR(luminosity(blended(formulae::blend_luminosity_w3c, cb, cs)),
                    luminosity(glm::dvec3(cs)), 1e-6);
    });
}

TEST(Blend, NeutralSourcesReturnTheBackdrop) {
    for (int byte = 0; byte <= 255; ++byte) {
        const float cb = static_cast<float>(byte) / 255.0f;
        for (const Separable formula :
             {formulae::blend_multiply, formulae::blend_darken, formulae::blend_divide})
            EXPECT_EQ(formula(cb, 1.0f), cb);
        for (const Separable formula :
             {formulae::blend_screen, formulae::blend_add, formulae::blend_subtract,
              formulae::blend_lighten, formulae::blend_difference, formulae::blend_exclusion,
              formulae::blend_color_dodge})
            EXPECT_EQ(formula(cb, 0.0f), cb);
        for (const Separable formula :
             {formulae::blend_hard_light, formulae::blend_soft_light_w3c,
              formulae::blend_soft_light_pegtop, formulae::blend_linear_light,
              formulae::blend_signed_add, formulae::blend_pin_light})
            EXPECT_EQ(formula(cb, 0.5f), cb);
        EXPECT_NEAR(formulae::blend_color_burn(cb, 1.0f), cb, 1e-7f);
        EXPECT_NEAR(formulae::blend_linear_burn(cb, 1.0f), cb, 1e-7f);
        EXPECT_NEAR(formulae::blend_vivid_light(cb, 0.5f), cb, 1e-7f);
        EXPECT_NEAR(formulae::blend_overlay(cb, 0.5f), cb, 1e-7f);
    }
}

TEST(Blend, CommutativeModesCommuteExactly) {
    for_each_pair_of_bytes([](float cb, float cs) {
        for (const Separable formula :
             {formulae::blend_multiply, formulae::blend_screen, formulae::blend_add,
              formulae::blend_darken, formulae::blend_lighten, formulae::blend_difference,
              formulae::blend_exclusion, formulae::blend_average, formulae::blend_hard_mix,
              formulae::blend_linear_burn})
            ASSERT_EQ(formula(cb, cs), formula(cs, cb));
    });
}

}  // namespace
}  // namespace patina
