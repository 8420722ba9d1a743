// SPDX-License-Identifier: MIT
#include "io/tiff_reader.h"

#include <gtest/gtest.h>
#include <tiffio.h>

#include "core/files.h"
#include "read_by_openimageio.h"
#include "temporary_folder.h"

namespace patina::io {
namespace {

constexpr std::uint16_t kGrey = PHOTOMETRIC_MINISBLACK;
constexpr std::uint16_t kRgb = PHOTOMETRIC_RGB;

struct TiffFile {
    const char* mode = "w";  ///< "wb": most significant byte first
    int channels = 3;
    int bits = 8;
    std::uint32_t rows_per_strip = 4;
    std::uint16_t compression = COMPRESSION_NONE;
    std::uint16_t photometric = PHOTOMETRIC_RGB;
    std::uint16_t extra = EXTRASAMPLE_UNASSALPHA;  ///< what a second or fourth channel is
    std::uint16_t sample_format = SAMPLEFORMAT_UINT;
};

constexpr std::uint32_t kWidth = 23;
constexpr std::uint32_t kHeight = 11;

class TiffReader : public testing::Test {
  protected:
    /// The bytes of a file in which every number differs from its neighbours.
    Bytes written(const TiffFile& wanted) {
        const auto path = folder_.path() / "a.tif";
        TIFF* const file = TIFFOpen(path.c_str(), wanted.mode);
        TIFFSetField(file, TIFFTAG_IMAGEWIDTH, kWidth);
        TIFFSetField(file, TIFFTAG_IMAGELENGTH, kHeight);
        TIFFSetField(file, TIFFTAG_SAMPLESPERPIXEL, wanted.channels);
        TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, wanted.bits);
        TIFFSetField(file, TIFFTAG_SAMPLEFORMAT, wanted.sample_format);
        TIFFSetField(file, TIFFTAG_ROWSPERSTRIP, wanted.rows_per_strip);
        TIFFSetField(file, TIFFTAG_COMPRESSION, wanted.compression);
        TIFFSetField(file, TIFFTAG_PHOTOMETRIC, wanted.photometric);
        TIFFSetField(file, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
        if (wanted.channels % 2 == 0) TIFFSetField(file, TIFFTAG_EXTRASAMPLES, 1, &wanted.extra);
        std::vector<std::uint8_t> row(static_cast<std::size_t>(TIFFScanlineSize(file)));
        for (std::uint32_t y = 0; y < kHeight; ++y) {
            for (std::size_t i = 0; i < row.size(); ++i)
                row[i] = static_cast<std::uint8_t>(i * 7 + y * 31);
            TIFFWriteScanline(file, row.data(), y);
        }
        TIFFClose(file);
        return read_file(path).value();
    }

    TemporaryFolder folder_;
};

TEST_F(TiffReader, ReadsPlainFilesAsOpenImageIODoes) {
    std::vector<TiffFile> files;
    for (const char* mode : {"wl", "wb"})
        for (const int bits : {8, 16})
            for (const int channels : {1, 2, 3, 4})
                for (const std::uint32_t rows : {1u, 4u, 11u, 4096u})
                    for (const std::uint16_t extra : std::initializer_list<std::uint16_t>{
                             EXTRASAMPLE_UNASSALPHA, EXTRASAMPLE_ASSOCALPHA})
                        files.push_back({.mode = mode,
                                         .channels = channels,
                                         .bits = bits,
                                         .rows_per_strip = rows,
                                         .photometric = channels < 3 ? kGrey : kRgb,
                                         .extra = extra});
    for (const TiffFile& file : files) {
        SCOPED_TRACE(fmt::format("{}, {} bits, {} channels, {} rows a strip", file.mode, file.bits,
                                 file.channels, file.rows_per_strip));
        const Bytes encoded = written(file);
        const auto open = open_plain_tiff(encoded);
        ASSERT_NE(open, nullptr);
        const auto image = open->pixels();
        ASSERT_TRUE(image) << image.error().message;
        EXPECT_TRUE(**image == read_by_openimageio(encoded, "tiff"));
        const auto of_file = open_plain_tiff(folder_.path() / "a.tif");
        ASSERT_NE(of_file, nullptr);
        const auto same = of_file->pixels();
        ASSERT_TRUE(same) << same.error().message;
        EXPECT_TRUE(**same == **image);
        const auto other = (*image_codecs())->open(encoded, "a", "tiff");
        EXPECT_EQ(open->header().color_space, (*other)->header().color_space);
    }
}

TEST_F(TiffReader, LeavesAllOthersToOpenImageIO) {
    const auto is_left = [&](const TiffFile& file) {
        const Bytes encoded = written(file);
        return open_plain_tiff(encoded) == nullptr &&
               open_plain_tiff(folder_.path() / "a.tif") == nullptr &&
               decode_image(encoded, "a.tif").has_value();
    };
    EXPECT_FALSE(is_left({}));
    EXPECT_TRUE(is_left({.compression = COMPRESSION_LZW}));
    EXPECT_TRUE(is_left({.channels = 1, .photometric = PHOTOMETRIC_MINISWHITE}));
    EXPECT_TRUE(is_left({.bits = 32, .sample_format = SAMPLEFORMAT_IEEEFP}));
    EXPECT_TRUE(is_left({.channels = 1, .bits = 1, .photometric = PHOTOMETRIC_MINISBLACK}));
    EXPECT_TRUE(is_left({.sample_format = SAMPLEFORMAT_INT}));
}

TEST_F(TiffReader, DecodesNoFileWhoseEndIsMissing) {
    const Bytes whole = written({});
    for (std::size_t size = 0; size < whole.size(); size += 13) {
        const auto part = std::span(whole).first(size);
        const auto open = open_plain_tiff(part);
        EXPECT_TRUE(open == nullptr || !open->pixels()) << size;
        EXPECT_FALSE(decode_image(part, "a.tif")) << size;
        const auto path = folder_.path() / "part.tif";
        ASSERT_TRUE(write_file_atomically(path, part));
        const auto of_file = open_plain_tiff(path);
        EXPECT_TRUE(of_file == nullptr || !of_file->pixels()) << size;
    }
}

TEST_F(TiffReader, OpensNoFolderAndNothingThatIsNotThere) {
    EXPECT_EQ(open_plain_tiff(folder_.path()), nullptr);
    EXPECT_EQ(open_plain_tiff(folder_.path() / "none.tif"), nullptr);
}

}  // namespace
}  // namespace patina::io
