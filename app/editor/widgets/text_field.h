// SPDX-License-Identifier: MIT
#pragma once

/// Text that is typed: names, searches, paths, and the numbers of other fields.

#include <optional>
#include <string>
#include <string_view>

#include "editor/widgets/ui.h"

namespace patina::editor {

/// Begins typing into the field `id`, with all of `text` selected.
void start_typing(Ui& ui, ImGuiID id, std::string text);

/// The field that `start_typing` began, while it lasts. Returns the text when Enter or a click
/// elsewhere accepts it; Esc ends it without a result.
std::optional<std::string> typed(Ui& ui, ImGuiID id, const Rect& rect, const ImFont* font);

/// The name of a row in the place where it stands, while it is renamed.
/// @param renaming  whether it is; false again when typing has ended
/// @return the new name, when it was accepted and is not empty
std::optional<std::string> rename_field(Ui& ui, const Rect& rect, const std::string& name,
                                        bool& renaming);

struct SearchField {
    std::string_view label;
    std::string_view hint;
    ImU32 color = theme::kField;
    bool focus = false;  ///< take the keyboard in this frame
};
/// A field with a magnifier that edits `text` as it is typed. True when it changed.
bool search_field(Ui& ui, const Rect& rect, const SearchField& field, std::string& text);

/// A plain field that edits `text` as it is typed; true when Enter was pressed in it.
bool line_field(Ui& ui, const Rect& rect, std::string_view label, std::string& text,
                bool focus = false);

}  // namespace patina::editor
