// SPDX-License-Identifier: MIT
#pragma once

/// The soft shadow that a scene leaves on the floor it stands on: how much of an overcast sky each
/// point of the floor sees. Made on the CPU once a scene, so a frame pays one texture read.

#include <glm/glm.hpp>
#include <vector>

#include "scene/scene.h"

namespace patina::render {

struct GroundShadow {
    int side = 0;  ///< texels; row 0 at the least z
    /// From the middle of the scene to the edge, metres, along x and z; 0 where nothing stands.
    float extent = 0.0f;
    glm::vec3 center_world = glm::vec3(0.0f);  ///< on the floor: the lowest point of the scene
    std::vector<std::uint8_t> light;  ///< side * side: 255 sees the whole sky, 1 at the edge
};

/// The scene is seen as columns from the lowest to the highest surface over each texel; rays from
/// the floor are blocked by a column between its ends, weighted by the cosine.
GroundShadow ground_shadow(const Scene& scene, const Bounds& bounds_world, int side = 128);

}  // namespace patina::render
