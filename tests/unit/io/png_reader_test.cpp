// SPDX-License-Identifier: MIT
#include "io/png_reader.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <filesystem>

#include "core/files.h"
#include "io/png_writer.h"
#include "read_by_openimageio.h"

namespace patina::io {
namespace {

TEST(PngReader, ReadsEveryColourTypeDepthAndInterlacingAsLibpngDoes) {
    // Made by a script from the specification: 19 x 13 random pixels, a random filter in each row,
    // the stream in three chunks.
    int files = 0;
    const std::filesystem::path source = PATINA_SOURCE_DIR;
    for (const auto& entry : std::filesystem::directory_iterator(source / "tests/unit/io/png")) {
        const auto encoded = read_file(entry.path());
        ASSERT_TRUE(encoded.has_value()) << encoded.error().message;
        const auto image = decode_png(*encoded);
        ASSERT_TRUE(image.has_value()) << entry.path() << image.error().message;
        const Image expected = read_by_openimageio(*encoded, "png");
        EXPECT_EQ((*image)->channels, expected.channels) << entry.path();
        EXPECT_EQ((*image)->type, expected.type) << entry.path();
        EXPECT_TRUE(**image == expected) << entry.path();
        ++files;
    }
    EXPECT_EQ(files, 52);
}

RC_GTEST_PROP(PngReader, ReadsBackWhatTheWriterWrote, ()) {
    Image image;
    image.width = *rc::gen::inRange(1, 70);
    image.height = *rc::gen::inRange(1, 70);
    image.channels = *rc::gen::inRange(1, 5);
    image.type = *rc::gen::element(SampleType::U8, SampleType::U16);
    image.data.resize(image.row_bytes() * static_cast<std::size_t>(image.height));
    const auto seed = *rc::gen::arbitrary<std::uint32_t>();
    std::uint32_t state = seed | 1u;
    for (std::byte& byte : image.data) {
        state = state * 1664525u + 1013904223u;
        byte = static_cast<std::byte>(state >> 24);
    }
    const auto encoded = encode_png(image);
    RC_ASSERT(encoded.has_value());
    const auto decoded = decode_png(*encoded);
    RC_ASSERT(decoded.has_value());
    RC_ASSERT(**decoded == image);
}

TEST(PngReader, RefusesEveryTruncationAndSurvivesEveryChangedByte) {
    const std::filesystem::path source = PATINA_SOURCE_DIR;
    const auto encoded = read_file(source / "tests/unit/io/png/rgba-8-interlaced.png");
    ASSERT_TRUE(encoded.has_value()) << encoded.error().message;
    constexpr std::size_t kEnd = 12;  // the IEND chunk may be missing
    for (std::size_t size = 0; size < encoded->size() - kEnd; ++size)
        EXPECT_FALSE(decode_png(std::span(*encoded).first(size)).has_value()) << size;
    for (std::size_t i = 0; i < encoded->size(); ++i) {
        Bytes changed = *encoded;
        changed[i] ^= std::byte{0x10};
        decode_png(changed);  // must not crash; most are refused by their CRC
    }
}

}  // namespace
}  // namespace patina::io
