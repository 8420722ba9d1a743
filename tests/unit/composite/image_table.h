// SPDX-License-Identifier: MIT
#pragma once

/// Images for tests, at hand at once unless they are held back.

#include <map>
#include <memory>
#include <set>

#include "composite/image_provider.h"

namespace patina {

class ImageTable final : public ImageProvider {
  public:
    /// Returns the hash under which the image is found.
    Hash128 add(Image image) {
        const Hash128 hash = content_hash(image);
        images[hash] = std::make_shared<const Image>(std::move(image));
        return hash;
    }

    Result<ImagePtr> pixels_if_ready(const Hash128& image) override {
        if (held_back.contains(image)) return ImagePtr();
        return pixels(image);
    }
    Result<ImagePtr> pixels(const Hash128& image) override {
        const auto found = images.find(image);
        if (found == images.end()) return failure("image {}: no such image", to_hex(image));
        return found->second;
    }

    std::map<Hash128, ImagePtr> images;
    std::set<Hash128> held_back;  ///< as if they were still being decoded
};

}  // namespace patina
