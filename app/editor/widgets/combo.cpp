// SPDX-License-Identifier: MIT
#include "editor/widgets/combo.h"

#include <imgui_internal.h>

#include "editor/widgets/popup_menu.h"
#include "editor/widgets/wheel.h"

namespace patina::editor {
namespace {

std::string_view value_of(const ComboSpec& spec, std::span<const ComboItem> items, int chosen) {
    if (!spec.shown_value.empty()) return spec.shown_value;
    if (chosen < 0 || chosen >= static_cast<int>(items.size())) return {};
    return items[static_cast<std::size_t>(chosen)].label;
}

void paint(const Ui& ui, const Rect& rect, const ComboSpec& spec, std::string_view value,
           const Press& pressed) {
    const ImFont* font = ui.fonts.value12;
    if (spec.flat) {
        const float end = text(ui, {rect.x0, rect.y0, rect.x1 - ui.px(12), rect.y1},
                               ui.fonts.caption11, theme::kText2, value);
        icon_glyph(ui, {end + ui.px(2), rect.y0, end + ui.px(12), rect.y1}, icon::kAngleDown,
                   theme::kText2, 11);
        return;
    }
    const ImU32 color = pressed.held      ? theme::kFieldPressed
                        : pressed.hovered ? theme::kFieldHover
                                          : theme::kField;
    fill(ui, rect, color, 4);
    Rect rest = rect.inset(ui.px(spec.picture != nullptr ? 4 : 8), 0);
    const Rect angle = rest.cut_right(ui.px(spec.picture != nullptr ? 14 : 10));
    icon_glyph(ui, angle, icon::kAngleDown, theme::kText3, 11);
    rest.x1 -= ui.px(4);
    if (spec.picture != nullptr) {
        const Rect frame =
            rest.cut_left(ui.px(spec.picture_width)).centered(ui.px(spec.picture_width), ui.px(18));
        fill(ui, frame, rgb(0x0D0D0D), 3);
        picture(ui, frame, *spec.picture, 3);
        rest.cut_left(ui.px(6));
    }
    if (!spec.shown_label.empty()) {
        rest.x0 = text(ui, rest, font, theme::kText2, spec.shown_label);
        rest.x0 += ui.px(7);
    }
    text(ui, rest, font, theme::kText, value);
}

/// The next choice that can be taken, up or down the list; nothing at its end.
std::optional<int> neighbour(std::span<const ComboItem> items, int chosen, int step) {
    const int count = static_cast<int>(items.size());
    for (int next = chosen + step; next >= 0 && next < count; next += step)
        if (items[static_cast<std::size_t>(next)].enabled) return next;
    return std::nullopt;
}

/// -1, 0 or 1: where the wheel or the arrows lead.
int wanted_step(Ui& ui, const Press& pressed) {
    if (pressed.focused) {
        ui.focus.take({ImGuiKey_UpArrow, ImGuiKey_DownArrow});
        if (ui.focus.row_step() != 0) return ui.focus.row_step();
    }
    return -ctrl_wheel_step(pressed);
}

}  // namespace

std::optional<int> combo(Ui& ui, const Rect& rect, const ComboSpec& spec,
                         std::span<const ComboItem> items, int chosen) {
    const std::string_view value = value_of(spec, items, chosen);
    const Tip tip{std::string(spec.label), std::string(spec.tooltip), std::string(spec.key)};
    const Faded faded(ui, !spec.enabled);
    const Press pressed = press(ui, rect,
                                {.label = spec.label,
                                 .kind = "combo",
                                 .value = value,
                                 .enabled = spec.enabled,
                                 .tip = &tip});
    paint(ui, rect, spec, value, pressed);
    ImGui::PushID(static_cast<int>(pressed.id));
    if (pressed.clicked) ImGui::OpenPopup("combo");
    std::optional<int> result;
    if (const int step = wanted_step(ui, pressed); step != 0)
        result = neighbour(items, chosen, step);
    place_popup(rect, ui.px(2));
    if (PopupMenu menu(ui, "combo", rect.width() / ui.scale); menu.open()) {
        std::string_view group;
        for (std::size_t i = 0; i < items.size(); ++i) {
            const ComboItem& item = items[i];
            if (item.group != group) menu.heading(item.group);
            group = item.group;
            const int index = static_cast<int>(i);
            if (menu.item({.label = item.label,
                           .enabled = item.enabled,
                           .ticked = index == chosen,
                           .tooltip = item.tooltip}) &&
                index != chosen)
                result = index;
        }
    }
    ImGui::PopID();
    return result;
}

}  // namespace patina::editor
