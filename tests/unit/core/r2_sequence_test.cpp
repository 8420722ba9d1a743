// SPDX-License-Identifier: MIT
#include "core/r2_sequence.h"

#include <gtest/gtest.h>

#include <cmath>

namespace patina {
namespace {

TEST(R2Sequence, BeginsInTheMiddle) {
    EXPECT_EQ(r2_point(0).u, 0.5);
    EXPECT_EQ(r2_point(0).v, 0.5);
}

TEST(R2Sequence, ItsStepsArePowersOfThePlasticNumbersInverse) {
    const double step = r2_point(1).u + 0.5;                    // modulo 1
    EXPECT_NEAR(step * step * step + step * step, 1.0, 1e-12);  // the number: x^3 = x + 1
    EXPECT_NEAR(r2_point(1).v + 0.5, step * step, 1e-12);
}

TEST(R2Sequence, NoTwoOfManyPointsAreClose) {
    constexpr int kCount = 256;
    for (int i = 0; i < kCount; ++i)
        for (int j = 0; j < i; ++j) {
            const double across = r2_point(i).u - r2_point(j).u;
            const double up = r2_point(i).v - r2_point(j).v;
            EXPECT_GT(std::hypot(across, up), 0.5 / std::sqrt(double{kCount})) << i << ", " << j;
        }
}

}  // namespace
}  // namespace patina
