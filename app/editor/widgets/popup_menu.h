// SPDX-License-Identifier: MIT
#pragma once

/// A popup with rows: menus, combos, context menus.

#include <string_view>

#include "editor/widgets/ui.h"

namespace patina::editor {

struct MenuItem {
    const char* icon = nullptr;
    std::string_view label;
    std::string_view key = {};
    bool enabled = true;
    bool ticked = false;
    std::string_view tooltip = {};
};

/// Lives while its popup is drawn. Open it with ImGui::OpenPopup(id) before.
class PopupMenu {
  public:
    PopupMenu(Ui& ui, const char* id, float min_width = 160.0f);
    ~PopupMenu();
    PopupMenu(const PopupMenu&) = delete;
    PopupMenu& operator=(const PopupMenu&) = delete;
    bool open() const { return open_; }
    /// True when it was chosen; the popup closes.
    bool item(const MenuItem& item);
    void heading(std::string_view words);
    void separator();
    /// A row for a field.
    Rect field_row();

  private:
    Rect next_row(float height);

    Ui& ui_;
    bool open_;
    float width_ = 0.0f;
};

/// The next popup appears right below `anchor`.
void place_popup(const Rect& anchor, float gap);

}  // namespace patina::editor
