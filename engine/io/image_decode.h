// SPDX-License-Identifier: MIT
#pragma once

/// Decoding one image from memory, and what is known of it before its pixels are decoded.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "core/result.h"
#include "io/image_store.h"
#include "scene/image.h"

namespace patina::io {

struct ImageHeader {
    int width = 0;
    int height = 0;
    int channels = 0;  ///< as they will be decoded, 1 to 4
    SampleType type = SampleType::U8;
    std::string format;  ///< OpenImageIO's name, such as "png"
    /// Of its colours: as the file says, else linear for floats and sRGB for integers.
    ColorSpace color_space = ColorSpace::Srgb;

    std::uint64_t decoded_bytes() const {
        return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) *
               static_cast<std::uint64_t>(channels) * sample_bytes(type);
    }
};

/// OpenImageIO's name of a format, told by content, else by the extension of `name`; empty if it
/// is unknown.
std::string_view image_format(std::span<const std::byte> encoded, std::string_view name);
/// Whether a file's name ends as those of a format that is read do.
bool has_image_extension(std::string_view name);
/// "image/png" for "png", and so on.
std::string_view mime_type_of_format(std::string_view format);

/// An image whose header has been read.
class OpenedImage {
  public:
    OpenedImage() = default;
    virtual ~OpenedImage() = default;
    OpenedImage(const OpenedImage&) = delete;
    OpenedImage& operator=(const OpenedImage&) = delete;

    virtual const ImageHeader& header() const = 0;
    /// Decodes all of it: check the header's size first. Once only.
    virtual Result<ImagePtr> pixels() = 0;
};

/// Reads the header. `encoded` must outlive what is returned.
Result<std::unique_ptr<OpenedImage>> open_image(std::span<const std::byte> encoded,
                                                std::string_view name);

/// Fails when the header states more than the limits allow.
Status check_image_size(const ImageHeader& header, const ImageLimits& limits);

/// Decodes PNG and plain TIFF by Patina's readers, any other format that OpenImageIO reads from
/// memory by that. The size is read from the header and checked before pixels are decoded. 8-bit
/// stays U8, 16-bit integers U16, half and float F32 (infinities and NaN become the largest finite
/// value and 0). Palettes are expanded.
/// @param name  for messages and, where the content does not tell the format, its extension
Result<ImagePtr> decode_image(std::span<const std::byte> encoded, std::string_view name,
                              const ImageLimits& limits = {});

/// Reads the header alone.
Result<ImageHeader> read_image_header(std::span<const std::byte> encoded, std::string_view name);

}  // namespace patina::io
