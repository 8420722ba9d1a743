// SPDX-License-Identifier: MIT
#include "io/image_decode.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstring>
#include <exception>
#include <limits>

#include "io/png_reader.h"

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

/// One image being read from memory: the reader must not outlive the bytes.
struct OpenImage {
    std::unique_ptr<OIIO::Filesystem::IOMemReader> bytes;
    std::unique_ptr<OIIO::ImageInput> input;
    ImageHeader header;
};

/// Messages of decoders may hold anything, even several lines: the first one is enough.
std::string first_line(const std::string& text) {
    return quoted_for_message(text.substr(0, text.find('\n')), 160);
}

SampleType sample_type_of(const OIIO::TypeDesc& type) {
    switch (type.basetype) {
        case OIIO::TypeDesc::UINT8:
        case OIIO::TypeDesc::INT8:
            return SampleType::U8;
        case OIIO::TypeDesc::UINT16:
        case OIIO::TypeDesc::INT16:
            return SampleType::U16;
        default:
            return SampleType::F32;
    }
}

OIIO::TypeDesc type_desc_of(SampleType type) {
    switch (type) {
        case SampleType::U8:
            return OIIO::TypeDesc::UINT8;
        case SampleType::U16:
            return OIIO::TypeDesc::UINT16;
        case SampleType::F32:
            return OIIO::TypeDesc::FLOAT;
    }
    return OIIO::TypeDesc::FLOAT;
}

/// What the file says of its colours, else what its numbers imply: floats are light.
ColorSpace color_space_of(const OIIO::ImageSpec& spec) {
    std::string stated = spec.get_string_attribute("oiio:ColorSpace");
    std::transform(stated.begin(), stated.end(), stated.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (stated == "linear" || stated == "scene_linear" || stated == "lin_srgb" ||
        stated == "lin_rec709")
        return ColorSpace::Linear;
    const bool is_float = spec.format.basetype == OIIO::TypeDesc::FLOAT ||
                          spec.format.basetype == OIIO::TypeDesc::HALF ||
                          spec.format.basetype == OIIO::TypeDesc::DOUBLE;
    return is_float && stated.empty() ? ColorSpace::Linear : ColorSpace::Srgb;
}

Result<OpenImage> open_image(ByteSpan encoded, std::string_view name) {
    const std::string_view format = image_format(encoded, name);
    if (format.empty())
        return failure("not an image that Patina reads (PNG, JPEG, WebP, TIFF, EXR, HDR, PSD ...)");
    OpenImage open;
    open.header.format = format;
    // A search path of our own making keeps plug-ins named by the environment out.
    open.input = OIIO::ImageInput::create(open.header.format, false, nullptr, nullptr, "/dev/null");
    if (!open.input) {
        OIIO::geterror();
        return failure("{} images are not supported by this build of OpenImageIO", format);
    }
    open.bytes = std::make_unique<OIIO::Filesystem::IOMemReader>(
        const_cast<std::byte*>(encoded.data()), encoded.size());
    open.input->set_ioproxy(open.bytes.get());
    OIIO::ImageSpec settings;
    settings["oiio:UnassociatedAlpha"] = 1;
    OIIO::ImageSpec spec;
    if (!open.input->open(std::string(name.empty() ? "image" : name), spec, settings))
        return failure("cannot be decoded: {}", first_line(open.input->geterror()));
    if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.nchannels < 1 || spec.deep)
        return failure("is not a flat image");
    open.header.width = spec.width;
    open.header.height = spec.height;
    open.header.channels = std::min(spec.nchannels, 4);
    open.header.type = sample_type_of(spec.format);
    open.header.color_space = color_space_of(spec);
    return open;
}

void make_finite(Image& image) {
    auto* const numbers = reinterpret_cast<float*>(image.data.data());
    constexpr float kLargest = std::numeric_limits<float>::max();
    for (std::size_t i = 0; i < image.data.size() / sizeof(float); ++i) {
        if (std::isnan(numbers[i])) numbers[i] = 0.0f;
        numbers[i] = std::clamp(numbers[i], -kLargest, kLargest);
    }
}

Result<ImagePtr> read_pixels(OpenImage& open) {
    auto image = std::make_shared<Image>();
    image->width = open.header.width;
    image->height = open.header.height;
    image->channels = open.header.channels;
    image->type = open.header.type;
    image->data.resize(open.header.decoded_bytes());
    if (!open.input->read_image(0, 0, 0, image->channels, type_desc_of(image->type),
                                image->data.data()))
        return failure("cannot be decoded: {}", first_line(open.input->geterror()));
    if (image->type == SampleType::F32) make_finite(*image);
    return image;
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

Result<ImagePtr> decode_png_within(ByteSpan encoded, const ImageLimits& limits) {
    const auto header = read_png_header(encoded);
    if (!header) return passed_on(header);
    if (const auto fits = check_image_size(*header, limits); !fits) return passed_on(fits);
    return decode_png(encoded);
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

Result<ImageHeader> read_image_header(ByteSpan encoded, std::string_view name) try {
    if (is_png(encoded)) {
        auto header = read_png_header(encoded);
        if (header) header->color_space = color_space_of_png(encoded);
        return header;
    }
    const auto open = open_image(encoded, name);
    if (!open) return passed_on(open);
    return open->header;
} catch (const std::exception& error) {
    return failure("cannot be decoded: {}", first_line(error.what()));
}

Result<ImagePtr> decode_image(ByteSpan encoded, std::string_view name,
                              const ImageLimits& limits) try {
    if (is_png(encoded)) return decode_png_within(encoded, limits);
    auto open = open_image(encoded, name);
    if (!open) return passed_on(open);
    if (const auto fits = check_image_size(open->header, limits); !fits) return passed_on(fits);
    return read_pixels(*open);
} catch (const std::exception& error) {
    return failure("cannot be decoded: {}", first_line(error.what()));
}

}  // namespace patina::io
