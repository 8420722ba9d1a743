// SPDX-License-Identifier: MIT
#pragma once

/// What a preset that is made of layers shall be called, before it goes into the user's own folder.

#include <optional>

#include "editor/state/requests.h"
#include "editor/state/shown.h"
#include "editor/widgets/ui.h"

namespace patina::editor {

class SavePresetDialog {
  public:
    /// @param wanted  what to begin with; author and licence stay as they were typed last
    void open(SavePreset wanted);
    bool is_open() const { return open_; }
    /// What is to be saved, in the frame in which that is chosen.
    std::optional<SavePreset> draw(Ui& ui, const Shown& shown);

  private:
    bool draw_fields(Ui& ui, Rect& rest);

    SavePreset wanted_;
    bool open_ = false;
    bool focus_name_ = false;
};

}  // namespace patina::editor
