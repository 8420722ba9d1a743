// SPDX-License-Identifier: MIT
#pragma once

/// The value of a channel that is the same in every texel.

#include "composite/operations.h"

namespace patina {

/// Runs the program for one texel of `channel`, which no image or procedural decides. Colours are
/// linear.
glm::vec3 uniform_channel(const ProgramData& program, Channel channel);

}  // namespace patina
