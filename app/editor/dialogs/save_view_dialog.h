// SPDX-License-Identifier: MIT
#pragma once

/// How large and how fine a view is to be saved, before a file for it is chosen.

#include <functional>

#include "editor/state/still_options.h"
#include "editor/widgets/ui.h"

namespace patina::editor {

class SaveViewDialog {
  public:
    /// With what was chosen last.
    /// @param aspect  width / height of the picture
    /// @param chosen  called when the dialog is accepted
    void open(float aspect, std::function<void(const StillOptions&)> chosen);
    bool is_open() const { return chosen_ != nullptr; }
    void draw(Ui& ui);

  private:
    std::function<void(const StillOptions&)> chosen_;
    float aspect_ = 1.0f;
    StillOptions options_;
};

}  // namespace patina::editor
