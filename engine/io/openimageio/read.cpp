// SPDX-License-Identifier: MIT
#include "io/openimageio/codecs.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <exception>
#include <limits>

namespace patina::io::openimageio {
namespace {

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

void make_finite(Image& image) {
    auto* const numbers = reinterpret_cast<float*>(image.data.data());
    constexpr float kLargest = std::numeric_limits<float>::max();
    for (std::size_t i = 0; i < image.data.size() / sizeof(float); ++i) {
        if (std::isnan(numbers[i])) numbers[i] = 0.0f;
        numbers[i] = std::clamp(numbers[i], -kLargest, kLargest);
    }
}

class FileInMemory final : public OpenedImage {
  public:
    explicit FileInMemory(std::span<const std::byte> encoded)
        : bytes_(const_cast<std::byte*>(encoded.data()), encoded.size()) {}

    Status open(std::string_view name, std::string_view format) {
        // A search path of our own making keeps plug-ins named by the environment out.
        input_ =
            OIIO::ImageInput::create(std::string(format), false, nullptr, nullptr, "/dev/null");
        if (!input_) {
            OIIO::geterror();
            return failure("{} images are not supported by this build of OpenImageIO", format);
        }
        input_->set_ioproxy(&bytes_);
        OIIO::ImageSpec settings;
        settings["oiio:UnassociatedAlpha"] = 1;
        OIIO::ImageSpec spec;
        if (!input_->open(std::string(name.empty() ? "image" : name), spec, settings))
            return failure("cannot be decoded: {}", first_line(input_->geterror()));
        if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.nchannels < 1 || spec.deep)
            return failure("is not a flat image");
        header_ = {.width = spec.width,
                   .height = spec.height,
                   .channels = std::min(spec.nchannels, 4),
                   .type = sample_type_of(spec.format),
                   .format = std::string(format),
                   .color_space = color_space_of(spec)};
        return {};
    }

    const ImageHeader& header() const override { return header_; }

    Result<ImagePtr> pixels() override try {
        auto image = std::make_shared<Image>(Image{.width = header_.width,
                                                   .height = header_.height,
                                                   .channels = header_.channels,
                                                   .type = header_.type});
        image->data.resize(header_.decoded_bytes());
        if (!input_->read_image(0, 0, 0, image->channels, type_desc_of(image->type),
                                image->data.data()))
            return failure("cannot be decoded: {}", first_line(input_->geterror()));
        if (image->type == SampleType::F32) make_finite(*image);
        return image;
    } catch (const std::exception& error) {
        return failure("cannot be decoded: {}", first_line(error.what()));
    }

  private:
    OIIO::Filesystem::IOMemReader bytes_;
    std::unique_ptr<OIIO::ImageInput> input_;  // reads bytes_ and goes first
    ImageHeader header_;
};

}  // namespace

Result<std::unique_ptr<OpenedImage>> open(std::span<const std::byte> encoded, std::string_view name,
                                          std::string_view format) try {
    auto file = std::make_unique<FileInMemory>(encoded);
    if (const Status opened = file->open(name, format); !opened) return passed_on(opened);
    return file;
} catch (const std::exception& error) {
    return failure("cannot be decoded: {}", first_line(error.what()));
}

}  // namespace patina::io::openimageio
