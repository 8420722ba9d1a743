// SPDX-License-Identifier: MIT
#pragma once

/// The edges of the triangles over a finished picture. Inside engine/render only.

#include "render/renderer_state.h"

namespace patina::render {

/// Draws them over `picture`, which shows the view in sRGB-encoded RGBA8, on each of its sides.
Status draw_wires(RendererState& state, const View& view, const gl::Framebuffer& picture);

/// The same over a still of the view: RGBA, U8 or U16, sRGB-encoded.
Status lay_wires(RendererState& state, const View& view, Image& still);

}  // namespace patina::render
