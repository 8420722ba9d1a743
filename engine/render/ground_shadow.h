// SPDX-License-Identifier: MIT
#pragma once

/// The soft shadow that a scene leaves on the floor it stands on: what of the light of the sky each
/// point of the floor still sees. What is hidden is found on the CPU once a scene, and weighed anew
/// when the light turns or is another; a frame pays one texture read.

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "render/sky_light.h"
#include "scene/scene.h"

namespace patina::render {

/// Of a point of the floor, evenly all around; bit k is set where the scene hides band k of the
/// sky.
inline constexpr std::size_t kGroundAzimuths = 24;
using HiddenSky = std::array<std::uint32_t, kGroundAzimuths>;

struct GroundShadow {
    int side = 0;  ///< texels; row 0 at the least z
    /// From the middle of the scene to the edge, metres, along x and z; 0 where nothing stands.
    float extent = 0.0f;
    glm::vec3 center_world = glm::vec3(0.0f);  ///< on the floor: the lowest point of the scene
    std::vector<HiddenSky> hidden;             ///< side * side
};

/// What hides the sky from the floor; of a scene that lives longer.
struct FloorCaster {
    const Primitive* primitive = nullptr;
    glm::mat4 world_from_local = glm::mat4(1.0f);
};

/// The casters are seen as columns from the lowest to the highest surface over each texel; rays
/// from the floor are blocked by a column between its ends. What an alpha mask cuts out blocks too:
/// the mask is on the GPU, and leaves and lace are dense.
/// @param bounds_world  of the whole scene, with what casts no shadow
GroundShadow ground_shadow(const std::vector<FloorCaster>& casters, const Bounds& bounds_world,
                           int side = 128);

/// What reaches each texel: 255 for all of the light, and at the edge.
/// @param rotation_degrees  of the environment about +Y, counter-clockwise from above
std::vector<std::uint8_t> floor_light(const GroundShadow& shadow, const SkyShares& sky,
                                      float rotation_degrees);

}  // namespace patina::render
