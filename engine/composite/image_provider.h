// SPDX-License-Identifier: MIT
#pragma once

/// How pixels reach the compositor; `io` implements it.

#include <functional>

#include "core/result.h"
#include "scene/image.h"

namespace patina {

class ImageProvider {
  public:
    virtual ~ImageProvider() = default;

    /// The decoded pixels of an image of the document, if they are at hand; null while they are
    /// still being decoded. A failure is final (bad file) and says why. Any thread.
    virtual Result<ImagePtr> pixels_if_ready(const Hash128& image) = 0;
    /// The same, waiting for a decode that is under way.
    virtual Result<ImagePtr> pixels(const Hash128& image) = 0;
};

}  // namespace patina
