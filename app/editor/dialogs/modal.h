// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "editor/widgets/buttons.h"
#include "editor/widgets/ui.h"

namespace patina::editor {

/// A box over the dimmed window. While it lives, everything behind it is out of reach.
class Modal {
  public:
    struct Description {
        const char* name = "";
        float width = 0.0f;       ///< logical pixels
        float height = 0.0f;      ///< logical pixels
        float top_share = -1.0f;  ///< its top in shares of the window's height; negative: centred
    };
    /// @param still_open  asked at the end: whether the dialog is drawn in the next frame too
    Modal(Ui& ui, const Description& description, std::function<bool()> still_open);
    ~Modal();
    Modal(const Modal&) = delete;
    Modal& operator=(const Modal&) = delete;

    Rect content() const { return content_; }
    /// Esc was pressed.
    bool dismissed() const;

  private:
    Ui& ui_;
    Rect content_;
    std::function<bool()> still_open_;
};

/// A button at the right end of `row`, of which it is cut off with the gap to the next one. Whether
/// it was clicked.
bool dialog_button(Ui& ui, Rect& row, const TextButton& button);

}  // namespace patina::editor
