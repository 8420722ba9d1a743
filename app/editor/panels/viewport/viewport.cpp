// SPDX-License-Identifier: MIT
#include <cmath>

#include "document/edits.h"
#include "editor/panels/panels.h"
#include "editor/panels/viewport/parts.h"

namespace patina::editor {
namespace {

constexpr float kDegreesPerPixel = 0.35f;
constexpr float kLightDegreesPerPixel = 0.5f;

Requests move_camera(Ui& ui, const Rect& rect, const Press& pressed, const Shown& shown,
                     ViewState& state) {
    Requests requests;
    render::Camera& camera = state.view.camera;
    const ImGuiIO& io = ImGui::GetIO();
    const ImVec2 moved = io.MouseDelta;
    const bool over = pressed.hovered || pressed.held;
    if (pressed.held && (moved.x != 0.0f || moved.y != 0.0f)) {
        if (io.KeyShift) {
            const float turned = shown.document->environment.rotation_degrees +
                                 moved.x * kLightDegreesPerPixel / ui.scale;
            requests.edit(set_environment_rotation(std::remainder(turned, 360.0f)));
        } else if (state.tool == ViewportTool::Move) {
            camera = render::orbited(camera, -moved.x * kDegreesPerPixel / ui.scale,
                                     moved.y * kDegreesPerPixel / ui.scale);
        }
    }
    if (pressed.released) ui.edit_ended = true;
    if (over && ImGui::IsMouseDragging(ImGuiMouseButton_Middle, 0.0f))
        camera = render::panned(camera, -moved.x / rect.height(), moved.y / rect.height());
    if (over && ImGui::IsMouseDragging(ImGuiMouseButton_Right, 0.0f))
        camera = render::dollied(camera, -moved.y / (ui.scale * 160.0f));
    if (pressed.hovered && io.MouseWheel != 0.0f)
        camera = render::dollied(camera, io.MouseWheel * 0.25f);
    return requests;
}

Requests pick_with(const Rect& rect, const Press& pressed, ViewState& state) {
    Requests requests;
    const ImVec2 mouse = ImGui::GetMousePos();
    const float x = (mouse.x - rect.x0) / rect.width();
    const float y = (mouse.y - rect.y0) / rect.height();
    const ImVec2 dragged = ImGui::GetMouseDragDelta(ImGuiMouseButton_Left, 4.0f);
    const bool probing = state.tool == ViewportTool::Probe;
    if (pressed.clicked && dragged.x == 0.0f && dragged.y == 0.0f)
        requests.ask(PickAt{x, y, probing});
    // With the numbers beside it a click says which point they are of.
    const bool numbers = is_comparing(state) && (state.right_tab == RightTab::Inspect ||
                                                 render::shows_difference_beside(state.view));
    if (pressed.clicked && numbers && dragged.x == 0.0f && dragged.y == 0.0f)
        state.crosshair = glm::vec2(x, y);
    return requests;
}

}  // namespace

Requests draw_viewport(Ui& ui, const Rect& rect, const Shown& shown, ViewState& state) {
    const Place place(ui, "Viewport");
    if (!shown.document) {
        Requests requests = draw_empty(ui, rect);
        requests.append(draw_toasts(ui, rect, shown.toasts));
        return requests;
    }
    fill(ui, rect, rgb(0x1A1A1A));
    picture(ui, rect, shown.viewport);
    Requests requests;
    const render::View& view = state.view;
    const bool split =
        view.compare == render::CompareMode::Split && view.channel == render::ChannelView::Final;
    // What lies on top takes the pointer first.
    requests.append(draw_toasts(ui, rect, shown.toasts));
    requests.append(draw_tools(ui, rect, shown, state));
    draw_part_note(ui, rect, shown, state);
    if (split) draw_divider(ui, rect, state.view);
    draw_labels(ui, rect, shown, view);
    draw_seams(ui, rect, view);
    if (!shown.comparison || !shown.comparison->values || view_columns(view) == 1)
        requests.append(draw_gizmo(ui, rect, view.camera));
    if (shown.toasts.empty()) draw_scale(ui, rect, view);
    const Press pressed =
        press(ui, rect, {.label = "Model", .kind = "viewport", .focusable = false});
    requests.append(move_camera(ui, rect, pressed, shown, state));
    requests.append(pick_with(rect, pressed, state));
    if (state.crosshair) draw_crosshairs(ui, rect, view, *state.crosshair);
    if (shown.comparison && shown.comparison->values)
        draw_luminances(ui, rect, view, *shown.comparison->values);
    if (shown.hovered && pressed.hovered && !pressed.held)
        draw_probe(ui, rect, *shown.hovered, shown, view.channel);
    return requests;
}

}  // namespace patina::editor
