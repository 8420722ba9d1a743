// SPDX-License-Identifier: MIT
// Each polynomial is swept densely and held to the error that its comment states.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/formulae/formulae.h"

namespace patina {
namespace {

/// Calls check(x) for `count` floats from `lowest` to `highest`, both included.
template <typename Check>
void sweep(double lowest, double highest, int count, const Check& check) {
    for (int i = 0; i <= count; ++i)
        check(static_cast<float>(lowest + (highest - lowest) * i / count));
}

TEST(Transcendental, Exp2StaysWithinItsRelativeError) {
    double worst = 0;
    sweep(-126, 127.4, 400'000, [&](float x) {
        const double exact = std::exp2(double{x});
        worst = std::max(worst, std::abs(formulae::exp2_poly(x) - exact) / exact);
    });
    EXPECT_LE(worst, 2e-7);
}

TEST(Transcendental, Exp2OfWholeNumbersIsExactAndOfVeryNegativeOnesZero) {
    for (int exponent = -126; exponent <= 127; ++exponent)
        EXPECT_EQ(formulae::exp2_poly(static_cast<float>(exponent)), std::ldexp(1.0f, exponent));
    EXPECT_EQ(formulae::exp2_poly(-126.5f), 0.0f);
    EXPECT_EQ(formulae::exp2_poly(-1e30f), 0.0f);
    EXPECT_TRUE(std::isfinite(formulae::exp2_poly(1e30f)));
}

TEST(Transcendental, Log2StaysWithinItsError) {
    double worst = 0;  // in units of the stated bound
    sweep(-120, 120, 400'000, [&](float exponent) {
        const float x = std::exp2(exponent);
        const double exact = std::log2(double{x});
        worst = std::max(
            worst, std::abs(formulae::log2_poly(x) - exact) / (1e-7 + 6e-8 * std::abs(exact)));
    });
    EXPECT_LE(worst, 1.0);
    EXPECT_EQ(formulae::log2_poly(1.0f), 0.0f);
    EXPECT_EQ(formulae::log2_poly(0.125f), -3.0f);
    EXPECT_EQ(formulae::log2_poly(0.0f), -127.0f);
}

TEST(Transcendental, PowersStayWithinTheirRelativeError) {
    double worst = 0;
    for (const float y : {0.1f, 0.416666667f, 1.0f, 2.2f, 2.4f, 5.0f, 20.0f, 200.0f})
        sweep(0.001, 1.5, 50'000, [&](float x) {
            const double exact = std::pow(double{x}, double{y});
            if (exact < 1e-37 || exact > 1e37) return;
            const double bound =
                2e-7 + std::abs(y) * (5e-8 + 8e-8 * std::abs(std::log2(double{x})));
            worst = std::max(worst, std::abs(formulae::pow_poly(x, y) - exact) / exact / bound);
        });
    EXPECT_LE(worst, 1.0);
    EXPECT_EQ(formulae::pow_poly(1.0f, 12345.0f), 1.0f);
    EXPECT_EQ(formulae::pow_poly(0.0f, 0.5f), 0.0f);
}

TEST(Transcendental, SineAndCosineStayWithinTheirError) {
    double worst_sine = 0, worst_cosine = 0;
    sweep(-100, 100, 400'000, [&](float x) {
        worst_sine = std::max(worst_sine, std::abs(formulae::sin_poly(x) - std::sin(double{x})));
        worst_cosine =
            std::max(worst_cosine, std::abs(formulae::cos_poly(x) - std::cos(double{x})));
    });
    EXPECT_LE(worst_sine, 2e-7);
    EXPECT_LE(worst_cosine, 3e-7);
    EXPECT_EQ(formulae::sin_poly(0.0f), 0.0f);
}

TEST(Transcendental, AnglesStayWithinTheirError) {
    double worst_acos = 0, worst_atan2 = 0;
    sweep(-1, 1, 300'000, [&](float x) {
        worst_acos = std::max(worst_acos, std::abs(formulae::acos_poly(x) - std::acos(double{x})));
    });
    sweep(0, 6.2831853, 300'000, [&](float angle) {
        const float x = 3.0f * std::cos(angle), y = 3.0f * std::sin(angle);
        worst_atan2 = std::max(
            worst_atan2, std::abs(formulae::atan2_poly(y, x) - std::atan2(double{y}, double{x})));
    });
    EXPECT_LE(worst_acos, 5e-7);
    EXPECT_LE(worst_atan2, 4e-7);
    EXPECT_EQ(formulae::acos_poly(1.0f), 0.0f);
    EXPECT_EQ(formulae::atan2_poly(0.0f, 0.0f), 0.0f);
    EXPECT_FLOAT_EQ(formulae::acos_poly(-1.5f), 3.14159265f);
}

}  // namespace
}  // namespace patina
