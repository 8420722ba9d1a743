// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/formulae/formulae.h"

namespace patina {
namespace {

using formulae::Real2;

TEST(Sequence, MirroredBitsAreThoseFromTheOtherEnd) {
    EXPECT_EQ(formulae::mirrored_bits(1u), 0x80000000u);
    EXPECT_EQ(formulae::mirrored_bits(0x0000000du), 0xb0000000u);
    EXPECT_EQ(formulae::mirrored_bits(formulae::mirrored_bits(0x12345678u)), 0x12345678u);
}

TEST(Sequence, HammersleyPointsFillTheSquareEvenly) {
    double sum_x = 0, sum_y = 0, sum_xy = 0;
    for (formulae::uint i = 0; i < 1024u; ++i) {
        const Real2 point = formulae::hammersley(i, 1024u);
        ASSERT_GE(point.y, 0.0f);
        ASSERT_LT(point.y, 1.0f);
        sum_x += point.x;
        sum_y += point.y;
        sum_xy += double{point.x} * point.y;
    }
    EXPECT_NEAR(sum_x / 1024, 0.5, 1e-3);
    EXPECT_NEAR(sum_y / 1024, 0.5, 1e-3);
    EXPECT_NEAR(sum_xy / 1024, 0.25, 2e-3);
    EXPECT_EQ(formulae::hammersley(1u, 4u).y, 0.5f);
    EXPECT_EQ(formulae::hammersley(3u, 4u).y, 0.75f);
}

}  // namespace
}  // namespace patina
