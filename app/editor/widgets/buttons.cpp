// SPDX-License-Identifier: MIT
#include "editor/widgets/buttons.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace patina::editor {
namespace {

ImU32 button_color(const Press& pressed) {
    return pressed.held      ? theme::kFieldPressed
           : pressed.hovered ? theme::kFieldHover
                             : theme::kField;
}

void paint_box(const Ui& ui, const Rect& rect, bool on, bool hovered) {
    const Rect box = rect.centered(ui.px(16), ui.px(16));
    if (on) {
        fill(ui, box, hovered ? theme::kAccentHigh : theme::kAccent, 4);
        icon_glyph(ui, box, icon::kCheck, theme::kInk, 11);
    } else {
        outline(ui, box, hovered ? theme::kText2 : theme::kCheckboxEdge, 4);
    }
}

const ImFont* font_of(const Ui& ui, const TextButton& button) {
    if (button.main) return ui.fonts.title13;
    return button.link ? ui.fonts.medium13 : ui.fonts.body13;
}

/// All alike where every label fits so; else each has its label's width and its share of the rest.
std::vector<float> segment_widths(const Ui& ui, std::span<const std::string_view> labels,
                                  float width) {
    const auto count = static_cast<float>(labels.size());
    std::vector<float> widths;
    float widest = 0.0f;
    float sum = 0.0f;
    for (const std::string_view label : labels) {
        widths.push_back(std::ceil(text_width(ui.fonts.medium12, label)));
        widest = std::max(widest, widths.back());
        sum += widths.back();
    }
    for (float& each : widths)
        each = widest + ui.px(8) <= width / count ? width / count : each + (width - sum) / count;
    return widths;
}

}  // namespace

bool icon_button(Ui& ui, const Rect& rect, const IconButton& button) {
    const float side = ui.px(theme::kIconButton);
    const Rect box = rect.centered(side, std::min(side, rect.height()));
    const Tip tip{std::string(button.label), std::string(button.tooltip), std::string(button.key)};
    const Press pressed = press(ui, box,
                                {.label = button.label,
                                 .kind = "button",
                                 .value = button.on ? "on" : "",
                                 .enabled = button.enabled,
                                 .tip = &tip});
    ImU32 color = button.on ? theme::kAccentHigh : button.color;
    if (!button.enabled) color = theme::kDot;
    if (pressed.hovered) {
        fill(ui, box, pressed.held ? theme::kFieldPressed : theme::kFieldHover, 4);
        if (!button.on) color = theme::kText;
    } else if (button.on) {
        fill(ui, box, theme::kSelected, 4);
    }
    icon_glyph(ui, box, button.icon, color, button.size);
    return pressed.clicked;
}

float text_button_width(const Ui& ui, const TextButton& button) {
    const float words = text_width(font_of(ui, button), button.label);
    return std::ceil(words) + ui.px(button.link ? 16 : 24) +
           (button.icon != nullptr ? ui.px(22) : 0);
}

bool text_button(Ui& ui, const Rect& rect, const TextButton& button) {
    const Tip tip{std::string(button.label), std::string(button.tooltip), std::string(button.key)};
    const Faded faded(ui, !button.enabled);
    const bool says_more = !button.tooltip.empty() || !button.key.empty();
    const Press pressed = press(ui, rect,
                                {.label = button.label,
                                 .kind = "button",
                                 .enabled = button.enabled,
                                 .tip = says_more ? &tip : nullptr});
    ImU32 ink = theme::kText;
    if (button.main) {
        fill(ui, rect, pressed.hovered ? theme::kAccentHigh : theme::kAccent, 4);
        ink = theme::kInk;
    } else if (button.link) {
        ink = pressed.hovered ? theme::kText : theme::kAccentHigh;
    } else {
        fill(ui, rect, button_color(pressed), 4);
    }
    Rect inner = rect.inset(ui.px(button.link ? 8 : 12), 0);
    if (button.icon != nullptr) {
        icon_glyph(ui, inner.cut_left(ui.px(16)), button.icon,
                   button.main ? theme::kInk : theme::kText2, 14);
        inner.cut_left(ui.px(6));
    }
    text(ui, inner, font_of(ui, button), ink, button.label);
    return pressed.clicked;
}

bool checkbox(Ui& ui, const Rect& rect, std::string_view label, bool on, std::string_view tooltip,
              bool enabled) {
    const Tip tip{std::string(label), std::string(tooltip)};
    const Faded faded(ui, !enabled);
    const Press pressed = press(ui, rect.centered(ui.px(24), ui.px(24)),
                                {.label = label,
                                 .kind = "checkbox",
                                 .value = on ? "on" : "off",
                                 .enabled = enabled,
                                 .tip = &tip});
    paint_box(ui, rect, on, pressed.hovered);
    return pressed.clicked;
}

