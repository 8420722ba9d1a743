// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "render/renderer.h"

namespace patina::editor {

/// How a view is saved.
struct StillOptions {
    int height = 1080;  ///< pixels; the width follows the viewport's shape
    int samples = 64;
    bool transparent = false;  ///< instead of the background on screen
};

/// @param aspect  width / height of the viewport
inline render::PictureSize still_size(int height, float aspect) {
    const auto width = std::lround(static_cast<float>(height) * aspect);
    return {static_cast<int>(std::clamp(width, 1L, long{render::kMaxPictureSide})), height};
}

}  // namespace patina::editor
