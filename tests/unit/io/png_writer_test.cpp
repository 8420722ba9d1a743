// SPDX-License-Identifier: MIT
#include "io/png_writer.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "core/parallel.h"
#include "read_by_openimageio.h"

namespace patina::io {
namespace {

enum class Content { Random, Smooth, Flat };

Image image_of(int width, int height, int channels, SampleType type, Content content) {
    Image image{.width = width, .height = height, .channels = channels, .type = type, .data = {}};
    image.data.resize(image.row_bytes() * static_cast<std::size_t>(height));
    std::mt19937 random(static_cast<unsigned>(width * 1000 + height));
    for (std::size_t i = 0; i < image.data.size(); ++i) {
        const std::size_t y = i / image.row_bytes(), x = i % image.row_bytes();
        image.data[i] =
            static_cast<std::byte>(content == Content::Random   ? random() & 255u
                                   : content == Content::Smooth ? (x * 3 + y * 5) / 4 & 255u
                                                                : 200u);
    }
    return image;
}

std::uint32_t crc32_by_definition(std::span<const std::byte> bytes) {
    std::uint32_t crc = 0xffffffffu;
    for (const std::byte byte : bytes) {
        crc ^= static_cast<std::uint32_t>(byte);
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (0xedb88320u & (0u - (crc & 1u)));
    }
    return ~crc;
}

std::uint32_t u32_at(const Bytes& png, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value = value << 8 | static_cast<std::uint32_t>(png[at + i]);
    return value;
}

/// The types of the chunks in order; a wrong length or CRC is a failure.
std::vector<std::string> checked_chunks(const Bytes& png) {
    std::vector<std::string> types;
    for (std::size_t at = 8; at < png.size();) {
        const std::size_t length = u32_at(png, at);
        if (at + 12 + length > png.size()) {
            ADD_FAILURE() << "a chunk passes the end of the file";
            return types;
        }
        const std::span typed(png.data() + at + 4, length + 4);
        types.emplace_back(reinterpret_cast<const char*>(typed.data()), 4);
        EXPECT_EQ(u32_at(png, at + 8 + length), crc32_by_definition(typed));
        at += 12 + length;
    }
    return types;
}

TEST(PngWriter, EverySizeUpTo40DecodesToTheSamePixels) {
    for (int width = 1; width <= 40; ++width)
        for (int height = 1; height <= 40; ++height) {
            const int channels = 1 + (width + height) % 4;
            const auto type = (width + 2 * height) % 3 == 0 ? SampleType::U16 : SampleType::U8;
            const auto content = height % 2 == 0 ? Content::Random : Content::Smooth;
            const Image image = image_of(width, height, channels, type, content);
            const auto png = encode_png(image);
            ASSERT_TRUE(png) << png.error().message;
            ASSERT_EQ(read_by_openimageio(*png, "png"), image)
                << width << " x " << height << " x " << channels;
        }
}

TEST(PngWriter, EveryLevelLayoutAndContentOfManyStripsDecodesToTheSamePixels) {
    for (const SampleType type : {SampleType::U8, SampleType::U16})
        for (const Content content : {Content::Random, Content::Smooth, Content::Flat})
            for (int level = 1; level <= 3; ++level) {
                const Image image = image_of(1031, 777, 1 + level, type, content);
                const auto png = encode_png(image, {.level = level});
                ASSERT_TRUE(png) << png.error().message;
                EXPECT_TRUE(read_by_openimageio(*png, "png") == image) << "level " << level;
            }
}

TEST(PngWriter, TheFileIsAHeaderThenDataThenAnEndWithGoodChecksums) {
    const auto png = encode_png(image_of(1024, 1024, 3, SampleType::U8, Content::Random)).value();
    const auto types = checked_chunks(png);
    ASSERT_GE(types.size(), 5u) << "3 MiB are several strips";
    EXPECT_EQ(types.front(), "IHDR");
    EXPECT_EQ(types.back(), "IEND");
    for (std::size_t i = 1; i + 1 < types.size(); ++i) EXPECT_EQ(types[i], "IDAT");
}

TEST(PngWriter, OneThreadAndManyGiveTheSameBytes) {
    const Image image = image_of(1500, 1500, 4, SampleType::U8, Content::Smooth);
    const auto many = encode_png(image).value();
    const ThreadLimit one(1);
    EXPECT_EQ(encode_png(image).value(), many);
}

TEST(PngWriter, RefusesWhatPngCannotHold) {
    EXPECT_FALSE(encode_png(image_of(4, 4, 3, SampleType::F32, Content::Flat)));
    Image image = image_of(4, 4, 3, SampleType::U8, Content::Flat);
    image.data.pop_back();
    EXPECT_FALSE(encode_png(image));
    EXPECT_FALSE(encode_png(Image{}));
    const Progress cancelled;
    cancelled.cancel();
    const auto result = encode_png(image_of(4, 4, 3, SampleType::U8, Content::Flat), {}, cancelled);
    ASSERT_FALSE(result);
    EXPECT_NE(result.error().message.find("cancelled"), std::string::npos);
}

}  // namespace
}  // namespace patina::io
