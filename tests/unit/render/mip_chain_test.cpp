// SPDX-License-Identifier: MIT
#include "render/mip_chain.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

namespace patina::render {
namespace {

Image bytes_image(int width, int height, int channels, const std::vector<std::uint8_t>& values) {
    Image image{
        .width = width, .height = height, .channels = channels, .type = SampleType::U8, .data = {}};
    for (const std::uint8_t value : values) image.data.push_back(std::byte{value});
    return image;
}

TEST(MipChain, GoesDownToOneTexel) {
    const MipChain chain =
        mip_chain(bytes_image(5, 3, 1, std::vector<std::uint8_t>(15, 7)), TexelMeaning::Linear);
    ASSERT_EQ(chain.levels.size(), 3u);
    EXPECT_EQ(chain.levels[1].width, 2);
    EXPECT_EQ(chain.levels[1].height, 1);
    EXPECT_EQ(chain.levels[2].width, 1);
}

TEST(MipChain, GreyFillsRedGreenAndBlueAndMissingAlphaIsOne) {
    const MipChain chain = mip_chain(bytes_image(1, 1, 1, {90}), TexelMeaning::Linear);
    EXPECT_EQ(chain.levels[0].bytes, (std::vector<std::uint8_t>{90, 90, 90, 255}));
}

TEST(MipChain, SrgbIsAveragedInLinearLight) {
    // Half black, half white is 0.5 linear, which sRGB encodes as 188 (IEC 61966-2-1).
    const MipChain chain = mip_chain(bytes_image(2, 1, 1, {0, 255}), TexelMeaning::Srgb);
    EXPECT_EQ(chain.levels[1].bytes[0], 188);
    const MipChain data = mip_chain(bytes_image(2, 1, 1, {0, 255}), TexelMeaning::Linear);
    EXPECT_EQ(data.levels[1].bytes[0], 128);
}

TEST(MipChain, EveryTexelOfAnOddSideIsInTheMean) {
    const MipChain chain = mip_chain(bytes_image(3, 1, 1, {0, 30, 60}), TexelMeaning::Linear);
    EXPECT_EQ(chain.levels[1].bytes[0], 30);
}

TEST(MipChain, BesideNormalsStandsHowMuchTheyVaryWithinATexel) {
    // Two tilts of 45 degrees to either side: their mean is 1 / sqrt(2) long.
    const std::uint8_t low = 37, high = 218;
    const MipChain chain =
        mip_chain(bytes_image(2, 1, 3, {low, 128, high, high, 128, high}), TexelMeaning::Normals);
    EXPECT_EQ(chain.levels[0].bytes[3], 0);
    EXPECT_NEAR(chain.levels[1].bytes[3] / 255.0, std::sqrt(0.5), 0.01);
    // The same again: what varies within a texel is not forgotten in the next level.
    const MipChain twice = mip_chain(
        bytes_image(4, 1, 3, {low, 128, high, high, 128, high, low, 128, high, high, 128, high}),
        TexelMeaning::Normals);
    EXPECT_EQ(twice.levels[2].bytes[3], twice.levels[1].bytes[3]);
    // A plain slope has none, whatever its alpha was.
    const MipChain plain = mip_chain(
        bytes_image(2, 1, 4, {low, 128, high, 200, low, 128, high, 90}), TexelMeaning::Normals);
    EXPECT_EQ(plain.levels[0].bytes[3], 0);
    EXPECT_EQ(plain.levels[1].bytes[3], 0);
}

TEST(MipChain, AnUpdateOfARectangleEqualsAChainMadeAnew) {
    EXPECT_TRUE(rc::check("updated equals rebuilt", [] {
        const int width = *rc::gen::inRange(1, 20);
        const int height = *rc::gen::inRange(1, 20);
        const int channels = *rc::gen::inRange(1, 5);
        const auto count = static_cast<std::size_t>(width * height * channels);
        const auto any_bytes = [&] {
            return *rc::gen::container<std::vector<std::uint8_t>>(
                count, rc::gen::arbitrary<std::uint8_t>());
        };
        const Image before = bytes_image(width, height, channels, any_bytes());
        TexelRect rect;
        rect.x0 = *rc::gen::inRange(0, width);
        rect.x1 = *rc::gen::inRange(rect.x0, width) + 1;
        rect.y0 = *rc::gen::inRange(0, height);
        rect.y1 = *rc::gen::inRange(rect.y0, height) + 1;
        Image after = before;
        const Image other = bytes_image(width, height, channels, any_bytes());
        for (int y = rect.y0; y < rect.y1; ++y)
            for (int i = rect.x0 * channels; i < rect.x1 * channels; ++i) {
                const auto at = static_cast<std::size_t>(y * width * channels + i);
                after.data[at] = other.data[at];
            }
        MipChain updated = mip_chain(before, TexelMeaning::Srgb);
        update_mip_chain(updated, after, rect);
        const MipChain rebuilt = mip_chain(after, TexelMeaning::Srgb);
        for (std::size_t i = 0; i < rebuilt.levels.size(); ++i)
            RC_ASSERT(updated.levels[i].bytes == rebuilt.levels[i].bytes);
    }));
}

}  // namespace
}  // namespace patina::render
