// SPDX-License-Identifier: MIT
#pragma once

/// Smaller copies of images, for composites that are looked at from further away than their sources
/// were made for. Each is made once, when it is first asked for.

#include <map>
#include <tuple>

#include "document/source.h"
#include "scene/image.h"

namespace patina {

/// `image` at half its sides (rounded up), of the same type and channels: each texel is the mean of
/// the area that it covers, taken in linear light where `color_space` is Srgb. Alpha is averaged as
/// it is.
Image half_size_image(const Image& image, ColorSpace color_space);

/// One thread at a time.
class ReducedImages {
  public:
    /// `image`, whose pixels have the hash `hash`, halved `halvings` times.
    ImagePtr reduced(const Hash128& hash, const ImagePtr& image, ColorSpace color_space,
                     int halvings);
    std::size_t size_bytes() const { return size_bytes_; }

  private:
    std::map<std::tuple<Hash128, ColorSpace, int>, ImagePtr> copies_;
    std::size_t size_bytes_ = 0;
};

}  // namespace patina
