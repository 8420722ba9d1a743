// SPDX-License-Identifier: MIT
#include "io/image_file.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <span>

#include "core/formulae/formulae.h"
#include "io/image_codecs.h"
#include "io/png_writer.h"

namespace patina::io {
namespace {

Result<Bytes> encode_by_codecs(const Image& image, const CodecEncoding& encoding) {
    const auto codecs = image_codecs();
    if (!codecs) return passed_on(codecs);
    return (*codecs)->encode(image, encoding);
}

}  // namespace

std::optional<ImageFormat> image_format_of(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    if (extension == ".tiff") return ImageFormat::Tiff;
    if (extension == ".jpeg") return ImageFormat::Jpeg;
    return extension.empty() ? std::nullopt
                             : image_format_from_id(std::string_view(extension).substr(1));
}

Result<Bytes> encode_image(const Image& image, ImageFormat format, const ImageEncoding& encoding,
                           const Progress& progress) {
    switch (format) {
        case ImageFormat::Png:
            return encode_png(image, {.level = encoding.png_level}, progress);
        case ImageFormat::Tiff:
        case ImageFormat::Exr:
            return encode_by_codecs(
                image, {.format = format,
                        .half = format == ImageFormat::Exr && image.type != SampleType::F32});
        case ImageFormat::Jpeg:
            if (image.type != SampleType::U8 || image.channels % 2 == 0)
                return failure("jpg holds 8 bits of grey or three colours and no alpha");
            return encode_by_codecs(image,
                                    {.format = format, .jpeg_quality = encoding.jpeg_quality});
    }
    return failure("unknown image format");
}

Result<Bytes> encode_half_exr(const Image& image) {
    if (image.type != SampleType::F32) return encode_image(image, ImageFormat::Exr);
    Image held = image;
    auto* const numbers = reinterpret_cast<float*>(held.data.data());
    for (std::size_t i = 0; i < held.data.size() / sizeof(float); ++i)
        numbers[i] = std::clamp(numbers[i], -formulae::LARGEST_HALF, formulae::LARGEST_HALF);
    return encode_by_codecs(held, {.format = ImageFormat::Exr, .half = true});
}

Status write_image_file(const std::filesystem::path& path, const Image& image,
                        const Progress& progress) {
    const auto format = image_format_of(path);
    if (!format)
        return failure("{}: the extension names no image format; use .png, .tif, .exr or .jpg",
                       quoted_for_message(path.string()));
    const Result<Bytes> bytes = encode_image(image, *format, {}, progress);
    if (!bytes) return failure("{}: {}", quoted_for_message(path.string()), bytes.error().message);
    return write_file_atomically(path, *bytes);
}

}  // namespace patina::io
