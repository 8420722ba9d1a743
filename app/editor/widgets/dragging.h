// SPDX-License-Identifier: MIT
#pragma once

/// What dragging looks like everywhere: when it begins, and the ghost beside the pointer.

#include <string>

#include "editor/widgets/ui.h"

namespace patina::editor {

/// Whether the pointer has left the 4 px around where the left button went down.
bool drag_has_begun(const Ui& ui);

/// What is dragged, in small, beside the pointer and above everything.
/// @param thumbnail  may be empty
void draw_ghost(const Ui& ui, const Picture& thumbnail, const std::string& name);

}  // namespace patina::editor
