// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "editor/panels/viewport/parts.h"
#include "editor/widgets/buttons.h"
#include "editor/widgets/number_text.h"

namespace patina::editor {

void draw_divider(Ui& ui, const Rect& rect, render::View& view) {
    const float x = std::round(rect.x0 + view.divider * rect.width());
    const Tip tip{"Divider", "Drag to compare, Left and Right move it by 1 %"};
    const Rect grab{x - ui.px(6), rect.y0, x + ui.px(6), rect.y1};
    const Rect handle = Rect{x, rect.y0, x, rect.y1}.centered(ui.px(30), ui.px(30));
    const std::string value = number_text(static_cast<double>(view.divider), {.decimals = 3});
    const Press on_handle = press(
        ui, handle,
        {.label = "Divider", .kind = "handle", .value = value, .tip = &tip, .focusable = false});
    const Press on_line =
        press(ui, grab, {.label = "Divider line", .kind = "handle", .focusable = false});
    const bool lit = on_handle.hovered || on_line.hovered || on_handle.held || on_line.held;
    if (lit) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if ((on_handle.held || on_line.held) && ImGui::GetIO().MouseDelta.x != 0.0f)
        view.divider =
            std::clamp(view.divider + ImGui::GetIO().MouseDelta.x / rect.width(), 0.0f, 1.0f);
    fill(ui, {x - ui.px(2), rect.y0, x + ui.px(2), rect.y1}, theme::kBase);
    fill(ui, {x - ui.px(1), rect.y0, x + ui.px(1), rect.y1},
         on_handle.held || on_line.held ? theme::kAccentHigh : theme::kText);
    disc(ui, x, handle.center_y(), 15, theme::kBase);
    disc(ui, x, handle.center_y(), 13, lit ? IM_COL32_WHITE : theme::kText);
    const float y = handle.center_y();
    const float a = ui.px(3);
    const float b = ui.px(6);
    const float h = ui.px(4);
    for (const float side : {-1.0f, 1.0f}) {
        ImDrawList& list = *ImGui::GetWindowDrawList();
        list.PathLineTo(ImVec2(x + side * a, y - h));
        list.PathLineTo(ImVec2(x + side * b, y));
        list.PathLineTo(ImVec2(x + side * a, y + h));
        list.PathStroke(theme::kBase, 0, 1.8f * ui.scale);
    }
}

Requests draw_tools(Ui& ui, const Rect& rect, const Shown& shown, ViewState& view) {
    Requests requests;
    const Place place(ui, "Tools");
    constexpr int kTools = 6;
    const float height = ui.px(6 + 26 * kTools + 2 * (kTools - 1));
    Rect box{rect.x1 - ui.px(40), rect.y0 + ui.px(8), rect.x1 - ui.px(8),
             rect.y0 + ui.px(8) + height};
    fill(ui, box, theme::kOverlay, 6);
    box = box.inset(ui.px(3));
    const auto button = [&](const IconButton& spec) {
        const bool clicked = icon_button(ui, box.cut_top(ui.px(26)), spec);
        box.cut_top(ui.px(2));
        return clicked;
    };
    const bool open = shown.document != nullptr;
    if (button({.icon = icon::kFrame, .label = "Frame the model", .key = "F", .enabled = open}))
        requests.ask(Action::FrameModel);
    const Rect camera_place = Rect{box.x0, box.y0, box.x1, box.y0 + ui.px(26)};
    if (button({.icon = icon::kVideo,
                .label = "Camera",
                .tooltip = "Where to look from, field of view, orthographic",
                .enabled = open}))
        ImGui::OpenPopup("camera menu");
    requests.append(draw_camera_menu(ui, camera_place, shown, view.view.camera));
    const bool probing = view.tool == ViewportTool::Probe;
    if (button({.icon = icon::kEyedropper,
                .label = "Read and explain",
                .tooltip = "Shows every channel under the pointer; click explains a texel",
                .key = "I",
                .enabled = open,
                .on = probing}))
        requests.ask(Action::ProbeTool);
    const bool uv = view.view.channel == render::ChannelView::UvChecker;
    if (button({.icon = icon::kGrid,
                .label = "UV checker",
                .tooltip = "Shows how the first texture coordinates lie on the model",
                .key = "U",
                .enabled = open,
                .on = uv}))
        requests.ask(Action::ShowUv);
    if (button({.icon = icon::kSun,
                .label = "Lights",
                .tooltip = "Opens the lights in the Material tab",
                .enabled = open}))
        requests.ask(Action::ShowLights);
    if (button({.icon = icon::kCamera, .label = "Save the view", .enabled = open}))
        requests.ask(Action::SaveView);
    return requests;
}

Requests draw_gizmo(Ui& ui, const Rect& rect, const render::Camera& camera) {
    Requests requests;
    const Place place(ui, "Axes");
    const glm::mat4 view = render::view_from_world(camera);
    const float x = rect.x0 + ui.px(44);
    const float y = rect.y1 - ui.px(44);
    struct Axis {
        const char* name;
        ImU32 color;
        glm::vec3 tip;  ///< in view space
        Action from, from_behind;
    };
    std::array<Axis, 3> axes = {
        {{"X", rgb(0xD9655B), glm::vec3(view[0]), Action::LookFromRight, Action::LookFromLeft},
         {"Y", rgb(0x7FB14F), glm::vec3(view[1]), Action::LookFromTop, Action::LookFromBottom},
         {"Z", rgb(0x5B8FD9), glm::vec3(view[2]), Action::LookFromFront, Action::LookFromBack}}};
    std::sort(axes.begin(), axes.end(),
              [](const Axis& a, const Axis& b) { return a.tip.z < b.tip.z; });
    for (const Axis& axis : axes) {
        const float tip_x = x + 25 * ui.scale * axis.tip.x;
        const float tip_y = y - 25 * ui.scale * axis.tip.y;
        line(ui, x, y, tip_x, tip_y, axis.color, 2);
        const Rect letter = Rect{tip_x, tip_y, tip_x, tip_y}.centered(ui.px(14), ui.px(14));
        // Half a degree from the axis counts as on it.
        const Action action = axis.tip.z > 0.9999f ? axis.from_behind : axis.from;
        const Tip tip{std::string(info(action).label),
                      "Looks along this axis, a second click from the other side"};
        const Press pressed = press(
            ui, letter, {.label = axis.name, .kind = "axis", .tip = &tip, .focusable = false});
        if (pressed.clicked) requests.ask(action);
        disc(ui, tip_x, tip_y, pressed.hovered ? 8.5f : 7.0f, axis.color);
        text(ui, letter, ui.fonts.medium11, rgb(0x0D0D0D), axis.name, Align::Center);
    }
    return requests;
}

}  // namespace patina::editor
