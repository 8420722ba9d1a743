// SPDX-License-Identifier: MIT
#pragma once

/// Which lights cast shadows, and how each of them sees the scene. Inside engine/render only.

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "render/gpu_environment.h"
#include "render/view.h"
#include "scene/scene.h"

namespace patina::render {

inline constexpr std::size_t kMostShadows = 6;

/// A light whose shadow is drawn: far away, or at a place.
struct ShadowLight {
    bool is_far = true;
    glm::vec3 towards_world = glm::vec3(0.0f, 1.0f, 0.0f);  ///< unit, of far ones
    glm::vec3 place_world = glm::vec3(0.0f);                ///< of the others
    glm::vec3 ahead_world = glm::vec3(0.0f);  ///< unit: where it shines; 0: to all sides
    /// How large it is for the shadow's edge: radians of a far one, metres of another.
    float radius = 0.0f;
    bool operator==(const ShadowLight&) const = default;
};

/// One of several draws that are averaged: lamps that have a size shine from one point in each.
struct LampPoint {
    glm::vec2 u = glm::vec2(0.5f);  ///< of the unit square
};
/// The point of draw `index`, the same for every lamp. See r2_point.
LampPoint lamp_point(int index);

/// Which light reads which map.
struct ShadowPlan {
    std::vector<ShadowLight> lights;  ///< at most kMostShadows
    int suns = 0;                     ///< maps 0 to suns - 1 are of the environment's suns
    /// By map, which of View::lights it is of; -1: none.
    std::array<int, kMostShadows> lamps = {-1, -1, -1, -1, -1, -1};
    int key = -1;  ///< of what the traditional models see of the environment
};
/// The suns of the environment first; the key light of the traditional models where one is on
/// screen, which takes the map of a sun that is near it; then the lamps that light the scene most,
/// by their range, cone and side too.
/// @param point  set: lamps that have a size are that point of themselves
ShadowPlan shadow_plan(const View& view, const GpuEnvironment& environment, const Bounds& bounds,
                       const std::optional<LampPoint>& point = std::nullopt);

/// How a light sees the scene: all of the ball around it. A lamp within that ball sees 150 degrees
/// of it, ahead or towards its middle, and what lies beside that it lights without a shadow.
struct ShadowView {
    glm::mat4 clip_from_world = glm::mat4(1.0f);
    /// Metres across the map: in all, or of a lamp at a place at a distance of 1 m.
    float across = 1.0f;
    float near_m = 0.0f;  ///< depth 0 of the map, metres from a far light's plane or from the lamp
    float far_m = 1.0f;   ///< depth 1
};
ShadowView shadow_view(const Bounds& bounds, const ShadowLight& light);

}  // namespace patina::render
