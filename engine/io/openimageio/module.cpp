// SPDX-License-Identifier: MIT
#include "io/openimageio/codecs.h"

extern "C" [[gnu::visibility("default")]] const patina::io::ImageCodecs* patina_image_codecs() {
    static constexpr patina::io::ImageCodecs kCodecs = {.open = patina::io::openimageio::open,
                                                        .encode = patina::io::openimageio::encode};
    return &kCodecs;
}
