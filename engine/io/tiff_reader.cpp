// SPDX-License-Identifier: MIT
#include "io/tiff_reader.h"

#include <tiffio.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <optional>

#include "core/files.h"

namespace patina::io {
namespace {

/// What libtiff's callbacks work on: bytes in memory, or a file.
struct Source {
    std::span<const std::byte> bytes;
    std::optional<OpenedFile> file;
    std::uint64_t at = 0;
    std::string fault;  ///< the first thing that libtiff had to say

    std::uint64_t size() const { return file ? file->size() : bytes.size(); }
    bool read(std::span<std::byte> to) const {
        if (file) return file->read(at, to).has_value();
        std::memcpy(to.data(), bytes.data() + at, to.size());
        return true;
    }
};

Source& source_of(thandle_t handle) {
    return *static_cast<Source*>(handle);
}

tmsize_t read_bytes(thandle_t handle, void* to, tmsize_t size) {
    Source& source = source_of(handle);
    const std::uint64_t left = source.at < source.size() ? source.size() - source.at : 0;
    const auto count = std::min(static_cast<std::uint64_t>(std::max<tmsize_t>(size, 0)), left);
    if (count > 0 && !source.read({static_cast<std::byte*>(to), count})) return -1;
    source.at += count;
    return static_cast<tmsize_t>(count);
}

tmsize_t write_nothing(thandle_t, void*, tmsize_t) {
    return 0;
}

toff_t seek(thandle_t handle, toff_t offset, int from) {
    Source& source = source_of(handle);
    if (from == SEEK_SET) source.at = offset;
    if (from == SEEK_CUR) source.at += offset;
    if (from == SEEK_END) source.at = source.size() + offset;
    return source.at;
}

int close_nothing(thandle_t) {
    return 0;
}

toff_t size_of(thandle_t handle) {
    return source_of(handle).size();
}

/// Strips are copied from here, without a buffer between.
int map(thandle_t handle, void** base, toff_t* size) {
    const Source& source = source_of(handle);
    if (source.file) return 0;
    *base = const_cast<std::byte*>(source.bytes.data());
    *size = source.bytes.size();
    return 1;
}

void unmap(thandle_t, void*, toff_t) {}

int keep_fault(TIFF*, void* user, const char*, const char* format, va_list arguments) {
    Source& source = source_of(user);
    char text[256] = {};
    std::vsnprintf(text, sizeof text, format, arguments);
    if (source.fault.empty()) source.fault = text;
    return 1;
}

int keep_quiet(TIFF*, void*, const char*, const char*, va_list) {
    return 1;
}

struct CloseTiff {
    void operator()(TIFF* file) const { TIFFClose(file); }
};
using OpenTiff = std::unique_ptr<TIFF, CloseTiff>;

OpenTiff open_tiff(Source& source) {
    TIFFOpenOptions* const options = TIFFOpenOptionsAlloc();
    TIFFOpenOptionsSetErrorHandlerExtR(options, keep_fault, &source);
    TIFFOpenOptionsSetWarningHandlerExtR(options, keep_quiet, &source);
    OpenTiff file(TIFFClientOpenExt("image", "r", &source, read_bytes, write_nothing, seek,
                                    close_nothing, size_of, map, unmap, options));
    TIFFOpenOptionsFree(options);
    return file;
}

std::uint16_t small_field(TIFF* file, std::uint32_t tag) {
    std::uint16_t value = 0;
    TIFFGetFieldDefaulted(file, tag, &value);
    return value;
}

std::uint32_t large_field(TIFF* file, std::uint32_t tag) {
    std::uint32_t value = 0;
    TIFFGetFieldDefaulted(file, tag, &value);
    return value;
}

bool is_plain(TIFF* file) {
    const std::uint16_t channels = small_field(file, TIFFTAG_SAMPLESPERPIXEL);
    const std::uint16_t bits = small_field(file, TIFFTAG_BITSPERSAMPLE);
    std::uint16_t photometric = 0;
    if (TIFFGetField(file, TIFFTAG_PHOTOMETRIC, &photometric) == 0) return false;
    const bool grey = photometric == PHOTOMETRIC_MINISBLACK && (channels == 1 || channels == 2);
    const bool rgb = photometric == PHOTOMETRIC_RGB && (channels == 3 || channels == 4);
    return (grey || rgb) && (bits == 8 || bits == 16) && TIFFIsTiled(file) == 0 &&
           small_field(file, TIFFTAG_SAMPLEFORMAT) == SAMPLEFORMAT_UINT &&
           small_field(file, TIFFTAG_PLANARCONFIG) == PLANARCONFIG_CONTIG &&
           small_field(file, TIFFTAG_COMPRESSION) == COMPRESSION_NONE &&
           small_field(file, TIFFTAG_FILLORDER) == FILLORDER_MSB2LSB;
}

class PlainTiff final : public OpenedImage {
  public:
    explicit PlainTiff(std::span<const std::byte> encoded) { source_.bytes = encoded; }
    explicit PlainTiff(OpenedFile file) { source_.file = std::move(file); }

