// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/formulae/formulae.h"

namespace patina {
namespace {

double published_linear(double s) {
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}
double published_encoded(double x) {
    return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
}

TEST(Color, EncodingAndDecodingEveryByteReturnsIt) {
    for (int byte = 0; byte <= 255; ++byte) {
        const float linear = formulae::linear_from_srgb(static_cast<float>(byte) / 255.0f);
        const float encoded = formulae::srgb_from_linear(linear);
        EXPECT_EQ(static_cast<int>(encoded * 255.0f + 0.5f), byte);
        EXPECT_NEAR(encoded * 255.0f, static_cast<float>(byte), 1e-3f);
    }
}

TEST(Color, SixteenBitValuesSurviveARoundTrip) {
    for (int value = 0; value <= 65535; ++value) {
        const float linear = formulae::linear_from_srgb(static_cast<float>(value) / 65535.0f);
        ASSERT_EQ(static_cast<int>(formulae::srgb_from_linear(linear) * 65535.0f + 0.5f), value);
    }
}

TEST(Color, EncodingStaysWithinItsErrorOfTheStandard) {
    double worst = 0;
    for (int i = 0; i <= 300'000; ++i) {
        const float x = static_cast<float>(i) / 3e5f;
        worst = std::max(worst, std::abs(formulae::srgb_from_linear(x) - published_encoded(x)));
    }
    EXPECT_LE(worst, 3e-6);
}

TEST(Color, DecodingStaysWithinItsErrorOfTheStandard) {
    double worst = 0;
    for (int i = 0; i <= 300'000; ++i) {
        const float s = static_cast<float>(i) / 3e5f;
        const double stands_for = published_encoded(formulae::linear_from_srgb(s));
        // The standard's two pieces do not quite meet; its own round trip is off by 3e-8 there.
        worst = std::max(worst, std::abs(stands_for - published_encoded(published_linear(s))));
    }
    EXPECT_LE(worst, 6e-7);
}

TEST(Color, BlackAndWhiteAreExactAndTheRestIsMonotone) {
    EXPECT_EQ(formulae::srgb_from_linear(0.0f), 0.0f);
    EXPECT_EQ(formulae::srgb_from_linear(1.0f), 1.0f);
    EXPECT_EQ(formulae::linear_from_srgb(0.0f), 0.0f);
    EXPECT_EQ(formulae::linear_from_srgb(1.0f), 1.0f);
    EXPECT_EQ(formulae::srgb_from_linear(7.0f), 1.0f);
    EXPECT_EQ(formulae::linear_from_srgb(-1.0f), 0.0f);
    for (int i = 1; i <= 65536; ++i) {
        const float before = static_cast<float>(i - 1) / 65536.0f;
        const float after = static_cast<float>(i) / 65536.0f;
        ASSERT_LT(formulae::srgb_from_linear(before), formulae::srgb_from_linear(after));
        ASSERT_LT(formulae::linear_from_srgb(before), formulae::linear_from_srgb(after));
    }
}

TEST(Color, MiddleGreyAndLuminanceHaveTheirPublishedValues) {
    EXPECT_NEAR(formulae::linear_from_srgb(0.5f), 0.214041140f, 1e-6f);
    EXPECT_NEAR(formulae::srgb_from_linear(0.18f), 0.461356129f, 3e-6f);
    EXPECT_FLOAT_EQ(formulae::luminance(formulae::Real3(1.0f)), 1.0f);
    EXPECT_FLOAT_EQ(formulae::luminance({0.0f, 1.0f, 0.0f}), 0.7152f);
    EXPECT_FLOAT_EQ(formulae::luma_bt601(formulae::Real3(1.0f)), 1.0f);
    EXPECT_FLOAT_EQ(formulae::luma_bt601({0.0f, 1.0f, 0.0f}), 0.587f);
}

}  // namespace
}  // namespace patina
