// SPDX-License-Identifier: MIT
#pragma once

/// Choices of a dialog that is filled in before something is done.

#include <string>
#include <utility>
#include <vector>

#include "editor/widgets/combo.h"
#include "editor/widgets/form.h"

namespace patina::editor {

/// One of several values behind a label, in a line of its own; what is chosen is stored.
template <typename Value>
void dialog_choice(Ui& ui, Rect& rest, std::string_view label, std::string_view tooltip,
                   const std::vector<std::pair<std::string, Value>>& choices, Value& value) {
    Rect row = next_line(ui, rest);
    text(ui, row.cut_left(ui.px(96)), ui.fonts.value12, theme::kText2, label);
    std::vector<ComboItem> items;
    int chosen = -1;
    for (const auto& [name, each] : choices) {
        if (each == value) chosen = static_cast<int>(items.size());
        items.push_back({.label = name});
    }
    const auto picked = combo(ui, row, {.label = label, .tooltip = tooltip}, items, chosen);
    if (picked) value = choices[static_cast<std::size_t>(*picked)].second;
}

}  // namespace patina::editor
