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
    const gl::Framebuffer* surfaces() const { return gbuffer ? gbuffer : inspection; }
};

/// Lights the G-buffer, and draws the background where it has no surface. The target has depth,
/// which becomes that of the surfaces.
Status draw_deferred(RendererState& state, const SideView& side, const FrameCamera& camera,
                     const LightingInputs& inputs, const PictureTarget& target);

/// Lights one pixel of the G-buffer, which has a surface, and shows it in all of the target.
Status draw_lit_pixel(RendererState& state, const SideView& side, const FrameCamera& camera,
                      const LightingInputs& inputs, const PictureTarget& target, glm::ivec2 pixel);

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

/// The radiance of the left and the right shading, each a whole picture.
struct SidePictures {
    const gl::Framebuffer* left = nullptr;
    const gl::Framebuffer* right = nullptr;
    int draws = 1;  ///< that each is the sum of
};

/// The heat map of two pictures of radiance.
Status draw_difference(RendererState& state, const View& view, const SidePictures& sides,
                       const PictureTarget& target);

/// Fast anti-aliasing of an sRGB-encoded picture in and around these areas; the rest is copied.
Status draw_smoothed(RendererState& state, const gl::Framebuffer& picture,
                     const gl::Framebuffer& target, const std::vector<gl::Viewport>& areas);

}  // namespace patina::render
