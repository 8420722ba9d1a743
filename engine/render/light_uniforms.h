// SPDX-License-Identifier: MIT
#pragma once

/// What passes/lights.glsl and passes/shading.glsl read.

#include "gl/program.h"
#include "render/gpu_environment.h"
#include "render/view.h"

namespace patina::render {

/// The way the strongest light of the environment travels in the world.
glm::vec3 turned_key_direction(const View& view, const GpuEnvironment& environment);

/// Lamps, and what of the environment the traditional models see.
void set_lighting(gl::Program& program, const View& view, const Shading& shading,
                  const GpuEnvironment& environment);

}  // namespace patina::render
