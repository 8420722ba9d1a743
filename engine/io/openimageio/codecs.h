// SPDX-License-Identifier: MIT
#pragma once

/// The functions of ImageCodecs, made of OpenImageIO.

#include "io/image_codecs.h"

namespace patina::io::openimageio {

Result<std::unique_ptr<OpenedImage>> open(std::span<const std::byte> encoded, std::string_view name,
                                          std::string_view format);
/// Equal images give equal bytes.
Result<Bytes> encode(const Image& image, const CodecEncoding& encoding);

}  // namespace patina::io::openimageio
