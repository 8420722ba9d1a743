// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

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
