// SPDX-License-Identifier: MIT
#pragma once

/// The log in a box, where the layout has no panel for it.

#include <span>

#include "editor/state/shown.h"
#include "editor/widgets/ui.h"

namespace patina::editor {

class LogDialog {
  public:
    void open() { open_ = true; }
    bool is_open() const { return open_; }
    void draw(Ui& ui, std::span<const LogLine> log);

  private:
    bool open_ = false;
};

}  // namespace patina::editor
