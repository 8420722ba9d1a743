// SPDX-License-Identifier: MIT
#include "io/image_file.h"

#include <gtest/gtest.h>

#include <cstring>

#include "read_by_openimageio.h"

namespace patina::io {
namespace {

Image gradient(int channels, SampleType type) {
    Image image;
    image.width = 33;
    image.height = 17;
    image.channels = channels;
    image.type = type;
    image.data.resize(image.row_bytes() * 17);
    const std::size_t count = image.data.size() / sample_bytes(type);
    for (std::size_t i = 0; i < count; ++i) {
        const auto number = static_cast<float>(i) * 0.75f - 20.0f;
        const auto bits = static_cast<std::uint16_t>(i * 257);
        const auto byte = static_cast<std::uint8_t>(i);
        std::byte* at = image.data.data() + i * sample_bytes(type);
        if (type == SampleType::F32)
            std::memcpy(at, &number, sizeof number);
        else if (type == SampleType::U16)
            std::memcpy(at, &bits, sizeof bits);
        else
            std::memcpy(at, &byte, sizeof byte);
    }
    return image;
}

TEST(ImageFile, TiffAndExrGiveBackTheNumbersThatWentIn) {
    for (const int channels : {1, 3, 4}) {
        for (const SampleType type : {SampleType::U8, SampleType::U16, SampleType::F32}) {
            const Image image = gradient(channels, type);
            const auto tiff = encode_image(image, ImageFormat::Tiff);
            ASSERT_TRUE(tiff) << tiff.error().message;
            EXPECT_TRUE(read_by_openimageio(*tiff, "tiff") == image)
                << channels << " channels of type " << static_cast<int>(type);
        }
        const Image floats = gradient(channels, SampleType::F32);
        const auto exr = encode_image(floats, ImageFormat::Exr);
        ASSERT_TRUE(exr) << exr.error().message;
        EXPECT_TRUE(read_by_openimageio(*exr, "openexr") == floats);
    }
}

TEST(ImageFile, SaysNothingOfTheTimeAtWhichItWasWritten) {
    const Image image = gradient(4, SampleType::F32);
    for (const ImageFormat format : {ImageFormat::Tiff, ImageFormat::Exr}) {
        const Bytes bytes = encode_image(image, format).value();
        const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        EXPECT_NE(text.find("1970"), std::string_view::npos);
        EXPECT_EQ(text.find("OpenImageIO"), std::string_view::npos);
    }
}

TEST(ImageFile, JpegIsCloseToTheNumbersByItsQualityAndTakesNoAlpha) {
    for (const int channels : {1, 3}) {
        const Image image = gradient(channels, SampleType::U8);
        const auto fine = encode_image(image, ImageFormat::Jpeg, {.jpeg_quality = 100});
        ASSERT_TRUE(fine) << fine.error().message;
        const Image read = read_by_openimageio(*fine, "jpeg");
        ASSERT_EQ(read.channels, channels);
        for (std::size_t i = 0; i < image.data.size(); ++i)
            ASSERT_NEAR(static_cast<int>(read.data[i]), static_cast<int>(image.data[i]), 6);
        EXPECT_LT(encode_image(image, ImageFormat::Jpeg, {.jpeg_quality = 10})->size(),
                  fine->size());
    }
    EXPECT_FALSE(encode_image(gradient(4, SampleType::U8), ImageFormat::Jpeg));
    EXPECT_FALSE(encode_image(gradient(3, SampleType::U16), ImageFormat::Jpeg));
}

TEST(ImageFile, TheExtensionNamesTheFormat) {
    EXPECT_EQ(image_format_of("a.PNG"), ImageFormat::Png);
    EXPECT_EQ(image_format_of("a.tiff"), ImageFormat::Tiff);
    EXPECT_EQ(image_format_of("b.c.exr"), ImageFormat::Exr);
    EXPECT_EQ(image_format_of("a.jpg"), ImageFormat::Jpeg);
    EXPECT_EQ(image_format_of("a.jpeg"), ImageFormat::Jpeg);
    EXPECT_FALSE(image_format_of("a.webp"));
    EXPECT_FALSE(image_format_of("png"));
    const auto status = write_image_file("a.webp", gradient(3, SampleType::U8));
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().message,
              "a.webp: the extension names no image format; use .png, .tif, .exr or .jpg");
}

}  // namespace
}  // namespace patina::io
