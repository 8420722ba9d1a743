// SPDX-License-Identifier: MIT
#pragma once

/// What passes/lights.glsl and passes/shading.glsl read.

#include "gl/program.h"
#include "render/gpu_environment.h"
#include "render/view.h"

namespace patina::render {

/// Lamps, and what of the environment the traditional models see.
void set_lighting(gl::Program& program, const View& view, const Shading& shading,
                  const GpuEnvironment& environment);

}  // namespace patina::render
