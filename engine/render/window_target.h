// SPDX-License-Identifier: MIT
#pragma once

#include "gl/debug.h"

namespace patina::render {

/// Reports what the driver finds wrong while it lives, of a window whose context is for debugging.
using WindowErrors = gl::DebugOutput;

/// Makes the window of the current context what is drawn to next, in the state that Dear ImGui's
/// back end starts from. Call it after all draws of a Renderer, before the interface's.
void draw_to_window();

}  // namespace patina::render