    /// Whether it is one of those that are read here.
    bool open() {
        file_ = open_tiff(source_);
        if (!file_ || !is_plain(file_.get())) return false;
        const std::uint32_t width = large_field(file_.get(), TIFFTAG_IMAGEWIDTH);
        const std::uint32_t height = large_field(file_.get(), TIFFTAG_IMAGELENGTH);
        constexpr std::uint32_t kMost = 1u << 30;
        if (width < 1 || width > kMost || height < 1 || height > kMost) return false;
        header_ = {.width = static_cast<int>(width),
                   .height = static_cast<int>(height),
                   .channels = small_field(file_.get(), TIFFTAG_SAMPLESPERPIXEL),
                   .type = small_field(file_.get(), TIFFTAG_BITSPERSAMPLE) == 8 ? SampleType::U8
                                                                                : SampleType::U16,
                   .format = "tiff"};
        return header_.decoded_bytes() <= source_.size();
    }

    const ImageHeader& header() const override { return header_; }

    Result<ImagePtr> pixels() override {
        auto image = std::make_shared<Image>(Image{.width = header_.width,
                                                   .height = header_.height,
                                                   .channels = header_.channels,
                                                   .type = header_.type});
        image->data.resize(header_.decoded_bytes());
        const auto rows = std::min<std::size_t>(large_field(file_.get(), TIFFTAG_ROWSPERSTRIP),
                                                static_cast<std::size_t>(image->height));
        const std::size_t strip_bytes = rows * image->row_bytes();
        std::uint32_t strip = 0;
        for (std::size_t at = 0; at < image->data.size(); at += strip_bytes, ++strip) {
            const auto wanted =
                static_cast<tmsize_t>(std::min(strip_bytes, image->data.size() - at));
            if (TIFFReadEncodedStrip(file_.get(), strip, image->data.data() + at, wanted) != wanted)
                return failure("cannot be decoded: {}",
                               source_.fault.empty() ? "its end is missing"
                                                     : quoted_for_message(source_.fault, 160));
        }
        return image;
    }

  private:
    Source source_;
    OpenTiff file_;  // reads source_ and goes first
    ImageHeader header_;
};

bool is_tiff(const OpenedFile& file) {
    std::array<std::byte, 4> start{};
    return file.size() >= start.size() && file.read(0, start) && image_format(start, {}) == "tiff";
}

}  // namespace

std::unique_ptr<OpenedImage> open_plain_tiff(std::span<const std::byte> encoded) {
    auto image = std::make_unique<PlainTiff>(encoded);
    if (!image->open()) return nullptr;
    return image;
}

std::unique_ptr<OpenedImage> open_plain_tiff(const std::filesystem::path& path) {
    Result<OpenedFile> file = OpenedFile::open(path);
    if (!file || !is_tiff(*file)) return nullptr;
    auto image = std::make_unique<PlainTiff>(std::move(*file));
    if (!image->open()) return nullptr;
    return image;
}

}  // namespace patina::io
