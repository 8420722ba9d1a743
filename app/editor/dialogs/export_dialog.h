// SPDX-License-Identifier: MIT
#pragma once

/// How the maps are to be written, before a folder for them is chosen.

#include <functional>

#include "editor/widgets/ui.h"
#include "io/map_export.h"

namespace patina::editor {

class ExportDialog {
  public:
    /// With what was chosen last.
    /// @param chosen  called when the dialog is accepted
    void open(std::function<void(const io::MapExportOptions&)> chosen);
    bool is_open() const { return chosen_ != nullptr; }
    void draw(Ui& ui);

  private:
    void draw_choices(Ui& ui, Rect& rest);

    std::function<void(const io::MapExportOptions&)> chosen_;
    io::MapExportOptions options_;
};

}  // namespace patina::editor