bool labelled_checkbox(Ui& ui, const Rect& rect, std::string_view label, bool on,
                       std::string_view tooltip, bool enabled) {
    const Tip tip{std::string(label), std::string(tooltip)};
    const Faded faded(ui, !enabled);
    const Press pressed = press(ui, rect,
                                {.label = label,
                                 .kind = "checkbox",
                                 .value = on ? "on" : "off",
                                 .enabled = enabled,
                                 .tip = tooltip.empty() ? nullptr : &tip});
    Rect rest = rect;
    paint_box(ui, rest.cut_left(ui.px(16)), on, pressed.hovered);
    rest.cut_left(ui.px(8));
    text(ui, rest, ui.fonts.value12, theme::kText, label);
    return pressed.clicked;
}

std::optional<int> segmented(Ui& ui, const Rect& rect, std::span<const std::string_view> labels,
                             int chosen) {
    fill(ui, rect, theme::kField, 4);
    Rect rest = rect.inset(ui.px(2));
    const std::vector<float> widths = segment_widths(ui, labels, rest.width());
    std::optional<int> result;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const bool on = static_cast<int>(i) == chosen;
        const Rect part = rest.cut_left(widths[i]);
        const Press pressed =
            press(ui, part, {.label = labels[i], .kind = "segment", .value = on ? "on" : "off"});
        if (on) fill(ui, part, theme::kFieldPressed, 3);
        const ImU32 color = on || pressed.hovered ? theme::kText : theme::kText2;
        text(ui, part, on ? ui.fonts.medium12 : ui.fonts.value12, color, labels[i], Align::Center);
        if (pressed.clicked && !on) result = static_cast<int>(i);
    }
    return result;
}

bool tab(Ui& ui, Rect& rest, const TabSpec& spec) {
    const ImFont* font = spec.chosen ? ui.fonts.title13 : ui.fonts.medium13;
    // As wide as it would be when chosen, so that its neighbours stay where they are.
    const float width = std::ceil(text_width(ui.fonts.title13, spec.label));
    const Rect box = rest.cut_left(width);
    rest.cut_left(ui.px(16));
    const Press pressed =
        press(ui, box, {.label = spec.label, .kind = "tab", .value = spec.chosen ? "on" : "off"});
    const ImU32 color = spec.chosen || pressed.hovered ? theme::kText : theme::kText2;
    text(ui, box, font, color, spec.label);
    if (spec.chosen) fill(ui, {box.x0, box.y1 - ui.px(2), box.x1, box.y1}, theme::kAccent);
    return pressed.clicked;
}

bool section(Ui& ui, const Rect& rect, const SectionSpec& spec) {
    const Press pressed = press(
        ui, rect, {.label = spec.title, .kind = "section", .value = spec.open ? "open" : "folded"});
    Rect rest = rect;
    rest.cut_left(ui.px(10));
    icon_glyph(ui, rest.cut_left(ui.px(14)), spec.open ? icon::kAngleDown : icon::kAngleRight,
               pressed.hovered ? theme::kText : theme::kText3, 14);
    rest.cut_left(ui.px(6));
    if (!spec.open && !spec.summary.empty()) {
        Rect right = rest;
        right.x1 -= ui.px(12);
        text(ui, right, ui.fonts.caption11, theme::kText3, spec.summary, Align::Right);
    }
    rest.x0 = text(ui, rest, ui.fonts.title13, theme::kText, spec.title);
    rest.cut_left(ui.px(6));
    text(ui, rest, ui.fonts.value12, theme::kText3, spec.count);
    return pressed.clicked;
}

Rect panel_title(Ui& ui, Rect rect, std::string_view title, std::string_view count) {
    rect.cut_left(ui.px(theme::kPadding));
    rect.cut_right(ui.px(6));
    const float end = text(ui, rect, ui.fonts.title13, theme::kText, title);
    Rect rest = rect;
    rest.x0 = end + ui.px(6);
    rest.x0 = text(ui, rest, ui.fonts.value12, theme::kText3, count);
    return rest;
}

void row_tint(const Ui& ui, const Rect& rect, bool selected, bool hovered) {
    if (selected) {
        fill(ui, rect, hovered ? theme::kSelectedHover : theme::kSelected);
        fill(ui, {rect.x0, rect.y0, rect.x0 + ui.px(3), rect.y1}, theme::kAccent);
    } else if (hovered) {
        fill(ui, rect, theme::kRowHover);
    }
}

}  // namespace patina::editor
