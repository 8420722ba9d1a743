// SPDX-License-Identifier: MIT
#pragma once

#include "editor/state/requests.h"
#include "editor/state/view_state.h"
#include "editor/widgets/ui.h"

namespace patina::editor {

/// The controls of an adjustment layer, cut off the top of `rest`. Nothing for other layers.
Requests draw_adjustment(Ui& ui, Rect& rest, const Material& material, const Layer& layer,
                         ViewState& view);

/// The same of a mask entry that is an adjustment.
Requests draw_adjustment(Ui& ui, Rect& rest, const Material& material, const Layer& layer,
                         const MaskEntry& entry, ViewState& view);

}  // namespace patina::editor
