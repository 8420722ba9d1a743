// SPDX-License-Identifier: MIT
#pragma once

/// The knobs of a preset, turned before it is laid on.

#include <optional>
#include <vector>

#include "document/preset.h"
#include "editor/state/requests.h"
#include "editor/state/shown.h"
#include "editor/widgets/ui.h"

namespace patina::editor {

class PresetDialog {
  public:
    void open(const Preset& preset);
    bool is_open() const { return preset_.has_value(); }
    /// How the preset is to be laid on, in the frame in which that is chosen.
    std::optional<ApplyPreset> draw(Ui& ui, const Shown& shown);

  private:
    void draw_knobs(Ui& ui, Rect rest);
    Picture ball(Thumbnails& thumbnails);

    std::optional<Preset> preset_;
    std::vector<KnobSetting> knobs_;
    // One ball is made at a time: a drag does not queue up all the places that it goes through.
    std::vector<KnobSetting> ball_asked_;
    std::vector<KnobSetting> ball_shown_;
};

}  // namespace patina::editor
