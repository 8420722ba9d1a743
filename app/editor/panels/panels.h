// SPDX-License-Identifier: MIT
#pragma once

/// The panels, one file each. A panel draws what is `shown` into its rectangle, may change the
/// ViewState, and returns edits and requests. No panel includes GL, reads a file or calls another.

#include "editor/state/requests.h"
#include "editor/state/shown.h"
#include "editor/state/view_state.h"
#include "editor/widgets/ui.h"

namespace patina::editor {

Requests draw_top_bar(Ui& ui, const Rect& rect, const Shown& shown, ViewState& view);
Requests draw_materials_panel(Ui& ui, const Rect& rect, const Shown& shown, ViewState& view);
Requests draw_layers_panel(Ui& ui, const Rect& rect, const Shown& shown, ViewState& view);
Requests draw_history_panel(Ui& ui, const Rect& rect, const Shown& shown, ViewState& view);
Requests draw_viewport_bar(Ui& ui, const Rect& rect, const Shown& shown, ViewState& view);
Requests draw_viewport(Ui& ui, const Rect& rect, const Shown& shown, ViewState& view);
/// Where the strip in `rect` shows the first of its pictures, which are all as large.
Rect channel_picture(const Ui& ui, const Rect& rect);
Requests draw_channel_strip(Ui& ui, const Rect& rect, const Shown& shown, ViewState& view);
/// Below two views and their difference: how often it is how large.
Requests draw_difference_panel(Ui& ui, const Rect& rect, const Shown& shown, ViewState& view);
/// Its bars over the heat map's scale, from 0 to `range`.
void draw_difference_plot(Ui& ui, const Rect& rect, const render::DifferenceStats& stats,
                          float range);
Requests draw_shelf(Ui& ui, const Rect& rect, const Shown& shown, ViewState& view);
/// Follows a card or row that can be dragged to the model. True when it was clicked, and neither
/// dragged away nor dropped again; the second click of a double one is none.
bool clicked_or_dragged(const Ui& ui, const Press& pressed, DragToModel dragged, ViewState& view);
/// Carries what is dragged there: its ghost, and the drop on the model or the layer list.
Requests carry_to_model(Ui& ui, const Rect& viewport, const Rect& layers, const Shown& shown,
                        ViewState& view);
Requests draw_status_bar(Ui& ui, const Rect& rect, const Shown& shown, ViewState& view);

/// The right side: its tabs and the chosen one, but for the layers of a narrow window.
Requests draw_properties(Ui& ui, const Rect& rect, bool narrow, const Shown& shown,
                         ViewState& view);
Requests draw_layer_tab(Ui& ui, const Rect& rect, const Shown& shown, ViewState& view);
Requests draw_material_tab(Ui& ui, const Rect& rect, const Shown& shown, ViewState& view);
/// A section of it: which parts of the model are drawn with the material.
Requests draw_material_parts(Ui& ui, Rect& rest, const Shown& shown, ViewState& view);
Requests draw_explain_tab(Ui& ui, const Rect& rect, const Shown& shown, ViewState& view);
Requests draw_compare_tab(Ui& ui, const Rect& rect, const Shown& shown, ViewState& view);

}  // namespace patina::editor
