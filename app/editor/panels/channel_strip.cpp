// SPDX-License-Identifier: MIT
#include <cmath>

#include "editor/panels/panels.h"

namespace patina::editor {
namespace {

/// Where the card of channel `index` lies, its label with it.
Rect card_rect(const Ui& ui, const Rect& strip, int index) {
    const float gap = ui.px(strip.width() / ui.scale > 900 ? 6 : 4);
    const float x0 = strip.x0 + ui.px(8);
    const float inner = strip.x1 - ui.px(8) - x0;
    const float width = (inner - gap * (render::kStripChannelCount - 1)) /
                        static_cast<float>(render::kStripChannelCount);
    const float x = x0 + static_cast<float>(index) * (width + gap);
    return {std::round(x), strip.y0 + ui.px(8), std::round(x + width), strip.y1 - ui.px(6)};
}

/// Takes the label's rectangle off the bottom of `card`, which leaves the picture's.
Rect cut_label(const Ui& ui, Rect& card) {
    const Rect label = card.cut_bottom(ui.px(14));
    card.cut_bottom(ui.px(4));
    return label;
}

void draw_card(Ui& ui, const Rect& card, int index, const Shown& shown, render::View& view) {
    const render::ChannelViewInfo& row = render::kChannelViews[static_cast<std::size_t>(index)];
    const std::string key = std::to_string(index);
    const bool on = view.channel == row.view;
    const Tip tip{std::string(row.label), std::string(row.tooltip) + " Click to enlarge.", key};
    const Press pressed = press(
        ui, card, {.label = row.label, .kind = "channel", .value = on ? "on" : "off", .tip = &tip});
    Rect rest = card;
    const Rect label = cut_label(ui, rest);
    fill(ui, rest, rgb(0x1A1A1A), 3);
    if (shown.strip.texture != nullptr) {
        // The strip is one picture, its first row at the bottom as OpenGL has it.
        const float share = 1.0f / render::kStripChannelCount;
        const auto at = static_cast<float>(index);
        picture(ui, rest,
                {shown.strip.texture, ImVec2(at * share, 1.0f), ImVec2((at + 1) * share, 0.0f)}, 3);
    }
    if (on)
        outline(ui, rest.inset(-ui.px(1)), theme::kAccent, 4, 2);
    else if (pressed.hovered)
        outline(ui, rest, rgb(0xC8C8C8), 3);
    const float chip_width = text_width(ui.fonts.caption11, key) + ui.px(8);
    const Rect chip{rest.x0 + ui.px(3), rest.y0 + ui.px(3), rest.x0 + ui.px(3) + chip_width,
                    rest.y0 + ui.px(17)};
    fill(ui, chip, with_alpha(theme::kBase, 208), 2);
    text(ui, chip, ui.fonts.caption11, rgb(0xDADADA), key, Align::Center);
    const ImU32 color = on || pressed.hovered ? theme::kText : theme::kText2;
    text(ui, label, on ? ui.fonts.medium11 : ui.fonts.caption11, color, row.label, Align::Center);
    if (pressed.clicked) view.channel = row.view;
}

}  // namespace

Rect channel_picture(const Ui& ui, const Rect& rect) {
    Rect picture = card_rect(ui, rect, 0);
    cut_label(ui, picture);
    return picture;
}

Requests draw_channel_strip(Ui& ui, const Rect& rect, const Shown& shown, ViewState& state) {
    if (rect.empty()) return {};
    const Place place(ui, "Channels");
    fill(ui, rect, theme::kPanel, 6, ImDrawFlags_RoundCornersBottom);
    if (!shown.document) return {};
    for (int i = 0; i < render::kStripChannelCount; ++i)
        draw_card(ui, card_rect(ui, rect, i), i, shown, state.view);
    return {};
}

}  // namespace patina::editor
