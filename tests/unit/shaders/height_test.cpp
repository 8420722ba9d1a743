// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/formulae/formulae.h"

namespace patina {
namespace {

TEST(Height, ZeroIsNeutralToAddAndTheHigherOfTwoWins) {
    EXPECT_EQ(formulae::height_add(-0.25f, 0.0f), -0.25f);
    EXPECT_EQ(formulae::height_add(-0.25f, 0.5f), 0.25f);
    EXPECT_EQ(formulae::height_max(-0.25f, 0.5f), 0.5f);
    EXPECT_EQ(formulae::height_max(-0.25f, -0.5f), -0.25f);
}

/// Mishkinis's blend of two layers, as his article has it.
double share_of_source(double backdrop, double source, double depth) {
    const double line = std::max(backdrop, source) - depth;
    const double below = std::max(backdrop - line, 0.0), own = std::max(source - line, 0.0);
    return own / (own + below);
}

TEST(Height, TheShareOfALayerIsThatOfThePublishedBlendByDepth) {
    for (int a = -20; a <= 20; ++a)
        for (int b = -20; b <= 20; ++b)
            EXPECT_NEAR(formulae::height_share(static_cast<float>(a) / 20.0f,
                                               static_cast<float>(b) / 20.0f, 0.0f, 0.3f, 0.0f),
                        share_of_source(a / 20.0, b / 20.0, 0.3), 1e-6);
}

TEST(Height, SharesOfTwoLayersThatChangePlacesAddUpToOne) {
    for (int a = -20; a <= 20; ++a) {
        const float height = static_cast<float>(a) / 20.0f;
        for (const float contrast : {0.0f, 0.7f}) {
            EXPECT_NEAR(formulae::height_share(0.1f, height, 0.0f, 0.5f, contrast) +
                            formulae::height_share(height, 0.1f, 0.0f, 0.5f, contrast),
                        1.0f, 1e-6f);
        }
    }
}

TEST(Height, TheHigherLayerIsAllThereBeyondTheRadiusAndTheLevelOneIsHalf) {
    EXPECT_EQ(formulae::height_share(0.2f, 0.75f, 0.0f, 0.5f, 0.0f), 1.0f);
    EXPECT_EQ(formulae::height_share(0.75f, 0.2f, 0.0f, 0.5f, 0.0f), 0.0f);
    EXPECT_EQ(formulae::height_share(0.25f, 0.25f, 0.0f, 0.5f, 0.9f), 0.5f);
    EXPECT_EQ(formulae::height_share(0.5f, 0.25f, 0.25f, 0.5f, 0.0f), 0.5f);
    // No radius, or full contrast: an edge.
    EXPECT_EQ(formulae::height_share(0.25f, 0.26f, 0.0f, 0.0f, 0.0f), 1.0f);
    EXPECT_EQ(formulae::height_share(0.25f, 0.24f, 0.0f, 0.0f, 0.0f), 0.0f);
    EXPECT_EQ(formulae::height_share(0.25f, 0.26f, 0.0f, 0.5f, 1.0f), 1.0f);
}

TEST(Height, TheSlopeOfAPlaneIsExact) {
    const auto plane = [](float x, float y) { return 0.5f * x - 2.0f * y + 3.0f; };
    EXPECT_EQ(formulae::height_slope(plane(-1, -1), plane(-1, 0), plane(-1, 1), plane(1, -1),
                                     plane(1, 0), plane(1, 1)),
              0.5f);
    EXPECT_EQ(formulae::height_slope(plane(-1, -1), plane(0, -1), plane(1, -1), plane(-1, 1),
                                     plane(0, 1), plane(1, 1)),
              -2.0f);
}

TEST(Height, ANormalLeansAwayFromTheRise) {
    const formulae::Real3 flat = formulae::height_normal(0.0f, 0.0f);
    EXPECT_EQ(flat.x, 0.0f);
    EXPECT_EQ(flat.z, 1.0f);
    const formulae::Real3 normal = formulae::height_normal(1.0f, -2.0f);
    EXPECT_FLOAT_EQ(normal.x, -1.0f / std::sqrt(6.0f));
    EXPECT_FLOAT_EQ(normal.y, 2.0f / std::sqrt(6.0f));
    EXPECT_FLOAT_EQ(normal.z, 1.0f / std::sqrt(6.0f));
}

}  // namespace
}  // namespace patina
