// SPDX-License-Identifier: MIT
#include "scene/image.h"

namespace patina {

Hash128 content_hash(const Image& image) {
    return Hasher()
        .add(image.width)
        .add(image.height)
        .add(image.channels)
        .add(image.type)
        .add_bytes(image.data)
        .finish();
}

}  // namespace patina
