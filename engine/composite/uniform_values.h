// SPDX-License-Identifier: MIT
#pragma once

/// The shared formulae on values that are the same in every texel, worked out when a stack is
/// compiled.

#include <glm/glm.hpp>

#include "document/layer.h"

namespace patina {

/// sRGB-encoded from linear light and back, 0..1; what lies beyond is clamped.
glm::vec3 encoded_color(const glm::vec3& color_linear);
glm::vec3 linear_color(const glm::vec3& color_encoded);

/// What an adjustment makes of a mask that is `below`; where all texels are alike, it looks around
/// in vain.
float adjusted_mask_value(const AdjustmentSettings& adjustment, float below);
/// The mask after `entry`, where it was `below` and the entry's source or adjustment gives `value`.
float joined_mask_value(float below, const MaskEntry& entry, float value);

}  // namespace patina
