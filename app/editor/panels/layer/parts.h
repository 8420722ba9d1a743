// SPDX-License-Identifier: MIT
#pragma once

/// The parts of the Layer tab, one file each; every part cuts what it needs off the top of `rest`.

#include <optional>

#include "document/parameters.h"
#include "editor/state/requests.h"
#include "editor/state/shown.h"
#include "editor/state/view_state.h"
#include "editor/widgets/ui.h"

namespace patina::editor {

/// What all parts of the tab are about.
struct LayerSubject {
    const Material& material;
    const Layer& layer;
    const Shown& shown;
    bool wide = true;  ///< room for the Blend column
};

/// Whether heights decide what the layer covers, and the numbers of that while they do.
Requests draw_height_blend(Ui& ui, Rect& rest, const LayerSubject& subject);
Requests draw_channels(Ui& ui, Rect& rest, const LayerSubject& subject, ViewState& view);
Requests draw_mask(Ui& ui, Rect& rest, const LayerSubject& subject, ViewState& view);
Requests draw_uv(Ui& ui, Rect& rest, const LayerSubject& subject, ViewState& view);
Requests draw_bake(Ui& ui, Rect& rest, const LayerSubject& subject, ViewState& view);

/// An opacity as a bare field; its unit only where there is room.
std::optional<double> percent(Ui& ui, const Rect& rect, Parameter parameter, float value,
                              bool with_unit);

}  // namespace patina::editor
