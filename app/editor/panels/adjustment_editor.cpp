// SPDX-License-Identifier: MIT
#include "editor/panels/adjustment_editor.h"

#include <array>
#include <functional>

#include "document/edits.h"
#include "editor/panels/choice_combo.h"
#include "editor/panels/levels_fields.h"
#include "editor/widgets/buttons.h"
#include "editor/widgets/curve_field.h"
#include "editor/widgets/form.h"
#include "editor/widgets/ramp_field.h"
#include "editor/widgets/slider.h"

namespace patina::editor {
namespace {

/// The edit of whatever has the adjustment.
using EditOf = std::function<Edit(const AdjustmentSettings& changed, Parameter parameter)>;

struct Editing {
    Ui& ui;
    Rect& rest;
    const AdjustmentSettings& now;
    ViewState& view;
    const EditOf& edit_of;
    Requests requests = {};

    void change(const AdjustmentSettings& changed, Parameter parameter) {
        requests.edit(edit_of(changed, parameter));
    }
    void number(const Rect& box, Parameter parameter, float AdjustmentSettings::*member) {
        const auto next =
            number_field(ui, box, number_spec(parameter), static_cast<double>(now.*member));
        if (!next) return;
        AdjustmentSettings changed = now;
        changed.*member = static_cast<float>(*next);
        change(changed, parameter);
    }
    void numbers(Parameter first, float AdjustmentSettings::*first_member, Parameter second,
                 float AdjustmentSettings::*second_member) {
        const auto boxes = side_by_side<2>(ui, next_line(ui, rest));
        number(boxes[0], first, first_member);
        number(boxes[1], second, second_member);
    }
};

void draw_levels(Editing& editing) {
    const auto change = levels_fields(editing.ui, editing.rest, editing.now.levels);
    if (!change) return;
    AdjustmentSettings changed = editing.now;
    changed.levels = change->levels;
    editing.change(changed, change->parameter);
}

/// The graph, and below it the numbers of the point that is selected in it.
void draw_curve(Editing& editing) {
    Ui& ui = editing.ui;
    CurveHold& hold = editing.view.curve;
    const std::vector<CurvePoint>& curve = editing.now.curve;
    const auto change = [&](std::vector<CurvePoint> points, Parameter parameter) {
        AdjustmentSettings changed = editing.now;
        changed.curve = std::move(points);
        editing.change(changed, parameter);
    };
    const Rect graph = editing.rest.cut_top(ui.px(168));
    editing.rest.cut_top(ui.px(theme::kGap));
    if (auto points = curve_field(ui, graph, "Curve", curve, hold))
        return change(std::move(*points), Parameter::CurveY);
    if (hold.selected >= curve.size()) return;
    const CurvePoint& selected = curve[hold.selected];
    Rect line_box = next_line(ui, editing.rest);
    const Rect remove = line_box.cut_right(ui.px(26));
    const auto boxes = side_by_side<2>(ui, line_box);
    const auto x =
        number_field(ui, boxes[0], number_spec(Parameter::CurveX), static_cast<double>(selected.x));
    const auto y =
        number_field(ui, boxes[1], number_spec(Parameter::CurveY), static_cast<double>(selected.y));
    if (x || y)
        change(with_point_at(curve, hold.selected,
                             {x ? static_cast<float>(*x) : selected.x,
                              y ? static_cast<float>(*y) : selected.y}),
               x ? Parameter::CurveX : Parameter::CurveY);
    if (icon_button(ui, remove,
                    {.icon = icon::kTrash, .label = "Remove point", .enabled = curve.size() > 2})) {
        change(without_point(curve, hold.selected), Parameter::CurveY);
        ui.edit_ended = true;
    }
}

void draw_gradient(Editing& editing) {
    const Rect bar = editing.rest.cut_top(editing.ui.px(34));
    editing.rest.cut_top(editing.ui.px(6));
    auto stops =
        ramp_field(editing.ui, bar, {.label = "Gradient", .color = true}, editing.now.gradient);
    if (!stops) return;
    AdjustmentSettings changed = editing.now;
    changed.gradient = std::move(*stops);
    editing.change(changed, Parameter::RampPosition);
}

void draw_whole_number(Editing& editing, const Rect& box, Parameter parameter,
                       int AdjustmentSettings::*member) {
    const auto next = number_field(editing.ui, box, number_spec(parameter), editing.now.*member);
    if (!next) return;
    AdjustmentSettings changed = editing.now;
    changed.*member = static_cast<int>(*next);
    editing.change(changed, parameter);
}

void draw_warp(Editing& editing) {
    editing.numbers(Parameter::AdjustmentDistance, &AdjustmentSettings::distance_permille,
                    Parameter::AdjustmentScale, &AdjustmentSettings::scale);
    const auto boxes = side_by_side<2>(editing.ui, next_line(editing.ui, editing.rest));
    draw_whole_number(editing, boxes[0], Parameter::AdjustmentOctaves,
                      &AdjustmentSettings::octaves);
    NumberSpec seed = number_spec(Parameter::AdjustmentSeed);
    seed.level = false;
    const auto next = number_field(editing.ui, boxes[1], seed, editing.now.seed);
    if (!next) return;
    AdjustmentSettings changed = editing.now;
    changed.seed = static_cast<std::uint32_t>(*next);
    editing.change(changed, Parameter::AdjustmentSeed);
}

void draw_numbers(Editing& editing) {
    using enum Parameter;
    switch (editing.now.kind) {
        case AdjustmentKind::Levels:
            return draw_levels(editing);
        case AdjustmentKind::Curves:
            return draw_curve(editing);
        case AdjustmentKind::HueSaturation:
            editing.number(next_line(editing.ui, editing.rest), AdjustmentHue,
                           &AdjustmentSettings::hue_degrees);
            return editing.numbers(AdjustmentSaturation, &AdjustmentSettings::saturation,
                                   AdjustmentLightness, &AdjustmentSettings::lightness);
        case AdjustmentKind::BrightnessContrast:
            return editing.numbers(AdjustmentBrightness, &AdjustmentSettings::brightness,
                                   AdjustmentContrast, &AdjustmentSettings::contrast);
        case AdjustmentKind::Posterise:
            return draw_whole_number(editing, next_line(editing.ui, editing.rest),
                                     Parameter::AdjustmentSteps, &AdjustmentSettings::steps);
        case AdjustmentKind::GradientMap:
            return draw_gradient(editing);
        case AdjustmentKind::Clamp:
            return editing.numbers(AdjustmentLow, &AdjustmentSettings::low, AdjustmentHigh,
                                   &AdjustmentSettings::high);
        case AdjustmentKind::Blur:
            return editing.number(next_line(editing.ui, editing.rest), AdjustmentRadius,
                                  &AdjustmentSettings::radius_permille);
        case AdjustmentKind::Sharpen:
            return editing.numbers(AdjustmentRadius, &AdjustmentSettings::radius_permille,
                                   AdjustmentAmount, &AdjustmentSettings::amount);
        case AdjustmentKind::Warp:
            return draw_warp(editing);
        case AdjustmentKind::Invert:
            return;
    }
}

/// `allowed`: the kinds that can be chosen; null: all.
Requests draw_fields(Ui& ui, Rect& rest, const AdjustmentSettings& now, ViewState& view,
                     const EditOf& edit_of, bool (*allowed)(AdjustmentKind)) {
    const Place place(ui, "Adjustment");
    Editing editing{ui, rest, now, view, edit_of};
    const auto kind = parameter_combo(ui, next_line(ui, rest), Parameter::AdjustmentKindChoice,
                                      now.kind, true, allowed);
    if (kind) {
        AdjustmentSettings changed = now;
        changed.kind = *kind;
        editing.change(changed, Parameter::AdjustmentKindChoice);
    }
    draw_numbers(editing);
    return std::move(editing.requests);
}

}  // namespace

Requests draw_adjustment(Ui& ui, Rect& rest, const Material& material, const Layer& layer,
                         ViewState& view) {
    const auto* content = std::get_if<AdjustmentContent>(&layer.content);
    if (content == nullptr) return {};
    Rect inner = rest;
    inner.x0 += ui.px(12);
    inner.x1 -= ui.px(12);
    const float top = inner.y0;
    const EditOf edit_of = [&](const AdjustmentSettings& changed, Parameter parameter) {
        return set_adjustment(material, layer, changed, parameter);
    };
    Requests requests = draw_fields(ui, inner, content->adjustment, view, edit_of, nullptr);
    rest.cut_top(inner.y0 - top + ui.px(6));
    return requests;
}

Requests draw_adjustment(Ui& ui, Rect& rest, const Material& material, const Layer& layer,
                         const MaskEntry& entry, ViewState& view) {
    if (!entry.adjustment) return {};
    const EditOf edit_of = [&](const AdjustmentSettings& changed, Parameter parameter) {
        return set_mask_entry_adjustment(material, layer, entry, changed, parameter);
    };
    return draw_fields(ui, rest, *entry.adjustment, view, edit_of,
                       [](AdjustmentKind kind) { return adjusts_masks(kind); });
}

}  // namespace patina::editor
