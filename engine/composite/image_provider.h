// SPDX-License-Identifier: MIT
#pragma once

/// How pixels reach the compositor; `io` implements it.

#include "core/result.h"
#include "scene/image.h"

namespace patina {

class ImageProvider {
  public:
    virtual ~ImageProvider() = default;

    /// The decoded pixels of an image of the document, never null; a failure says that it is not
    /// there. Any thread.
    virtual Result<ImagePtr> pixels(const Hash128& image) = 0;
};

}  // namespace patina
