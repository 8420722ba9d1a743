// SPDX-License-Identifier: MIT
#pragma once

/// Pictures out: PNG (Patina's own writer), TIFF, OpenEXR and JPEG (OpenImageIO). The numbers are
/// written as they are, but for JPEG; equal images give equal bytes.

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>

#include "core/files.h"
#include "core/progress.h"
#include "scene/image.h"

namespace patina::io {

enum class ImageFormat : std::uint8_t { Png, Tiff, Exr, Jpeg };

struct ImageFormatInfo {
    ImageFormat format;
    std::string_view id;         ///< on the command line; also the extension of files
    std::string_view mime_type;  ///< as glTF would say it
};
inline constexpr std::array kImageFormats = {
    ImageFormatInfo{ImageFormat::Png, "png", "image/png"},
    ImageFormatInfo{ImageFormat::Tiff, "tif", "image/tiff"},
    ImageFormatInfo{ImageFormat::Exr, "exr", "image/x-exr"},
    ImageFormatInfo{ImageFormat::Jpeg, "jpg", "image/jpeg"},
};
constexpr std::optional<ImageFormat> image_format_from_id(std::string_view id) {
    for (const ImageFormatInfo& entry : kImageFormats)
        if (entry.id == id) return entry.format;
    return std::nullopt;
}

/// What is chosen of how a picture is written, beside its format.
struct ImageEncoding {
    int png_level = 2;      ///< PngOptions::level
    int jpeg_quality = 90;  ///< 1 to 100; colours are never kept at less than full size
};

/// The format that the extension of `path` names, in upper or lower case; ".tiff" is TIFF too and
/// ".jpeg" JPEG.
std::optional<ImageFormat> image_format_of(const std::filesystem::path& path);

/// Alpha is straight in U8 and U16 and premultiplied in F32, and files say so.
/// PNG and TIFF keep U8 and U16 (TIFF F32 too), losslessly compressed; EXR holds F32 as 32-bit
/// floats and U8 and U16 as half floats of 0..1; JPEG U8 of 1 or 3 channels. What a format cannot
/// hold is a failure.
Result<Bytes> encode_image(const Image& image, ImageFormat format,
                           const ImageEncoding& encoding = {}, const Progress& progress = {});

/// An EXR of half floats from an F32 image; what is beyond the range of halves is held to it.
Result<Bytes> encode_half_exr(const Image& image);

/// Encodes in the format that the extension names and writes all or nothing.
Status write_image_file(const std::filesystem::path& path, const Image& image,
                        const Progress& progress = {});

}  // namespace patina::io
