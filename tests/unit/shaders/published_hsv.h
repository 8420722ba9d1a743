// SPDX-License-Identifier: MIT
#pragma once

/// Hue, saturation and value (Smith 1978) in double precision, for the published modes and
/// adjustments that are defined by them. Knows nothing of shaders/shared.

#include <glm/glm.hpp>

namespace patina::test_support {

/// Hue in sixths of a turn, saturation, value; the hue of grey is 0.
glm::dvec3 hsv_from_rgb(const glm::dvec3& c);

/// @param hue  in sixths of a turn, -12 or more
glm::dvec3 rgb_from_hsv(double hue, double saturation, double value);

}  // namespace patina::test_support
