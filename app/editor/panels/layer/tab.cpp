// SPDX-License-Identifier: MIT
#include "document/edits.h"
#include "editor/panels/adjustment_editor.h"
#include "editor/panels/blend_combo.h"
#include "editor/panels/choice_combo.h"
#include "editor/panels/layer/parts.h"
#include "editor/panels/panels.h"
#include "editor/widgets/buttons.h"
#include "editor/widgets/slider.h"

namespace patina::editor {
namespace {

/// The group that holds the layer, if any.
const Layer* parent_of(const std::vector<LayerPtr>& layers, LayerId id) {
    for (const LayerPtr& layer : layers) {
        const auto* group = std::get_if<GroupContent>(&layer->content);
        if (group == nullptr) continue;
        for (const LayerPtr& child : group->children)
            if (child->id == id) return layer.get();
        if (const Layer* found = parent_of(group->children, id)) return found;
    }
    return nullptr;
}

Requests draw_head(Ui& ui, Rect& rest, const LayerSubject& subject) {
    Requests requests;
    const Layer& layer = subject.layer;
    Rect head = rest.cut_top(ui.px(56));
    head.cut_left(ui.px(12));
    head.cut_right(ui.px(8));
    const Rect square = head.cut_left(ui.px(36)).centered(ui.px(36), ui.px(36));
    fill(ui, square, rgb(0x0D0D0D), 3);
    picture(ui, square, subject.shown.thumbnails->layer(subject.material, layer), 3);
    head.cut_left(ui.px(10));
    if (icon_button(ui, head.cut_right(ui.px(26)),
                    {.icon = layer.locked ? icon::kLock : icon::kUnlock,
                     .label = layer.locked ? "Unlock layer" : "Lock layer",
                     .tooltip = info(Parameter::LayerLocked).tooltip}))
        requests.edit(set_layer_locked(subject.material, layer, !layer.locked));
    if (icon_button(ui, head.cut_right(ui.px(26)),
                    {.icon = layer.visible ? icon::kEye : icon::kEyeSlash,
                     .label = layer.visible ? "Hide layer" : "Show layer",
                     .key = "H"}))
        requests.edit(set_layer_visible(subject.material, layer, !layer.visible));
    Rect words = head.centered(head.width(), ui.px(34));
    text(ui, words.cut_top(ui.px(18)), ui.fonts.name15, theme::kText, layer.name);
    words.cut_top(ui.px(2));
    const Layer* parent = parent_of(subject.material.stack, layer.id);
    std::string kind = layer.is_group() ? "Group" : layer.is_adjustment() ? "Adjustment" : "Fill";
    kind +=
        parent != nullptr ? " \u00b7 in " + parent->name : " \u00b7 of " + subject.material.name;
    text(ui, words, ui.fonts.caption11, theme::kText3, kind);

    Rect line_box = rest.cut_top(ui.px(26)).inset(ui.px(12), ui.px(1));
    const Rect mode_box = line_box.cut_left(ui.px(subject.wide ? 118 : 96));
    line_box.cut_left(ui.px(4));
    const auto mode = blend_combo(
        ui, mode_box, {.label = "Blend mode", .tooltip = info(Parameter::LayerMode).tooltip},
        ChannelKind::Color, layer.mode, blend_of(layer));
    if (mode) requests.edit(set_layer_mode(subject.material, layer, *mode));
    const auto opacity = number_field(ui, line_box, number_spec(Parameter::LayerOpacity),
                                      static_cast<double>(layer.opacity));
    if (opacity)
        requests.edit(set_layer_opacity(subject.material, layer, static_cast<float>(*opacity)));
    rest.cut_top(ui.px(4));
    Rect space_box = rest.cut_top(ui.px(theme::kFieldHeight)).inset(ui.px(12), 0);
    const auto space =
        parameter_combo(ui, space_box, Parameter::LayerBlendSpace, layer.blend_space);
    if (space) requests.edit(set_layer_blend_space(subject.material, layer, *space));
    rest.cut_top(ui.px(4));
    const Rect clip_box = rest.cut_top(ui.px(theme::kFieldHeight)).inset(ui.px(12), 0);
    const ParameterInfo& clip = info(Parameter::LayerClipped);
    if (labelled_checkbox(ui, clip_box, clip.label, layer.clipped, clip.tooltip))
        requests.edit(set_layer_clipped(subject.material, layer, !layer.clipped));
    requests.append(draw_height_blend(ui, rest, subject));
    rest.cut_top(ui.px(10));
    return requests;
}

}  // namespace

std::optional<double> percent(Ui& ui, const Rect& rect, Parameter parameter, float value,
                              bool wide) {
    NumberSpec spec = wide ? number_spec(parameter) : compact_number_spec(parameter);
    spec.shown_label = {};
    return number_field(ui, rect, spec, static_cast<double>(value));
}

Requests draw_layer_tab(Ui& ui, const Rect& rect, const Shown& shown, ViewState& view) {
    Requests requests;
    if (!shown.layer) {
        text(ui, Rect{rect.x0, rect.y0, rect.x1, rect.y0 + ui.px(60)}.inset(ui.px(12), 0),
             ui.fonts.body13, theme::kText3, "Select a layer to edit it");
        return requests;
    }
    ScrollArea area(ui, "layer", rect);
    Rect rest = area.content();
    rest.y1 = rest.y0 + 1e6f;
    const float top = rest.y0;
    const LayerSubject subject{*shown.material, *shown.layer, shown,
                               rect.width() / ui.scale >= 320};
    {
        const Faded locked(ui, shown.layer->locked, 200);
        requests.append(draw_head(ui, rest, subject));
        requests.append(draw_adjustment(ui, rest, subject.material, subject.layer, view));
        requests.append(draw_channels(ui, rest, subject, view));
        requests.append(draw_mask(ui, rest, subject, view));
        requests.append(draw_uv(ui, rest, subject, view));
    }
    requests.append(draw_bake(ui, rest, subject, view));
    area.set_height(rest.y0 - top + ui.px(12));
    return requests;
}

}  // namespace patina::editor
