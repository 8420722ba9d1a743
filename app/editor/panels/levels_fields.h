// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "document/levels.h"
#include "document/parameters.h"
#include "editor/widgets/ui.h"

namespace patina::editor {

/// Levels as a hand has changed them in this frame, and the number that it changed.
struct LevelsChange {
    Levels levels;
    Parameter parameter;
};

/// The five numbers of levels, two to a line, cut off the top of `rest`.
std::optional<LevelsChange> levels_fields(Ui& ui, Rect& rest, const Levels& now);

}  // namespace patina::editor
