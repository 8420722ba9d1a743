// SPDX-License-Identifier: MIT
#pragma once

/// An alpha that says nothing, and the image without it.

#include "scene/image.h"

namespace patina::io {

/// Whether a channel of an image, its last, is 1 (or more, of floats) everywhere.
bool last_is_one(const Image& image);

/// The image without its last channel; it has two or more.
Image without_last(const Image& image);

}  // namespace patina::io
