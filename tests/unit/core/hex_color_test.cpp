// SPDX-License-Identifier: MIT
#include "core/hex_color.h"

#include <gtest/gtest.h>

namespace patina {
namespace {

using Rgb = std::array<std::uint8_t, 3>;

TEST(HexColor, SixDigitsAreBytesAndThreeCountTwice) {
    EXPECT_EQ(rgb_from_hex("8a3B12"), (Rgb{0x8a, 0x3b, 0x12}));
    EXPECT_EQ(rgb_from_hex("f08"), (Rgb{0xff, 0x00, 0x88}));
    EXPECT_EQ(rgb_from_html("#8a3b12"), (Rgb{0x8a, 0x3b, 0x12}));
}

TEST(HexColor, AnyOtherTextIsRefused) {
    for (const char* text : {"", "8a3b1", "8a3b123", "8a3b1g", "+a3b12", "-a3b12", " a3b12"})
        EXPECT_FALSE(rgb_from_hex(text)) << text;
    for (const char* text : {"", "#", "8a3b12", "#fff", "#8a3b1", "##a3b12"})
        EXPECT_FALSE(rgb_from_html(text)) << text;
}

}  // namespace
}  // namespace patina
