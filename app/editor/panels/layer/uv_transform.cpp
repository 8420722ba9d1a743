// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "document/edits.h"
#include "editor/panels/layer/parts.h"
#include "editor/widgets/buttons.h"
#include "editor/widgets/combo.h"
#include "editor/widgets/form.h"
#include "editor/widgets/number_text.h"
#include "editor/widgets/slider.h"

namespace patina::editor {
namespace {

const UvTransform* transform_of(const Source& source) {
    if (const auto* image = std::get_if<ImageSource>(&source)) return &image->transform;
    if (const auto* procedural = std::get_if<ProceduralSource>(&source))
        return &procedural->transform;
    return nullptr;
}

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

std::optional<glm::vec2> pair_fields(Ui& ui, Rect line_box, Parameter parameter,
                                     const glm::vec2& value, bool* linked) {
    NumberSpec first = number_spec(parameter);
    first.level = false;
    first.drag_per_pixel = first.step * 0.1;
    NumberSpec second = first;
    const std::string second_label = std::string(first.label) + " down";
    second.label = second_label;
    second.shown_label = {};
    const Rect last = line_box.cut_right(ui.px(56));
    const Rect middle = line_box.cut_right(ui.px(26));
    if (linked != nullptr &&
        icon_button(
            ui, middle,
            {.icon = icon::kLink, .label = "Keep both scales together", .on = *linked, .size = 12}))
        *linked = !*linked;
    glm::vec2 changed = value;
    if (const auto x = number_field(ui, line_box, first, static_cast<double>(value.x))) {
        changed.x = static_cast<float>(*x);
        if (linked != nullptr && *linked) changed.y = changed.x;
    }
    if (const auto y = number_field(ui, last, second, static_cast<double>(value.y))) {
        changed.y = static_cast<float>(*y);
        if (linked != nullptr && *linked) changed.x = changed.y;
    }
    if (changed == value) return std::nullopt;
    return changed;
}

Requests draw_uv_fields(Ui& ui, Rect column, const SourcePlace& place, const Source& source,
                        ViewState& view) {
    Requests requests;
    const UvTransform& transform = *transform_of(source);
    if (const auto* image = std::get_if<ImageSource>(&source)) {
        constexpr std::array<ComboItem, 2> kSets = {ComboItem{.label = "UV 0"},
                                                    ComboItem{.label = "UV 1"}};
        const auto set = combo(ui, next_line(ui, column),
                               {.label = "UV set", .tooltip = info(Parameter::ImageUvSet).tooltip},
                               kSets, image->uv_set);
        if (set) requests.edit(set_image_uv_set(place, *set));
    }
    if (const auto scale = pair_fields(ui, next_line(ui, column), Parameter::UvScale,
                                       transform.scale, &view.unfolded.uv_scale_linked))
        requests.edit(set_uv_scale(place, *scale));
    if (const auto offset =
            pair_fields(ui, next_line(ui, column), Parameter::UvOffset, transform.offset, nullptr))
        requests.edit(set_uv_offset(place, *offset));
    const auto rotation =
        number_field(ui, next_line(ui, column), number_spec(Parameter::UvRotation),
                     static_cast<double>(transform.rotation_degrees));
    if (rotation) requests.edit(set_uv_rotation(place, static_cast<float>(*rotation)));
    return requests;
}

}  // namespace

Requests draw_uv(Ui& ui, Rect& rest, const LayerSubject& subject, ViewState& view) {
    Requests requests;
    const std::optional<Channel> channel = transformed_channel(subject.layer, view);
    if (!channel) return requests;
    const Place place_name(ui, "UV transform");
    const Source& source = at(subject.layer.channels, *channel).source;
    const UvTransform& transform = *transform_of(source);
    const SourcePlace place = source_place(subject.material, subject.layer, *channel);
    Rect head = rest.cut_top(ui.px(theme::kPanelTitle));
    hairline(ui, head);
    if (view.unfolded.uv) {
        head.cut_right(ui.px(6));
        if (icon_button(ui, head.cut_right(ui.px(26)),
                        {.icon = icon::kReset,
                         .label = "Reset UV transform",
                         .enabled = transform != UvTransform{}}))
            requests.edit(set_uv_transform(place, {}));
    }
    const std::string summary =
        fmt::format("{} \u00d7 {}, {}", number_text(static_cast<double>(transform.scale.x)),
                    number_text(static_cast<double>(transform.scale.y)),
                    number_text(static_cast<double>(transform.rotation_degrees),
                                {.decimals = 1, .unit = "\u00b0"}));
    if (section(ui, head,
                {.title = "UV transform",
                 .count = info(*channel).label,
                 .summary = summary,
                 .open = view.unfolded.uv}))
        view.unfolded.uv = !view.unfolded.uv;
    if (!view.unfolded.uv) return requests;
    Rect box = rest.cut_top(ui.px(108)).inset(ui.px(12), 0);
    if (subject.wide) {
        draw_uv_preview(ui, box.cut_left(ui.px(108)), subject, *channel, transform);
        box.cut_left(ui.px(12));
    }
    requests.append(draw_uv_fields(ui, box, place, source, view));
    rest.cut_top(ui.px(12));
    return requests;
}

}  // namespace patina::editor
