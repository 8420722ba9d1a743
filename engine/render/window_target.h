// SPDX-License-Identifier: MIT
#pragma once

namespace patina::render {

/// Makes the window of the current context what is drawn to next, in the state that Dear ImGui's
/// back end starts from. Call it after all draws of a Renderer, before the interface's.
void draw_to_window();

}  // namespace patina::render
