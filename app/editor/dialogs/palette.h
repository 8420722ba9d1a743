// SPDX-License-Identifier: MIT
#pragma once

/// Ctrl K: every action by name, with its key; those that do not apply are greyed.

#include <optional>
#include <string>

#include "editor/state/shown.h"

namespace patina::editor {

class Palette {
  public:
    void open() {
        open_ = true;
        fresh_ = true;
        search_.clear();
        chosen_ = 0;
    }
    bool is_open() const { return open_; }
    std::optional<Action> draw(Ui& ui, const Shown& shown);

  private:
    bool open_ = false;
    bool fresh_ = false;
    std::string search_;
    int chosen_ = 0;
};

}  // namespace patina::editor
