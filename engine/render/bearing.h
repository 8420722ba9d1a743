// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>

namespace patina::render {

/// The unit vector towards a yaw from +Z towards +X and an elevation above the horizon (+Y up).
inline glm::vec3 bearing(float yaw_degrees, float elevation_degrees) {
    const float yaw = glm::radians(yaw_degrees);
    const float elevation = glm::radians(elevation_degrees);
    return {std::sin(yaw) * std::cos(elevation), std::sin(elevation),
            std::cos(yaw) * std::cos(elevation)};
}

}  // namespace patina::render
