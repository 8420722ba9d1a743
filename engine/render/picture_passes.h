// SPDX-License-Identifier: MIT
#pragma once

/// The passes that make a picture of what the geometry passes wrote. Inside engine/render only.

#include "render/environment_samples.h"
#include "render/geometry_passes.h"

namespace patina::render {

/// One triangle over a whole target.
inline constexpr std::string_view kFullScreenVertexFile = "passes/full_screen.vert";
inline constexpr gl::State kFullScreenState{.depth_test = gl::DepthTest::Off, .write_depth = false};

/// What a target holds, as passes/output.glsl numbers it.
enum class OutputMode { Srgb, Display, Radiance };

/// Where a picture goes.
struct PictureTarget {
    const gl::Framebuffer* framebuffer = nullptr;
    gl::Viewport area;                   ///< nothing outside is touched
    glm::ivec2 picture_offset = {0, 0};  ///< of the picture's lower left corner, not of the area's
    OutputMode output = OutputMode::Srgb;
    bool add = false;  ///< to what the target holds, for averages
    /// Set: the environment is sampled, and this draw takes its share; else it is read filtered.
    std::optional<StillDraw> still = {};
    int draw_index = 0;  ///< of several that are averaged: soft shadows take other taps in each
};

/// One side of a view.
struct SideView {
    const View& view;
    const Shading& shading;
    FrameSide side;
};

/// What the deferred pass reads; one is null.
struct LightingInputs {
    const gl::Framebuffer* gbuffer = nullptr;
    const gl::Framebuffer* inspection = nullptr;  ///< for channels of the inspection pass
};

/// Lights the G-buffer. With `only_pixel` every pixel shows that one of the G-buffer.
Status draw_lighting(RendererState& state, const SideView& side, const FrameCamera& camera,
                     const LightingInputs& inputs, const PictureTarget& target,
                     const std::optional<glm::ivec2>& only_pixel = std::nullopt);

/// Lights surfaces one by one as they are drawn. Opaque ones, from the nearest, clear the target
/// first; blended ones, from the farthest, go over radiance with a transparent background and the
/// depth of the opaque ones.
Status draw_forward(RendererState& state, const SideView& side, const FrameCamera& camera,
                    SurfaceSet surfaces, const PictureTarget& target);

/// What draw_post reads: radiance with coverage, premultiplied.
struct RadianceInput {
    const gl::Framebuffer* sum = nullptr;
    glm::ivec2 picture_offset = {0, 0};  ///< of the picture within it
    int draws = 1;                       ///< that it is the sum of
};

/// Turns radiance with coverage into the picture over its background.
Status draw_post(RendererState& state, const SideView& side, const FrameCamera& camera,
                 const RadianceInput& radiance, const PictureTarget& target);

/// The heat map of two pictures of radiance.
Status draw_difference(RendererState& state, const View& view, const gl::Framebuffer& left,
                       const gl::Framebuffer& right, const PictureTarget& target);

/// Fast anti-aliasing of an sRGB-encoded picture.
Status draw_smoothed(RendererState& state, const gl::Framebuffer& picture,
                     const gl::Framebuffer& target);

}  // namespace patina::render
