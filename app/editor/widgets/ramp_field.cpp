// SPDX-License-Identifier: MIT
#include "editor/widgets/ramp_field.h"

#include <fmt/format.h>
#include <imgui_internal.h>

#include <algorithm>

#include "core/formulae/formulae.h"
#include "editor/widgets/color_field.h"
#include "editor/widgets/number_text.h"
#include "editor/widgets/slider.h"

namespace patina::editor {
namespace {

/// What a stop looks like: its colour, or a grey for where its number lies in the range.
glm::vec3 look(const RampSpec& spec, const glm::vec3& value) {
    if (spec.color) return value;
    return glm::vec3((value.x - spec.minimum) / std::max(spec.maximum - spec.minimum, 1e-6f));
}

glm::vec3 ramp_value(const std::vector<RampStop>& stops, float position) {
    formulae::Ramp ramp = {};
    ramp.count = static_cast<int>(stops.size());
    for (std::size_t i = 0; i < stops.size(); ++i) {
        const glm::vec3& value = stops[i].value;
        ramp.stops[i] = {stops[i].position, value.x, value.y, value.z};
    }
    const formulae::Real3 color = formulae::ramp_color(ramp, position);
    return {color.x, color.y, color.z};
}

void paint_bar(const Ui& ui, const Rect& bar, const RampSpec& spec,
               const std::vector<RampStop>& stops) {
    constexpr int kSteps = 48;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    fill(ui, bar, screen_color(look(spec, stops.front().value)), 4);
    for (int i = 0; i < kSteps; ++i) {
        const float left = static_cast<float>(i) / kSteps;
        const float right = static_cast<float>(i + 1) / kSteps;
        const ImU32 a = screen_color(look(spec, ramp_value(stops, left)));
        const ImU32 b = screen_color(look(spec, ramp_value(stops, right)));
        const float inner = bar.width() - 2 * ui.px(1);
        list.AddRectFilledMultiColor(ImVec2(bar.x0 + ui.px(1) + left * inner, bar.y0),
                                     ImVec2(bar.x0 + ui.px(1) + right * inner, bar.y1), a, b, b, a);
    }
}

std::optional<glm::vec3> stop_popup(Ui& ui, const Rect& anchor, const RampSpec& spec,
                                    const RampStop& stop) {
    if (spec.color) return color_popup(ui, anchor, stop.value);
    ImGui::SetNextWindowPos(ImVec2(anchor.x0, anchor.y1 + ui.px(4)), ImGuiCond_Appearing);
    ImGui::SetNextWindowSize(ImVec2(ui.px(180), ui.px(40)));
    std::optional<glm::vec3> result;
    if (ImGui::BeginPopup("color", ImGuiWindowFlags_NoMove)) {
        const ImVec2 corner = ImGui::GetWindowPos();
        const Rect rect{corner.x + ui.px(8), corner.y + ui.px(8), corner.x + ui.px(172),
                        corner.y + ui.px(32)};
        const NumberSpec number{.label = "Stop value",
                                .shown_label = "Value",
                                .minimum = static_cast<double>(spec.minimum),
                                .maximum = static_cast<double>(spec.maximum)};
        const auto next = number_field(ui, rect, number, static_cast<double>(stop.value.x));
        if (next) result = glm::vec3(static_cast<float>(*next));
        ImGui::EndPopup();
    }
    return result;
}

struct StopChange {
    std::optional<RampStop> moved;
    bool removed = false;
};

StopChange stop_handle(Ui& ui, const Rect& bar, const Rect& zone, const RampSpec& spec,
                       const std::vector<RampStop>& stops, std::size_t index) {
    const RampStop& stop = stops[index];
    const float x = bar.x0 + stop.position * bar.width();
    const Rect grab{x - ui.px(7), zone.y0 - ui.px(4), x + ui.px(7), zone.y1 + ui.px(4)};
    const std::string name = fmt::format("Stop {}", index + 1);
    const Tip tip{name, "Drag to move, click to change, right click to remove"};
    const Press pressed = press(ui, grab,
                                {.label = name,
                                 .kind = "stop",
                                 .value = number_text(static_cast<double>(stop.position)),
                                 .tip = &tip});
    const float y = zone.center_y();
    disc(ui, x, y, 4, screen_color(look(spec, stop.value)));
    ring(ui, x, y, 4, pressed.hovered || pressed.held ? theme::kAccentHigh : theme::kText, 1);
    StopChange change;
    ImGui::PushID(static_cast<int>(pressed.id));
    const ImVec2 dragged = ImGui::GetMouseDragDelta(ImGuiMouseButton_Left, 3.0f);
    if (pressed.held && (dragged.x != 0.0f || dragged.y != 0.0f)) {
        const float low = index == 0 ? 0.0f : stops[index - 1].position;
        const float high = index + 1 == stops.size() ? 1.0f : stops[index + 1].position;
        const float at = (ImGui::GetMousePos().x - bar.x0) / bar.width();
        const float next = std::clamp(at, low, high);
        if (next != stop.position) change.moved = RampStop{next, stop.value};
    }
    if (pressed.released) ui.edit_ended = true;
    if (pressed.clicked && dragged.x == 0.0f && dragged.y == 0.0f) ImGui::OpenPopup("color");
    if (const auto value = stop_popup(ui, grab, spec, stop))
        change.moved = RampStop{stop.position, *value};
    change.removed = pressed.right_clicked && stops.size() > 1;
    ImGui::PopID();
    return change;
}

}  // namespace

std::optional<std::vector<RampStop>> ramp_field(Ui& ui, const Rect& rect, const RampSpec& spec,
                                                const std::vector<RampStop>& stops) {
    if (stops.empty()) return std::nullopt;
    Rect bar = rect;
    const Rect zone = bar.cut_bottom(ui.px(10));
    const Place place(ui, spec.label);
    const Tip tip{"Ramp", "What the noise becomes, from 0 to 1. Click to add a stop, 8 at most"};
    const Press pressed = press(
        ui, bar,
        {.label = spec.label, .kind = "ramp", .value = counted(stops.size(), "stop"), .tip = &tip});
    paint_bar(ui, bar, spec, stops);
    std::optional<std::vector<RampStop>> result;
    if (pressed.clicked && stops.size() < static_cast<std::size_t>(kMaxRampStops)) {
        const float at = std::clamp((ImGui::GetMousePos().x - bar.x0) / bar.width(), 0.0f, 1.0f);
        result = stops;
        const auto after = std::find_if(result->begin(), result->end(),
                                        [at](const RampStop& stop) { return stop.position > at; });
        result->insert(after, RampStop{at, ramp_value(stops, at)});
        ui.edit_ended = true;
    }
    for (std::size_t i = 0; i < stops.size(); ++i) {
        const StopChange change = stop_handle(ui, bar, zone, spec, stops, i);
        if (!change.moved && !change.removed) continue;
        result = stops;
        if (change.removed)
            result->erase(result->begin() + static_cast<std::ptrdiff_t>(i));
        else
            (*result)[i] = *change.moved;
    }
    return result;
}

}  // namespace patina::editor
