// SPDX-License-Identifier: MIT
#pragma once

/// Menus of the kinds that there are of something, under their headings.

#include <optional>
#include <vector>

#include "document/adjustment.h"
#include "document/source.h"
#include "editor/widgets/combo.h"

namespace patina::editor {

/// All noises and patterns in the order of menus, and the row of each.
struct ProceduralRows {
    std::vector<ComboItem> items = {};
    std::vector<ProceduralKind> kinds = {};
};
ProceduralRows procedural_rows();

/// The kind chosen in the popup of that name, which the caller opens and places.
std::optional<ProceduralKind> procedural_menu(Ui& ui, const char* popup);
std::optional<AdjustmentKind> adjustment_menu(Ui& ui, const char* popup);

}  // namespace patina::editor
