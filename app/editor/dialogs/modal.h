// SPDX-License-Identifier: MIT
#pragma once

#include "editor/widgets/ui.h"

namespace patina::editor {

/// A box over the dimmed window. While it lives, everything behind it is out of reach.
class Modal {
  public:
    /// @param top_share  where its top is, in shares of the window's height; negative: in the
    /// middle
    Modal(Ui& ui, const char* name, float width, float height, float top_share = -1.0f);
    ~Modal();
    Modal(const Modal&) = delete;
    Modal& operator=(const Modal&) = delete;

    Rect content() const { return content_; }
    /// Esc was pressed, or the pointer was pressed outside.
    bool dismissed() const;

  private:
    Ui& ui_;
    Rect content_;
};

}  // namespace patina::editor
