// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/formulae/formulae.h"

namespace patina {
namespace {

using formulae::Real3;

/// The angle between n and h at which a lobe has fallen to one half of its peak, by bisection.
double half_maximum_angle(const std::function<double(double angle)>& lobe) {
    double inside = 0, outside = 1.5707963;
    for (int i = 0; i < 60; ++i) {
        const double middle = (inside + outside) / 2;
        (lobe(middle) > 0.5 * lobe(0) ? inside : outside) = middle;
    }
    return inside;
}

double ggx_width(double roughness) {
    const double alpha2 = std::pow(roughness, 4);
    return half_maximum_angle([&](double angle) {
        const double c2 = std::cos(angle) * std::cos(angle);
        return alpha2 / std::pow(c2 * (alpha2 - 1) + 1, 2);
    });
}

TEST(Phong, HighlightsAreAsWideAsThoseOfGgxAtHalfMaximum) {
    for (const double roughness : {0.17, 0.2, 0.35, 0.5, 0.6, 0.7}) {
        const double exponent = formulae::blinn_phong_exponent(static_cast<float>(roughness));
        const double width =
            half_maximum_angle([&](double angle) { return std::pow(std::cos(angle), exponent); });
        EXPECT_NEAR(width / ggx_width(roughness), 1.0, 1e-3) << "Blinn-Phong at " << roughness;
    }
    for (const double roughness : {0.17, 0.2, 0.35, 0.5, 0.6}) {
        const double exponent = formulae::phong_exponent(static_cast<float>(roughness));
        // The mirrored light turns by twice the angle of the half vector.
        const double width = half_maximum_angle([&](double angle) {
            return 2 * angle < 1.5707963 ? std::pow(std::cos(2 * angle), exponent) : 0.0;
        });
        EXPECT_NEAR(width / ggx_width(roughness), 1.0, 1e-3) << "Phong at " << roughness;
    }
}

TEST(Phong, ExponentsFallAsRoughnessRisesAndStayInTheirRange) {
    for (int i = 1; i <= 1000; ++i) {
        const float smoother = static_cast<float>(i - 1) / 1000.0f;
        const float rougher = static_cast<float>(i) / 1000.0f;
        ASSERT_GE(formulae::blinn_phong_exponent(smoother),
                  formulae::blinn_phong_exponent(rougher));
        ASSERT_GE(formulae::phong_exponent(smoother), formulae::phong_exponent(rougher));
    }
    EXPECT_EQ(formulae::blinn_phong_exponent(0.0f), formulae::MOST_BLINN_PHONG_EXPONENT);
    EXPECT_EQ(formulae::phong_exponent(0.0f), formulae::MOST_PHONG_EXPONENT);
    EXPECT_EQ(formulae::blinn_phong_exponent(1.0f), 1.0f);
    EXPECT_EQ(formulae::phong_exponent(1.0f), 1.0f);
}

TEST(Phong, SpecularColoursStayWithinZeroToOneAndKeepTheirHue) {
    const Real3 gold(1.0f, 0.77f, 0.34f);
    for (int i = 0; i <= 100; ++i) {
        const float roughness = static_cast<float>(i) / 100.0f;
        const Real3 color = formulae::phong_specular_color(gold, roughness);
        ASSERT_GT(color.x, 0.0f) << roughness;
        ASSERT_LE(color.x, 1.0f) << roughness;
        ASSERT_NEAR(color.y / color.x, 0.77f, 1e-6f) << roughness;
        ASSERT_NEAR(color.z / color.x, 0.34f, 1e-6f) << roughness;
    }
}

TEST(Phong, ASmoothHighlightIsAsBrightAsAColourCanBeAndARoughOneIsDim) {
    EXPECT_FLOAT_EQ(formulae::phong_specular_color(Real3(0.04f), 0.1f).x, 1.0f);
    // The least exponent, 1, is Blinn's: a peak of (1 + 4) / 8.
    EXPECT_FLOAT_EQ(formulae::phong_specular_color(Real3(0.04f), 1.0f).x, 0.04f * 5.0f / 8.0f);
}

TEST(Phong, AWideLobeReflectsNoMoreThanMeetsIt) {
    // Lambert's share of irradiance / pi is the colour itself: all of it for white.
    for (const float roughness : {0.5f, 0.7f, 0.9f, 1.0f}) {
        const double peak = formulae::phong_specular_color(Real3(0.01f), roughness).x / 0.01;
        const double exponent = formulae::blinn_phong_exponent(roughness) / 4.0;
        const double spread = 2.0 * 3.14159265 / (exponent + 1.0);  // of cos^e over a hemisphere
        EXPECT_NEAR(peak * spread / 3.14159265, 1.0, 1e-3) << roughness;
    }
}

TEST(Phong, AWideLobeEndsAtTheHorizonWithoutAnEdge) {
    for (const auto lobe : {formulae::phong_lobe, formulae::blinn_phong_lobe}) {
        EXPECT_EQ(lobe(0.9f, -0.1f, 1.0f), 0.0f);
        EXPECT_LT(lobe(0.9f, 0.001f, 1.0f), 0.01f);
        EXPECT_GT(lobe(0.9f, 0.25f, 1.0f), 0.89f);
    }
}

TEST(Phong, MetalsKeepADiffuseColourAndDielectricsAllOfIt) {
    const Real3 base(0.5f, 0.25f, 1.0f);
    EXPECT_EQ(formulae::phong_diffuse_color(base, 0.0f).z, 1.0f);
    EXPECT_FLOAT_EQ(formulae::phong_diffuse_color(base, 1.0f).z, 0.6f);
}

TEST(Phong, LobesPeakAtTheMirrorDirectionAndAreDarkBehind) {
    EXPECT_EQ(formulae::phong_lobe(1.0f, 0.5f, 40.0f), 1.0f);
    EXPECT_EQ(formulae::blinn_phong_lobe(1.0f, 0.5f, 40.0f), 1.0f);
    EXPECT_EQ(formulae::phong_lobe(1.0f, 0.0f, 40.0f), 0.0f);
    EXPECT_EQ(formulae::phong_lobe(-0.5f, 0.5f, 2.0f), 0.0f);
    EXPECT_NEAR(formulae::blinn_phong_lobe(0.9f, 0.5f, 40.0f), std::pow(0.9, 40), 1e-7);
}

}  // namespace
}  // namespace patina
