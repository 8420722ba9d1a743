// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "core/formulae/formulae.h"

namespace patina {
namespace {

/// The noise of 3 x 3 pixels, in ascending order.
std::array<float, 9> noise_around(int left, int low) {
    std::array<float, 9> values = {};
    for (int i = 0; i < 9; ++i)
        values[static_cast<std::size_t>(i)] = formulae::interleaved_gradient_noise(
            {static_cast<float>(left + i % 3), static_cast<float>(low + i / 3)});
    std::sort(values.begin(), values.end());
    return values;
}

TEST(Dither, AmongAnyNineNeighboursTheNoiseIsEvenlySpread) {
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 128; ++x) {
            const std::array<float, 9> values = noise_around(x, y);
            ASSERT_GE(values.front(), 0.0f);
            ASSERT_LT(values.back(), 1.0f);
            for (std::size_t i = 1; i < values.size(); ++i)
                ASSERT_LT(values[i] - values[i - 1], 0.14f) << x << ", " << y;
        }
}

}  // namespace
}  // namespace patina
