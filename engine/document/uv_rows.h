// SPDX-License-Identifier: MIT
#pragma once

#include "document/source.h"

namespace patina {

/// What a transform makes of coordinates: u' = dot(u, (u, v, 1)), and v' likewise.
struct UvRows {
    glm::vec3 u = glm::vec3(1.0f, 0.0f, 0.0f);
    glm::vec3 v = glm::vec3(0.0f, 1.0f, 0.0f);
};
/// KHR_texture_transform: offset + rotation * scale * uv, with the signs of its specification.
/// Exact at the quarter turns.
UvRows uv_rows(const UvTransform& transform);

}  // namespace patina
