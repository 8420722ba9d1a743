// SPDX-License-Identifier: MIT
#pragma once

/// A field that shows one of several choices and opens a menu of them. Ctrl and the wheel over it,
/// or Up and Down while the keyboard is at it, step through them without the menu.

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "editor/widgets/ui.h"

namespace patina::editor {

struct ComboItem {
    std::string_view label;
    std::string_view group = {};  ///< a heading is drawn where it changes
    std::string_view tooltip = {};
    bool enabled = true;
};

struct ComboSpec {
    std::string_view label;             ///< for the UiMap and the tooltip
    std::string_view shown_label = {};  ///< before the value, in the quieter colour
    std::string_view shown_value = {};  ///< instead of the chosen item's label
    std::string_view tooltip = {};
    std::string_view key = {};
    bool enabled = true;
    bool flat = false;                 ///< only words and an angle, as in a layer's row
    const Picture* picture = nullptr;  ///< small, before the value
    float picture_width = 18.0f;
};

/// Returns the index of a newly chosen item.
std::optional<int> combo(Ui& ui, const Rect& rect, const ComboSpec& spec,
                         std::span<const ComboItem> items, int chosen);

}  // namespace patina::editor
