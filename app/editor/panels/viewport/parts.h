// SPDX-License-Identifier: MIT
#pragma once

/// What lies on the viewport's picture, each part drawn into the viewport's whole rectangle.

#include <span>

#include "editor/state/requests.h"
#include "editor/state/shown.h"
#include "editor/state/view_state.h"
#include "editor/widgets/ui.h"

namespace patina::editor {

/// What each side shows and what it costs.
void draw_labels(Ui& ui, const Rect& rect, const Shown& shown, const render::View& view);
/// Says that something else than the whole material is on screen, and ends it.
void draw_part_note(Ui& ui, const Rect& rect, const Shown& shown, ViewState& state);

void draw_divider(Ui& ui, const Rect& rect, render::View& view);
Requests draw_tools(Ui& ui, const Rect& rect, const Shown& shown, ViewState& view);
/// The popup "camera menu", where it is open: directions to look from, projection, field of view,
/// cameras of the file.
Requests draw_camera_menu(Ui& ui, const Rect& anchor, const Shown& shown, render::Camera& camera);
/// The world's axes as the camera sees them; the nearest is drawn last. A click on one looks along
/// it, a second click from the other side.
Requests draw_gizmo(Ui& ui, const Rect& rect, const render::Camera& camera);

/// What grey or heat stands for, where the view shows a scalar or a difference.
void draw_scale(Ui& ui, const Rect& rect, const render::View& view);

/// Every channel under the pointer.
void draw_probe(Ui& ui, const Rect& rect, const render::Probe& probe, const Shown& shown,
                render::ChannelView current);
/// Between views beside each other.
void draw_seams(const Ui& ui, const Rect& rect, const render::View& view);
/// The same point of the model in every view of it; `at` in shares of the rectangle.
void draw_crosshairs(const Ui& ui, const Rect& rect, const render::View& view, const glm::vec2& at);
/// A small plate at the bottom of each view: the luminance under the crosshair.
void draw_luminances(Ui& ui, const Rect& rect, const render::View& view,
                     const render::SideValues& values);

Requests draw_toasts(Ui& ui, const Rect& rect, std::span<const ToastShown> toasts);
/// Where no model is open yet.
Requests draw_empty(Ui& ui, const Rect& rect);

}  // namespace patina::editor
