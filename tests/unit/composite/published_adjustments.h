// SPDX-License-Identifier: MIT
#pragma once

/// Adjustments in double precision, from their definitions alone; knows nothing of shaders/shared.

#include <glm/glm.hpp>

#include "document/adjustment.h"
#include "document/channel.h"

namespace patina::test_support {

double leveled(const Levels& levels, double x);

/// What an adjustment makes of a value of the channel. Colours are in the blend space of the layer.
/// @param gradient_encoded  whether that is sRGB-encoded, in which the gradient's colours then are
glm::dvec3 adjusted(const AdjustmentSettings& adjustment, Channel channel, const glm::dvec3& value,
                    bool gradient_encoded);

}  // namespace patina::test_support
