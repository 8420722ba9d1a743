// SPDX-License-Identifier: MIT
#include <cmath>

#include "editor/panels/panels.h"

namespace patina::editor {
namespace {

void draw_card(Ui& ui, const Rect& card, int index, const Shown& shown, render::View& view) {
    const render::ChannelViewInfo& row = render::kChannelViews[static_cast<std::size_t>(index)];
    const std::string key = std::to_string(index);
    const bool on = view.channel == row.view;
    const Tip tip{std::string(row.label), std::string(row.tooltip) + " Click to enlarge.", key};
    const Press pressed = press(
        ui, card, {.label = row.label, .kind = "channel", .value = on ? "on" : "off", .tip = &tip});
    Rect rest = card;
    const Rect label = rest.cut_bottom(ui.px(14));
    rest.cut_bottom(ui.px(4));
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

Requests draw_channel_strip(Ui& ui, const Rect& rect, const Shown& shown, ViewState& state) {
    if (rect.empty()) return {};
    const Place place(ui, "Channels");
    fill(ui, rect, theme::kPanel, 6, ImDrawFlags_RoundCornersBottom);
    if (!shown.document) return {};
    Rect rest = rect;
    rest = {rest.x0 + ui.px(8), rest.y0 + ui.px(8), rest.x1 - ui.px(8), rest.y1 - ui.px(6)};
    const float gap = ui.px(rect.width() / ui.scale > 900 ? 6 : 4);
    const float width =
        (rest.width() - gap * (render::kStripChannelCount - 1)) / render::kStripChannelCount;
    for (int i = 0; i < render::kStripChannelCount; ++i) {
        const float x = rest.x0 + static_cast<float>(i) * (width + gap);
        draw_card(ui, {std::round(x), rest.y0, std::round(x + width), rest.y1}, i, shown,
                  state.view);
    }
    return {};
}

}  // namespace patina::editor
