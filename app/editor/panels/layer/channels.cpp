// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "document/edits.h"
#include "editor/panels/blend_combo.h"
#include "editor/panels/layer/parts.h"
#include "editor/panels/source_editor.h"
#include "editor/widgets/buttons.h"
#include "editor/widgets/slider.h"

namespace patina::editor {
namespace {

/// The columns of a channel's row: 16 4 80 1fr 78 44 with gaps of 4, and no blend when narrow.
struct ChannelColumns {
    Rect box;
    Rect name;
    Rect value;
    Rect blend;
    Rect opacity;
};

ChannelColumns columns_of(const Ui& ui, Rect row, bool wide) {
    ChannelColumns columns;
    const float gap = ui.px(4);
    row = row.inset(ui.px(12), ui.px(2));
    columns.box = row.cut_left(ui.px(16));
    row.cut_left(ui.px(8));
    columns.name = row.cut_left(ui.px(80));
    row.cut_left(gap);
    columns.opacity = row.cut_right(ui.px(44));
    row.cut_right(gap);
    if (wide) {
        columns.blend = row.cut_right(ui.px(84));
        row.cut_right(gap);
    }
    columns.value = row;
    return columns;
}

Requests draw_channel_value(Ui& ui, const Rect& rect, const EditedSource& edited,
                            const LayerSubject& subject, ViewState& view) {
    if (std::holds_alternative<ConstantSource>(edited.source))
        return draw_constant(ui, rect, edited, false);
    const std::string name = source_name(edited.source, edited.channel, *subject.shown.document);
    const Tip tip{name, "Click to edit the source"};
    const Press pressed =
        press(ui, rect, {.label = "Source", .kind = "source", .value = name, .tip = &tip});
    fill(ui, rect, pressed.hovered ? theme::kFieldHover : theme::kField, 4);
    Rect inner = rect;
    inner.cut_left(ui.px(4));
    inner.cut_right(ui.px(6));
    const Rect swatch = inner.cut_left(ui.px(18)).centered(ui.px(18), ui.px(18));
    fill(ui, swatch, rgb(0x0D0D0D), 3);
    picture(
        ui, swatch,
        subject.shown.thumbnails->channel_source(subject.material, subject.layer, *edited.channel),
        3);
    inner.cut_left(ui.px(6));
    text(ui, inner, ui.fonts.value12, theme::kText, name);
    if (pressed.clicked) {
        const bool open = view.unfolded.channel == edited.channel;
        view.unfolded.channel = open ? std::nullopt : edited.channel;
    }
    return {};
}

void draw_channel_name(Ui& ui, const Rect& rect, Channel channel, bool on, bool can_open,
                       ViewState& view) {
    const ChannelInfo& row = info(channel);
    const Tip tip{std::string(row.label), std::string(row.tooltip)};
    const Press pressed = press(ui, rect,
                                {.label = row.label,
                                 .kind = "name",
                                 .value = view.unfolded.channel == channel ? "open" : "",
                                 .enabled = can_open,
                                 .tip = &tip});
    const ImU32 color = !on ? theme::kText3 : theme::kText;
    text(ui, rect, ui.fonts.body13, color, row.label);
    if (!pressed.clicked) return;
    if (view.unfolded.channel == channel)
        view.unfolded.channel.reset();
    else
        view.unfolded.channel = channel;
}

Requests draw_channel_row(Ui& ui, Rect& rest, Channel channel, const LayerSubject& subject,
                          ViewState& view) {
    const auto* const adjustment = std::get_if<AdjustmentContent>(&subject.layer.content);
    if (adjustment != nullptr && !adjusts(adjustment->adjustment.kind, channel)) return {};
    Requests requests;
    const Place place(ui, info(channel).label);
    const Layer& layer = subject.layer;
    const ChannelSettings& settings = at(layer.channels, channel);
    const bool fills = !layer.is_group() && !layer.is_adjustment();
    const bool open = settings.enabled && fills && view.unfolded.channel == channel;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.ChannelsSplit(2);
    list.ChannelsSetCurrent(1);
    const Rect row = rest.cut_top(ui.px(theme::kChannelRow));
    const ChannelColumns columns = columns_of(ui, row, subject.wide);
    if (checkbox(ui, columns.box, info(channel).label, settings.enabled,
                 info(Parameter::ChannelEnabled).tooltip))
        requests.edit(set_channel_enabled(subject.material, layer, channel, !settings.enabled));
    draw_channel_name(ui, columns.name, channel, settings.enabled, settings.enabled && fills, view);
    const SourcePlace source = source_place(subject.material, layer, channel);
    const EditedSource edited{source, settings.source, channel, layer.id, {}};
    if (!settings.enabled) {
        text(ui, columns.value.inset(ui.px(8), 0), ui.fonts.value12, theme::kText3, "Off");
    } else {
        if (!fills)
            text(ui, columns.value.inset(ui.px(8), 0), ui.fonts.value12, theme::kText3,
                 layer.is_group() ? "Of its layers" : "Adjusted");
        else
            requests.append(draw_channel_value(ui, columns.value, edited, subject, view));
        if (subject.wide) {
            const auto mode = channel_blend_combo(
                ui, columns.blend,
                {.label = "Channel blend", .tooltip = info(Parameter::ChannelMode).tooltip}, layer,
                channel);
            if (mode) requests.edit(set_channel_mode(subject.material, layer, channel, *mode));
        }
        const auto opacity =
            percent(ui, columns.opacity, Parameter::ChannelOpacity, settings.opacity, false);
        if (opacity)
            requests.edit(set_channel_opacity(subject.material, layer, channel,
                                              static_cast<float>(*opacity)));
    }
    if (open) {
        rest.cut_top(ui.px(2));
        Rect editor = rest;
        editor.x0 += ui.px(36);
        editor.x1 -= ui.px(12);
        const float top = editor.y0;
        requests.append(draw_source_editor(ui, editor, edited, subject.shown));
        rest.cut_top(editor.y0 - top + ui.px(4));
    }
    list.ChannelsSetCurrent(0);
    if (open) fill(ui, {row.x0, row.y0, row.x1, rest.y0}, theme::kOpenRow);
    list.ChannelsMerge();
    return requests;
}

}  // namespace

Requests draw_channels(Ui& ui, Rect& rest, const LayerSubject& subject, ViewState& view) {
    Requests requests;
    std::size_t on = 0;
    for (const ChannelSettings& settings : subject.layer.channels) on += settings.enabled ? 1 : 0;
    Rect head = rest.cut_top(ui.px(theme::kPanelTitle));
    hairline(ui, head);
    if (section(ui, head,
                {.title = "Channels",
                 .count = fmt::format("{} of {}", on, kChannelCount),
                 .open = view.unfolded.channels}))
        view.unfolded.channels = !view.unfolded.channels;
    if (!view.unfolded.channels) return requests;
    head.cut_right(ui.px(12));
    text(ui, head, ui.fonts.caption11, theme::kText3, "Opacity, %", Align::Right);
    if (subject.wide) {
        head.cut_right(ui.px(48));
        text(ui, head.cut_right(ui.px(84)), ui.fonts.caption11, theme::kText3, "Blend");
    }
    for (const ChannelInfo& row : kChannels)
        requests.append(draw_channel_row(ui, rest, row.channel, subject, view));
    rest.cut_top(ui.px(8));
    return requests;
}

}  // namespace patina::editor
