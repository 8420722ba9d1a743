// SPDX-License-Identifier: MIT
#include "core/stored_values.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/formulae/formulae.h"

namespace patina {
namespace {

TEST(StoredValues, TheLeastIsZeroAndTheGreatestOne) {
    EXPECT_EQ(unit_value(std::uint8_t{0}), 0.0f);
    EXPECT_EQ(unit_value(std::numeric_limits<std::uint8_t>::max()), 1.0f);
    EXPECT_EQ(unit_value(std::numeric_limits<std::uint16_t>::max()), 1.0f);
}

TEST(StoredValues, EncodingTheLightOfAByteReturnsIt) {
    for (int byte = 0; byte < 256; ++byte) {
        const float light = linear_of_bytes()[static_cast<std::size_t>(byte)];
        EXPECT_EQ(static_cast<int>(formulae::srgb_from_linear(light) * 255.0f + 0.5f), byte);
    }
}

}  // namespace
}  // namespace patina
