// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "editor/panels/layer/parts.h"
#include "editor/panels/placement_fields.h"
#include "editor/widgets/buttons.h"
#include "editor/widgets/number_text.h"

namespace patina::editor {
namespace {

/// The channel whose transform is shown: the open one, else the first that has one.
std::optional<Channel> transformed_channel(const Layer& layer, const ViewState& view) {
    const auto has = [&](Channel channel) {
        const ChannelSettings& settings = at(layer.channels, channel);
        return settings.enabled && transform_of(settings.source) != nullptr;
    };
    if (view.unfolded.channel && has(*view.unfolded.channel)) return view.unfolded.channel;
    for (const ChannelInfo& row : kChannels)
        if (has(row.channel)) return row.channel;
    return std::nullopt;
}

/// The source with the outline of the texture's unit square in it.
void draw_uv_preview(Ui& ui, const Rect& rect, const LayerSubject& subject, Channel channel,
                     const UvTransform& transform) {
    fill(ui, rect, rgb(0x0D0D0D), 4);
    picture(ui, rect,
            subject.shown.thumbnails->channel_source(subject.material, subject.layer, channel), 4);
    const float half = 0.24f * rect.width();
    const float turn = glm::radians(transform.rotation_degrees);
    std::array<ImVec2, 4> corners;
    for (std::size_t i = 0; i < 4; ++i) {
        const float x = (i == 1 || i == 2 ? half : -half);
        const float y = (i >= 2 ? half : -half);
        corners[i] = ImVec2(rect.center_x() + std::cos(turn) * x + std::sin(turn) * y,
                            rect.center_y() - std::sin(turn) * x + std::cos(turn) * y);
    }
    ImGui::GetWindowDrawList()->AddPolyline(corners.data(), 4, theme::kAccentHigh,
                                            ImDrawFlags_Closed, 1.5f * ui.scale);
    for (const ImVec2& corner : corners) disc(ui, corner.x, corner.y, 3.5f, theme::kText);
}

/// The channel that is shown and those that move with it: all that lie as it does, on or off.
std::vector<PlacedSource> moved_sources(const LayerSubject& subject, Channel shown, bool linked) {
    const Source& source = at(subject.layer.channels, shown).source;
    std::vector<PlacedSource> sources = {
        {source_place(subject.material, subject.layer, shown), &source}};
    if (!linked) return sources;
    for (const ChannelInfo& row : kChannels) {
        const Source& other = at(subject.layer.channels, row.channel).source;
        if (row.channel != shown && lie_alike(source, other))
            sources.push_back({source_place(subject.material, subject.layer, row.channel), &other});
    }
    return sources;
}

/// The switch that links channels which lie alike, where there are some, and the reset.
Requests draw_head_buttons(Ui& ui, Rect& head, const std::vector<PlacedSource>& linked,
                           const std::vector<PlacedSource>& moved, ViewState& view) {
    Requests requests;
    head.cut_right(ui.px(6));
    if (icon_button(ui, head.cut_right(ui.px(26)),
                    {.icon = icon::kReset,
                     .label = "Reset UV transform",
                     .enabled = *transform_of(*moved.front().source) != UvTransform{}}))
        requests.edit(reset_transform(moved));
    bool& on = view.unfolded.uv_channels_linked;
    if (linked.size() > 1 &&
        icon_button(ui, head.cut_right(ui.px(26)),
                    {.icon = icon::kLink,
                     .label = "Link channels",
                     .tooltip = fmt::format("{} channels of the layer lie alike: on, they are "
                                            "moved together in one step",
                                            linked.size()),
                     .on = on}))
        on = !on;
    return requests;
}

}  // namespace

Requests draw_uv(Ui& ui, Rect& rest, const LayerSubject& subject, ViewState& view) {
    Requests requests;
    const std::optional<Channel> channel = transformed_channel(subject.layer, view);
    if (!channel) return requests;
    const Place place_name(ui, "UV transform");
    const std::vector<PlacedSource> linked = moved_sources(subject, *channel, true);
    const std::vector<PlacedSource> moved =
        moved_sources(subject, *channel, view.unfolded.uv_channels_linked);
    const UvTransform& transform = *transform_of(*moved.front().source);
    Rect head = rest.cut_top(ui.px(theme::kPanelTitle));
    hairline(ui, head);
    if (view.unfolded.uv) requests.append(draw_head_buttons(ui, head, linked, moved, view));
    const std::string summary =
        fmt::format("{} \u00d7 {}, {}", number_text(static_cast<double>(transform.scale.x)),
                    number_text(static_cast<double>(transform.scale.y)),
                    number_text(static_cast<double>(transform.rotation_degrees),
                                {.decimals = 1, .unit = "\u00b0"}));
    std::string of(info(*channel).label);
    if (moved.size() > 1) of += fmt::format(" and {} more", moved.size() - 1);
    if (section(
            ui, head,
            {.title = "UV transform", .count = of, .summary = summary, .open = view.unfolded.uv}))
        view.unfolded.uv = !view.unfolded.uv;
    if (!view.unfolded.uv) return requests;
    Rect fields = rest.inset(ui.px(12), 0);
    const float top = fields.y0;
    requests.append(draw_projection(ui, fields, moved));
    const Rect below = fields;
    if (subject.wide) fields.cut_left(ui.px(120));
    requests.append(draw_transform(ui, fields, moved, view.unfolded.uv_scale_linked));
    if (subject.wide)
        draw_uv_preview(ui, {below.x0, below.y0, below.x0 + ui.px(108), below.y0 + ui.px(108)},
                        subject, *channel, transform);
    // The preview is as high as the four lines of an image; a procedural has three.
    const float least = subject.wide ? below.y0 + ui.px(112) : fields.y0;
    rest.cut_top(std::max(fields.y0, least) - top + ui.px(8));
    return requests;
}

}  // namespace patina::editor
