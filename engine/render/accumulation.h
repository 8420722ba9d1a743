// SPDX-License-Identifier: MIT
#pragma once

/// Draws that are added up in 32-bit floats: stills, and the picture that refines while nothing
/// moves. Inside engine/render only.

#include "render/frame.h"

namespace patina::render {

/// Where sample i lies in its pixel, from the middle; the first is the middle. See r2_point.
glm::vec2 sample_offset(int i);

/// One of the draws that a sum is made of.
struct AddedDraw {
    int index = 0;  ///< its place in the pixel; 0 clears the sum first
    /// Set: the environment is sampled; else it is read filtered.
    std::optional<StillDraw> still = {};
    const gl::Framebuffer* right_sum = nullptr;  ///< of a difference: see FrameTarget
};

/// The sum of a picture of that size, ready for the draw.
Result<gl::Framebuffer*> sum_for(SizedTarget& target, PictureSize size, int index);

/// Adds radiance with coverage, before a transparent background: draw_averaged makes the picture
/// of the sum. A tone map of each draw would not have the same mean.
Status add_radiance(RendererState& state, const View& view, PictureSize size,
                    const gl::Framebuffer& sum, const AddedDraw& draw);

/// Uploads what sampling the environment reads, where that has not been done.
Status ready_to_sample(RendererState& state);

}  // namespace patina::render
