// SPDX-License-Identifier: MIT
#pragma once

/// What the engine asks of OpenImageIO, which lies behind a module of its own: it brings some 250
/// shared libraries with it, and linking them takes longer than most of what Patina is started for.
/// The module is loaded when the first image that needs it is read or written.

#include "core/files.h"
#include "io/image_decode.h"
#include "io/image_file.h"

namespace patina::io {

/// How the module writes a picture.
struct CodecEncoding {
    ImageFormat format = ImageFormat::Tiff;
    bool half = false;      ///< whether floats are written as half floats
    int jpeg_quality = 90;  ///< 1 to 100
};

/// The functions of the module (engine/io/openimageio). Thread-safe; none throws.
struct ImageCodecs {
    /// @param encoded  must outlive what is returned
    /// @param name     for messages
    /// @param format   OpenImageIO's name of it
    Result<std::unique_ptr<OpenedImage>> (*open)(std::span<const std::byte> encoded,
                                                 std::string_view name, std::string_view format);
    Result<Bytes> (*encode)(const Image& image, const CodecEncoding& encoding);
};

/// The one symbol of the module: a function of this type.
using ImageCodecsEntry = const ImageCodecs* (*)();
inline constexpr const char* kImageCodecsSymbol = "patina_image_codecs";
/// The module's file, beside a program that is installed in ../lib/patina, else in the engine
/// folder of the build that the program lies in.
inline constexpr const char* kImageCodecsFile = "patina-openimageio.so";

/// Loads the module the first time. Fails where its file is missing or does not fit.
Result<const ImageCodecs*> image_codecs();

}  // namespace patina::io
