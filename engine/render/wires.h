// SPDX-License-Identifier: MIT
#pragma once

/// The edges of the triangles over a finished picture. Inside engine/render only.

#include "render/renderer_state.h"

namespace patina::render {

/// Draws them over `picture`, which shows the view in sRGB-encoded RGBA8, on each of its sides.
Status draw_wires(RendererState& state, const View& view, const gl::Framebuffer& picture);

}  // namespace patina::render
