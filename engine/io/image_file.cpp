// SPDX-License-Identifier: MIT
#include "io/image_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <span>

#include "io/png_writer.h"

namespace patina::io {
namespace {

OIIO::TypeDesc type_of(SampleType type) {
    switch (type) {
        case SampleType::U8:
            return OIIO::TypeUInt8;
        case SampleType::U16:
            return OIIO::TypeUInt16;
        case SampleType::F32:
            return OIIO::TypeFloat;
    }
    return OIIO::TypeUnknown;
}

OIIO::ImageSpec spec_of(const Image& image, bool half) {
    OIIO::ImageSpec spec(image.width, image.height, image.channels,
                         half ? OIIO::TypeDesc(OIIO::TypeHalf) : type_of(image.type));
    if (image.channels == 2) {
        spec.channelnames = {"Y", "A"};
        spec.alpha_channel = 1;
    }
    // Without this, whoever reads a TIFF takes its colours as multiplied by alpha.
    if (image.type != SampleType::F32) spec.attribute("oiio:UnassociatedAlpha", 1);
    spec.attribute("compression", "zip");
    // OpenImageIO would say when it wrote and which version of it did: equal images, equal bytes.
    spec.attribute("DateTime", "1970:01:01 00:00:00");
    spec.attribute("Software", "Patina");
    return spec;
}

Result<Bytes> encode_with_openimageio(const Image& image, ImageFormat format, bool half) {
    const std::string name =
        std::string("image.") + std::string(kImageFormats[static_cast<std::size_t>(format)].id);
    const auto output = OIIO::ImageOutput::create(name);
    if (!output) return failure("cannot write {}: {}", name, OIIO::geterror());
    std::vector<unsigned char> buffer;
    OIIO::Filesystem::IOVecOutput memory(buffer);
    output->set_ioproxy(&memory);
    if (!output->open(name, spec_of(image, half)) ||
        !output->write_image(type_of(image.type), image.data.data()) || !output->close())
        return failure("cannot encode {}: {}", name, quoted_for_message(output->geterror()));
    const auto bytes = std::as_bytes(std::span(buffer));
    return Bytes(bytes.begin(), bytes.end());
}

}  // namespace

std::optional<ImageFormat> image_format_of(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    if (extension == ".tiff") return ImageFormat::Tiff;
    return extension.empty() ? std::nullopt
                             : image_format_from_id(std::string_view(extension).substr(1));
}

Result<Bytes> encode_image(const Image& image, ImageFormat format, const Progress& progress) {
    switch (format) {
        case ImageFormat::Png:
            return encode_png(image, {}, progress);
        case ImageFormat::Tiff:
        case ImageFormat::Exr:
            return encode_with_openimageio(
                image, format, format == ImageFormat::Exr && image.type != SampleType::F32);
    }
    return failure("unknown image format");
}

Result<Bytes> encode_half_exr(const Image& image) {
    constexpr float kLargestHalf = 65504.0f;
    if (image.type != SampleType::F32) return encode_image(image, ImageFormat::Exr);
    Image held = image;
    auto* const numbers = reinterpret_cast<float*>(held.data.data());
    for (std::size_t i = 0; i < held.data.size() / sizeof(float); ++i)
        numbers[i] = std::clamp(numbers[i], -kLargestHalf, kLargestHalf);
    return encode_with_openimageio(held, ImageFormat::Exr, true);
}

Status write_image_file(const std::filesystem::path& path, const Image& image,
                        const Progress& progress) {
    const auto format = image_format_of(path);
    if (!format)
        return failure("{}: the extension names no image format; use .png, .tif or .exr",
                       quoted_for_message(path.string()));
    const Result<Bytes> bytes = encode_image(image, *format, progress);
    if (!bytes) return failure("{}: {}", quoted_for_message(path.string()), bytes.error().message);
    return write_file_atomically(path, *bytes);
}

}  // namespace patina::io
