// SPDX-License-Identifier: MIT
#pragma once

/// Images for tests.

#include <map>
#include <memory>

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

    Result<ImagePtr> pixels(const Hash128& image) override {
        const auto found = images.find(image);
        if (found == images.end()) return failure("image {}: no such image", to_hex(image));
        return found->second;
    }

    std::map<Hash128, ImagePtr> images;
};

}  // namespace patina
