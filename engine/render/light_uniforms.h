// SPDX-License-Identifier: MIT
#pragma once

/// What passes/shading.glsl reads beside lamps (light_block.h) and shadows.

#include "gl/program.h"
#include "render/gpu_environment.h"
#include "render/shadow_plan.h"
#include "render/view.h"

namespace patina::render {

struct RendererState;

/// Makes lamps and shadows of the renderer those of a view. Before the passes of a frame.
/// @param point  set in draws that sample lamps: where those that have a size shine from
Status ready_lights(RendererState& state, const View& view,
                    const std::optional<LampPoint>& point = std::nullopt);

/// The key light, and what of the environment the traditional models see.
void set_lighting(gl::Program& program, const View& view, const Shading& shading,
                  const GpuEnvironment& environment);

}  // namespace patina::render
