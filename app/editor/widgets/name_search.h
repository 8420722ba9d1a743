// SPDX-License-Identifier: MIT
#pragma once

/// Searching a list of names: the button that opens it, its field, and what matches.

#include <optional>
#include <string>
#include <string_view>

#include "editor/widgets/ui.h"

namespace patina::editor {

/// Whether every word of `search` occurs in `name`, without regard to case (ASCII).
bool name_matches(std::string_view name, std::string_view search);
/// Opens and closes a search; set means open.
void search_toggle(Ui& ui, const Rect& rect, std::string_view label,
                   std::optional<std::string>& search);
/// The field of an open search, cut off the top of `rest`.
void name_search(Ui& ui, Rect& rest, std::string_view label, std::string& search);

}  // namespace patina::editor
