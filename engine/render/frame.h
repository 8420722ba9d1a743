// SPDX-License-Identifier: MIT
#pragma once

/// All passes of one frame, for each way to compare. Inside engine/render only.

#include "render/picture_passes.h"

namespace patina::render {

/// Where a frame goes.
struct FrameTarget {
    const gl::Framebuffer* framebuffer = nullptr;
    OutputMode output = OutputMode::Srgb;
    bool add = false;                           ///< to what the target holds, for averages
    glm::vec2 jitter_pixels = glm::vec2(0.0f);  ///< see frame_camera
    std::optional<StillDraw> still = {};        ///< see PictureTarget
    int draw_index = 0;
    /// Set, for a difference: the radiance of the left side is added to `framebuffer`, that of the
    /// right one to this, and their difference is left to draw_difference.
    const gl::Framebuffer* right_sum = nullptr;
};

Status draw_frame(RendererState& state, const View& view, glm::ivec2 size,
                  const FrameTarget& target);

/// Turns a sum of `draws` frames, each drawn as radiance before a transparent background, into the
/// picture over the view's background.
Status draw_averaged(RendererState& state, const View& view, glm::ivec2 size,
                     const gl::Framebuffer& sum, int draws, const FrameTarget& target);

/// The strip of channels, each `thumbnail` large, into a target that holds them all.
Status draw_strip_frame(RendererState& state, const View& view, glm::ivec2 thumbnail,
                        const gl::Framebuffer& target);

/// Of the G-buffer that a side of this frame uses: the size, and where it lies in the picture.
struct SideArea {
    glm::ivec2 gbuffer_size;
    glm::ivec2 offset;
};
SideArea side_area(const View& view, glm::ivec2 size, FrameSide side);

/// Where a frame may show surfaces: one area of each picture in it.
std::vector<gl::Viewport> surface_areas(const RendererState& state, const View& view,
                                        glm::ivec2 size);

/// Both sides of a view, each `size` large.
Result<SidePictures> draw_both_sides(RendererState& state, const View& view, glm::ivec2 size);

/// The costs of the last frame drawn.
FrameStats frame_stats(RendererState& state);

}  // namespace patina::render
