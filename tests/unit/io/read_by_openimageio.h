// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include "io/image_codecs.h"

namespace patina::io {

/// What OpenImageIO, which reads PNG by libpng and checks every checksum, makes of a file.
/// @param format  OpenImageIO's name of it
inline Image read_by_openimageio(const Bytes& encoded, const char* format) {
    const auto codecs = image_codecs();
    if (!codecs) {
        ADD_FAILURE() << codecs.error().message;
        return {};
    }
    const auto open = (*codecs)->open(encoded, "image", format);
    const auto image = open ? (*open)->pixels() : Result<ImagePtr>(passed_on(open));
    if (!image) {
        ADD_FAILURE() << image.error().message;
        return {};
    }
    return **image;
}

}  // namespace patina::io
