// SPDX-License-Identifier: MIT
#pragma once

/// Things to click: icon buttons, text buttons, checkboxes, one of a few side by side, tabs,
/// headings that fold.

#include <optional>
#include <span>
#include <string_view>

#include "editor/widgets/ui.h"

namespace patina::editor {

struct IconButton {
    const char* icon = nullptr;
    std::string_view label;
    std::string_view tooltip = {};
    std::string_view key = {};
    bool enabled = true;
    bool on = false;  ///< lit: it is a state, and it holds
    ImU32 color = theme::kText2;
    float size = 14.0f;
};
/// In the middle of `rect`, 26 px square.
bool icon_button(Ui& ui, const Rect& rect, const IconButton& button);

struct TextButton {
    std::string_view label;
    const char* icon = nullptr;
    std::string_view tooltip = {};
    std::string_view key = {};
    bool main = false;  ///< the accent: one in a view
    bool link = false;  ///< only words, in the accent
    bool enabled = true;
};
float text_button_width(const Ui& ui, const TextButton& button);
bool text_button(Ui& ui, const Rect& rect, const TextButton& button);

/// The 16 px box in the middle of `rect`. `label` names it for the tooltip and the UiMap.
bool checkbox(Ui& ui, const Rect& rect, std::string_view label, bool on,
              std::string_view tooltip = {}, bool enabled = true);
/// With its label at the right, on a whole row.
bool labelled_checkbox(Ui& ui, const Rect& rect, std::string_view label, bool on,
                       std::string_view tooltip = {}, bool enabled = true);

/// One of a few, side by side, all visible. Returns a newly chosen index.
std::optional<int> segmented(Ui& ui, const Rect& rect, std::span<const std::string_view> labels,
                             int chosen);

struct TabSpec {
    std::string_view label;
    bool chosen = false;
};
/// A tab at the left of `rest`, cut off it.
bool tab(Ui& ui, Rect& rest, const TabSpec& spec);

struct SectionSpec {
    std::string_view title;
    std::string_view count = {};    ///< quiet, after the title
    std::string_view summary = {};  ///< at the right, while folded
    bool open = true;
};
/// The heading of a section: a hairline, an angle, the title. Returns true when it was clicked; the
/// right end of `rect` that the caller has cut off is left for its buttons.
bool section(Ui& ui, const Rect& rect, const SectionSpec& spec);

/// The heading row of a panel: title and count. Returns what is left at the right.
Rect panel_title(Ui& ui, Rect rect, std::string_view title, std::string_view count = {});

/// Tints a row: selected (with the bar at the left), hovered, or not at all.
void row_tint(const Ui& ui, const Rect& rect, bool selected, bool hovered);

}  // namespace patina::editor
