// SPDX-License-Identifier: MIT
#pragma once

#include "editor/widgets/ui.h"
#include "render/view.h"

namespace patina::editor {

/// The four compare modes as icons of 16 x 14 px in the middle of `rect`.
void draw_mode_icon(const Ui& ui, const Rect& rect, render::CompareMode mode, ImU32 color);

}  // namespace patina::editor
