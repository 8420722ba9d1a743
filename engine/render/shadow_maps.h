// SPDX-License-Identifier: MIT
#pragma once

/// Maps of depth as seen from lights that are far away, which passes/shadows.glsl reads. Inside
/// engine/render only. They are drawn anew only when the lights, the scene or a material changed.

#include <optional>
#include <vector>

#include "gl/framebuffer.h"
#include "gl/pass.h"
#include "render/gpu_environment.h"
#include "render/view.h"
#include "scene/scene.h"

namespace patina::render {

struct RendererState;

inline constexpr std::size_t kMostShadows = 4;

/// A light whose shadow is drawn.
struct ShadowLight {
    glm::vec3 towards_world = glm::vec3(0.0f, 1.0f, 0.0f);  ///< unit
    float radius_radians = 0.0f;                            ///< as it is seen from the model
    bool operator==(const ShadowLight&) const = default;
};

/// Which light reads which map.
struct ShadowPlan {
    std::vector<ShadowLight> lights;  ///< at most kMostShadows
    int suns = 0;                     ///< maps 0 to suns - 1 are of the environment's suns
    /// By map, which of View::lights it is of; -1: none. Directional ones cast shadows.
    std::array<int, kMostShadows> lamps = {-1, -1, -1, -1};
    int key = -1;  ///< of what the traditional models see of the environment
};
/// The suns of the environment first, then the directional lamps; the key light of the traditional
/// models where one is on screen, which takes the map of a sun that is near it.
ShadowPlan shadow_plan(const View& view, const GpuEnvironment& environment);

/// How a light sees the scene.
struct ShadowView {
    glm::mat4 clip_from_world = glm::mat4(1.0f);
    float side_m = 1.0f;  ///< of the cube that it sees
};
ShadowView shadow_view(const Bounds& bounds, const glm::vec3& towards_world);

struct ShadowMaps {
    ShadowPlan plan;                 ///< of the frame under way
    std::vector<ShadowLight> drawn;  ///< what the maps hold
    bool stale = true;               ///< the scene or a material has changed since
    std::optional<gl::Framebuffer> maps;
};

/// Makes state.shadow_maps what the view needs. Before the passes of a frame.
Status draw_shadow_maps(RendererState& state, const View& view);

/// Takes texture unit 12, where there are maps.
void bind_shadows(gl::Pass& pass, gl::Program& program, const RendererState& state, int draw_index);

}  // namespace patina::render
