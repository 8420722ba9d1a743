// SPDX-License-Identifier: MIT
#include "io/image_decode.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "io/image_codecs.h"
#include "io/png_reader.h"
#include "io/tiff_reader.h"

namespace patina::io {
namespace {

using ByteSpan = std::span<const std::byte>;

struct Format {
    std::string_view name;  ///< of OpenImageIO
    std::string_view mime_type;
    std::string_view extensions;  ///< each with a space after it
    std::size_t magic_offset;
    std::string_view magic;  ///< empty: told by the extension
};
using namespace std::string_view_literals;
constexpr std::array kFormats = std::to_array<Format>({
    {"png", "image/png", "png ", 0, "\x89PNG\r\n\x1a\n"sv},
    {"jpeg", "image/jpeg", "jpg jpeg ", 0, "\xff\xd8\xff"sv},
    {"openexr", "image/x-exr", "exr ", 0, "\x76\x2f\x31\x01"sv},
    {"hdr", "image/vnd.radiance", "hdr rgbe ", 0, "#?"sv},
    {"tiff", "image/tiff", "tif tiff ", 0, "II\x2a\0"sv},
    {"tiff", "image/tiff", "", 0, "MM\0\x2a"sv},
    {"tiff", "image/tiff", "", 0, "II\x2b\0"sv},
    {"webp", "image/webp", "webp ", 8, "WEBP"sv},
    {"psd", "image/vnd.adobe.photoshop", "psd psb ", 0, "8BPS"sv},
    {"gif", "image/gif", "gif ", 0, "GIF8"sv},
    {"bmp", "image/bmp", "bmp ", 0, "BM"sv},
    {"dds", "image/vnd-ms.dds", "dds ", 0, "DDS "sv},
    {"jpeg2000", "image/jp2", "jp2 j2k ", 0, "\0\0\0\x0cjP  "sv},
    {"pnm", "image/x-portable-anymap", "pgm ppm pbm pnm ", 0, ""sv},
    {"targa", "image/x-tga", "tga ", 0, ""sv},
});

bool has_magic(const Format& format, ByteSpan encoded) {
    if (format.magic.empty() || encoded.size() < format.magic_offset + format.magic.size())
        return false;
    return std::memcmp(encoded.data() + format.magic_offset, format.magic.data(),
                       format.magic.size()) == 0;
}

std::string lower_extension(std::string_view name) {
    const auto dot = name.rfind('.');
    std::string extension(dot == std::string_view::npos ? "" : name.substr(dot + 1));
    std::transform(extension.begin(), extension.end(), extension.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return extension;
}

bool is_png(ByteSpan encoded) {
    return has_magic(kFormats.front(), encoded);
}

/// A gAMA chunk of 1 and no sRGB chunk that overrules it. PNG, sections 11.3.3.2 and 11.3.3.5.
ColorSpace color_space_of_png(ByteSpan encoded) {
    const auto word = [&](std::size_t at) {
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < 4; ++i)
            value = value << 8 | static_cast<std::uint32_t>(encoded[at + i]);
        return value;
    };
    bool linear = false;
    for (std::size_t at = 8; at + 12 <= encoded.size();) {
        const std::uint32_t length = word(at);
        const std::string_view type(reinterpret_cast<const char*>(encoded.data()) + at + 4, 4);
        if (type == "IDAT" || length > encoded.size() - at - 12) break;
        if (type == "sRGB") return ColorSpace::Srgb;
        if (type == "gAMA" && length == 4) linear = word(at + 8) == 100000;
        at += std::size_t{12} + length;
    }
    return linear ? ColorSpace::Linear : ColorSpace::Srgb;
}

class PngInMemory final : public OpenedImage {
  public:
    PngInMemory(ByteSpan encoded, ImageHeader header)
        : encoded_(encoded), header_(std::move(header)) {}
    const ImageHeader& header() const override { return header_; }
    Result<ImagePtr> pixels() override { return decode_png(encoded_); }

  private:
    ByteSpan encoded_;
    ImageHeader header_;
};

Result<std::unique_ptr<OpenedImage>> open_png(ByteSpan encoded) {
    auto header = read_png_header(encoded);
    if (!header) return passed_on(header);
    header->color_space = color_space_of_png(encoded);
    return std::make_unique<PngInMemory>(encoded, std::move(*header));
}

}  // namespace

std::string_view image_format(ByteSpan encoded, std::string_view name) {
    for (const Format& format : kFormats)
        if (has_magic(format, encoded)) return format.name;
    const std::string extension = lower_extension(name) + ' ';
    for (const Format& format : kFormats)
        if (format.magic.empty() && extension.size() > 1 &&
            format.extensions.find(extension) != std::string_view::npos)
            return format.name;
    return {};
}

bool has_image_extension(std::string_view name) {
    const std::string extension = lower_extension(name) + ' ';
    return extension.size() > 1 &&
           std::any_of(kFormats.begin(), kFormats.end(), [&](const Format& format) {
               const std::size_t at = format.extensions.find(extension);
               return at != std::string_view::npos && (at == 0 || format.extensions[at - 1] == ' ');
           });
}

std::string_view mime_type_of_format(std::string_view name) {
    for (const Format& format : kFormats)
        if (format.name == name) return format.mime_type;
    return {};
}

Status check_image_size(const ImageHeader& header, const ImageLimits& limits) {
    if (header.width > limits.max_side || header.height > limits.max_side)
        return failure("{} x {} pixels, more than the limit of {} a side; scale it down",
                       header.width, header.height, limits.max_side);
    if (header.decoded_bytes() > limits.max_decoded_bytes)
        return failure("{} MiB when decoded, more than the limit of {}; scale it down",
                       header.decoded_bytes() >> 20, limits.max_decoded_bytes >> 20);
    return {};
}

Result<std::unique_ptr<OpenedImage>> open_image(ByteSpan encoded, std::string_view name) {
    if (is_png(encoded)) return open_png(encoded);
    const std::string_view format = image_format(encoded, name);
    if (format.empty())
        return failure("not an image that Patina reads (PNG, JPEG, WebP, TIFF, EXR, HDR, PSD ...)");
    if (format == "tiff")
        if (auto plain = open_plain_tiff(encoded)) return plain;
    const auto codecs = image_codecs();
    if (!codecs) return passed_on(codecs);
    return (*codecs)->open(encoded, name, format);
}

Result<ImageHeader> read_image_header(ByteSpan encoded, std::string_view name) {
    const auto open = open_image(encoded, name);
    if (!open) return passed_on(open);
    return (*open)->header();
}

Result<ImagePtr> decode_image(ByteSpan encoded, std::string_view name, const ImageLimits& limits) {
    const auto open = open_image(encoded, name);
    if (!open) return passed_on(open);
    if (const auto fits = check_image_size((*open)->header(), limits); !fits)
        return passed_on(fits);
    return (*open)->pixels();
}

}  // namespace patina::io
