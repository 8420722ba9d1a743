// SPDX-License-Identifier: MIT
#pragma once

#include "editor/widgets/ui.h"

namespace patina::editor {

/// The heat map's colours from least to most, over the width of `rect`.
void heat_bar(const Ui& ui, const Rect& rect);

}  // namespace patina::editor
