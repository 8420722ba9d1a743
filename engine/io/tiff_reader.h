// SPDX-License-Identifier: MIT
#pragma once

/// Plain TIFF in, by libtiff straight into the pixels: what other programs write as working files.
/// It is large, and OpenImageIO copies it twice on the way.

#include <filesystem>

#include "io/image_decode.h"

namespace patina::io {

/// Opens an uncompressed file of 8- or 16-bit grey or RGB with or without alpha, in strips of whole
/// pixels. Null for any other file, which OpenImageIO reads (or has something to say of): tiles,
/// planes, palettes, floats and what is compressed.
/// @param encoded  must outlive what is returned
std::unique_ptr<OpenedImage> open_plain_tiff(std::span<const std::byte> encoded);
/// The same of a file, of which nothing is kept in memory but the pixels.
std::unique_ptr<OpenedImage> open_plain_tiff(const std::filesystem::path& path);

}  // namespace patina::io
