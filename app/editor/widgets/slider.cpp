// SPDX-License-Identifier: MIT
#include "editor/widgets/slider.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "editor/widgets/arithmetic.h"
#include "editor/widgets/number_text.h"
#include "editor/widgets/popup_menu.h"
#include "editor/widgets/text_field.h"
#include "editor/widgets/wheel.h"

namespace patina::editor {
namespace {

std::string shown(const NumberSpec& spec, double value) {
    return number_text(
        value * spec.display_scale,
        {.decimals = spec.decimals, .unit = spec.unit, .always_signed = spec.always_signed});
}

double allowed(const NumberSpec& spec, double value) {
    if (spec.whole) value = std::round(value);
    return std::clamp(value, spec.minimum, spec.maximum);
}

/// The stored value that is shown exactly as `value` is: what a drag stops at.
double rounded_to_shown(const NumberSpec& spec, double value) {
    const double unit = std::pow(10.0, spec.decimals) * spec.display_scale;
    return allowed(spec, std::round(value * unit) / unit);
}

/// A drag keeps its own unrounded share, so that slow drags are not lost to rounding.
std::optional<double> dragged(const Ui& ui, const Rect& rect, const NumberSpec& spec, double value,
                              const Press& press) {
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    float& share = *storage.GetFloatRef(press.id);
    if (press.started) share = static_cast<float>(slider_share(spec, value));
    const ImGuiIO& io = ImGui::GetIO();
    if (!press.held || io.MouseDelta.x == 0.0f || press.started) return std::nullopt;
    const float slow = io.KeyShift ? 0.1f : 1.0f;
    double next = value;
    if (spec.drag_per_pixel > 0.0) {
        const double moved = static_cast<double>(io.MouseDelta.x * slow / ui.scale);
        next = value + moved * spec.drag_per_pixel;
    } else {
        share = std::clamp(share + slow * io.MouseDelta.x / rect.width(), 0.0f, 1.0f);
        next = slider_value(spec, static_cast<double>(share));
    }
    next = rounded_to_shown(spec, next);
    return next != value ? std::optional(next) : std::nullopt;
}

std::optional<double> stepped(const NumberSpec& spec, double value, const Press& press) {
    const int step = ctrl_wheel_step(press);
    if (step == 0) return std::nullopt;
    return allowed(spec, value + step * spec.step);
}

/// The arrows, by one step; Shift takes a tenth.
std::optional<double> stepped_by_keys(Ui& ui, const NumberSpec& spec, double value,
                                      const Press& press) {
    if (!press.focused) return std::nullopt;
    ui.focus.take({ImGuiKey_LeftArrow, ImGuiKey_RightArrow});
    const int step = ui.focus.arrow_step();
    if (step == 0) return std::nullopt;
    const double size = ImGui::GetIO().KeyShift && !spec.whole ? 0.1 * spec.step : spec.step;
    return allowed(spec, value + step * size);
}

std::optional<double> value_menu(Ui& ui, const NumberSpec& spec, double value, const Press& press) {
    ImGui::PushID(static_cast<int>(press.id));
    if (press.right_clicked) ImGui::OpenPopup("value");
    std::optional<double> chosen;
    if (PopupMenu menu(ui, "value"); menu.open()) {
        const std::string standard = "Reset to " + shown(spec, spec.standard);
        if (menu.item({.icon = icon::kReset, .label = standard})) chosen = spec.standard;
        if (menu.item({.icon = icon::kCopy, .label = "Copy value"}))
            ImGui::SetClipboardText(
                number_text(value * spec.display_scale, {.decimals = spec.decimals}).c_str());
        const char* clipboard = ImGui::GetClipboardText();
        const std::optional<double> pasted = value_of_sum(clipboard == nullptr ? "" : clipboard);
        if (menu.item(
                {.icon = icon::kPaste, .label = "Paste value", .enabled = pasted.has_value()}))
            chosen = allowed(spec, *pasted / spec.display_scale);
    }
    ImGui::PopID();
    return chosen;
}

void paint(const Ui& ui, const Rect& rect, const NumberSpec& spec, double value,
           const Press& press) {
    const bool lit = press.hovered && spec.enabled;
    fill(ui, rect, lit ? theme::kFieldHover : theme::kField, 4);
    if (spec.level) {
        const float share = static_cast<float>(slider_share(spec, value));
        Rect level = rect;
        level.x1 = rect.x0 + std::round(share * rect.width());
        const ImDrawFlags corners =
            share >= 0.99f ? ImDrawFlags_RoundCornersAll : ImDrawFlags_RoundCornersLeft;
        if (level.width() >= 1.0f) {
            fill(ui, level, press.held ? theme::kFillActive : theme::kFill, 4, corners);
            Rect underline = level.cut_bottom(ui.px(2));
            underline.x0 += ui.px(1);
            if (share >= 0.99f) underline.x1 -= ui.px(1);
            fill(ui, underline, press.held ? theme::kAccentHigh : theme::kLevelLine, 1);
        }
    }
    if (press.held) outline(ui, rect, theme::kAccent, 4, 1);
    const float padding = ui.px(rect.width() < ui.px(60) ? 6 : 8);
    Rect inner = rect.inset(padding, 0);
    const std::string words = shown(spec, value);
    const float width = text_width(ui.fonts.value12, words);
    text(ui, inner.cut_right(std::ceil(width) + 1.0f), ui.fonts.value12, theme::kText, words,
         Align::Right);
    inner.x1 -= ui.px(6);
    if (!spec.shown_label.empty())
        text(ui, inner, ui.fonts.value12, theme::kText2, spec.shown_label);
}

}  // namespace

double slider_share(const NumberSpec& spec, double value) {
    if (spec.maximum <= spec.minimum) return 0.0;
    if (spec.curve == SliderCurve::Logarithmic && spec.minimum > 0.0)
        return std::clamp(std::log(value / spec.minimum) / std::log(spec.maximum / spec.minimum),
                          0.0, 1.0);
    return std::clamp((value - spec.minimum) / (spec.maximum - spec.minimum), 0.0, 1.0);
}

double slider_value(const NumberSpec& spec, double share) {
    if (spec.curve == SliderCurve::Logarithmic && spec.minimum > 0.0)
        return spec.minimum * std::pow(spec.maximum / spec.minimum, share);
    return spec.minimum + share * (spec.maximum - spec.minimum);
}

NumberSpec number_spec(Parameter parameter) {
    const ParameterInfo& row = info(parameter);
    return {.label = row.label,
            .shown_label = row.label,
            .minimum = row.minimum,
            .maximum = row.maximum,
            .standard = row.standard,
            .step = row.step,
            .display_scale = row.display_scale,
            .decimals = row.decimals,
            .unit = row.unit,
            .whole = row.kind == ParameterKind::Integer,
            .curve = row.curve,
            .tooltip = row.tooltip};
}

NumberSpec compact_number_spec(Parameter parameter) {
    NumberSpec spec = number_spec(parameter);
    spec.shown_label = {};
    spec.unit = {};
    return spec;
}

std::optional<double> number_field(Ui& ui, const Rect& rect, const NumberSpec& spec, double value) {
    const Faded faded(ui, !spec.enabled);
    const Tip tip{std::string(spec.label), std::string(spec.tooltip), std::string(spec.key)};
    const Press pressed = press(ui, rect,
                                {.label = spec.label,
                                 .kind = spec.level ? "slider" : "number",
                                 .value = shown(spec, value),
                                 .enabled = spec.enabled,
                                 .tip = &tip});
    if (ui.typing.id == pressed.id && pressed.id != 0) {
        fill(ui, rect, theme::kFieldHover, 4);
        const auto words = typed(ui, pressed.id, rect, ui.fonts.value12);
        if (!words) return std::nullopt;
        ui.edit_ended = true;
        const std::optional<double> sum = value_of_sum(*words);
        return sum ? std::optional(allowed(spec, *sum / spec.display_scale)) : std::nullopt;
    }
    paint(ui, rect, spec, value, pressed);
    if (!spec.enabled) return std::nullopt;
    const bool entered = pressed.focused && ui.focus.pressed();
    if (pressed.double_clicked || entered || (pressed.started && ImGui::GetIO().KeyCtrl)) {
        ImGui::ClearActiveID();
        start_typing(ui, pressed.id,
                     number_text(value * spec.display_scale, {.decimals = spec.decimals}));
        return std::nullopt;
    }
    if (pressed.hovered || pressed.held) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (pressed.released) ui.edit_ended = true;
    if (const auto next = dragged(ui, rect, spec, value, pressed)) return next;
    if (const auto next = value_menu(ui, spec, value, pressed)) {
        ui.edit_ended = true;
        return next;
    }
    if (const auto next = stepped_by_keys(ui, spec, value, pressed)) return next;
    return stepped(spec, value, pressed);
}

}  // namespace patina::editor
