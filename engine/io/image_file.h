// SPDX-License-Identifier: MIT
#pragma once

/// Pictures out: PNG (Patina's own writer), TIFF and OpenEXR (OpenImageIO). The numbers are written
/// as they are; equal images give equal bytes.

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>

#include "core/files.h"
#include "core/progress.h"
#include "scene/image.h"

namespace patina::io {

enum class ImageFormat : std::uint8_t { Png, Tiff, Exr };

struct ImageFormatInfo {
    ImageFormat format;
    std::string_view id;         ///< on the command line; also the extension of files
    std::string_view mime_type;  ///< as glTF would say it
};
inline constexpr std::array kImageFormats = {
    ImageFormatInfo{ImageFormat::Png, "png", "image/png"},
    ImageFormatInfo{ImageFormat::Tiff, "tif", "image/tiff"},
    ImageFormatInfo{ImageFormat::Exr, "exr", "image/x-exr"},
};
constexpr std::optional<ImageFormat> image_format_from_id(std::string_view id) {
    for (const ImageFormatInfo& entry : kImageFormats)
        if (entry.id == id) return entry.format;
    return std::nullopt;
}

/// The format that the extension of `path` names, in upper or lower case; ".tiff" is TIFF too.
std::optional<ImageFormat> image_format_of(const std::filesystem::path& path);

/// Alpha is straight in U8 and U16 and premultiplied in F32, and files say so.
/// PNG and TIFF keep U8 and U16 (TIFF F32 too), losslessly compressed; EXR holds F32 as 32-bit
/// floats and U8 and U16 as half floats of 0..1. What a format cannot hold is a failure.
Result<Bytes> encode_image(const Image& image, ImageFormat format, const Progress& progress = {});

/// An EXR of half floats from an F32 image; what is beyond the range of halves is held to it.
Result<Bytes> encode_half_exr(const Image& image);

/// Encodes in the format that the extension names and writes all or nothing.
Status write_image_file(const std::filesystem::path& path, const Image& image,
                        const Progress& progress = {});

}  // namespace patina::io
