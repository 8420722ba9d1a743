// SPDX-License-Identifier: MIT
#pragma once

/// Maps of depth as seen from lights, which passes/shadows.glsl reads. Inside engine/render only.
/// Each is drawn anew only when its light, the scene or a material has changed.

#include <optional>
#include <vector>

#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "render/shadow_plan.h"

namespace patina::render {

struct RendererState;

struct ShadowMaps {
    ShadowPlan plan;                 ///< of the frame under way
    LampPoint point;                 ///< that lamps which have a size shine from in it
    std::vector<ShadowLight> drawn;  ///< what the maps hold
    bool stale = true;               ///< the scene or a material has changed since
    std::optional<gl::Framebuffer> maps;
};

/// Makes state.shadow_maps what the view needs. Before the passes of a frame.
/// @param point  set in draws that sample lamps: where those that have a size shine from
Status draw_shadow_maps(RendererState& state, const View& view,
                        const std::optional<LampPoint>& point = std::nullopt);

/// Takes texture unit 12, where there are maps.
void bind_shadows(gl::Pass& pass, gl::Program& program, const RendererState& state, int draw_index);

}  // namespace patina::render
