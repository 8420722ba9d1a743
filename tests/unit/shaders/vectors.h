// SPDX-License-Identifier: MIT
#pragma once

/// What compares the shared formulae with sums in double precision: pi, and the formulae's vectors
/// as those of glm and back.

#include <glm/glm.hpp>
#include <numbers>

#include "core/formulae/real.h"

namespace patina {

inline constexpr double kPi = std::numbers::pi;

inline formulae::Real3 real3(const glm::vec3& v) {
    return {v.x, v.y, v.z};
}
inline formulae::Real3 real3(const glm::dvec3& v) {
    return real3(glm::vec3(v));
}
inline glm::vec3 vec3(const formulae::Real3& v) {
    return {v.x, v.y, v.z};
}
inline glm::dvec3 dvec3(const formulae::Real3& v) {
    return {v.x, v.y, v.z};
}

}  // namespace patina
