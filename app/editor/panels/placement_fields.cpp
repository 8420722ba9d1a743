// SPDX-License-Identifier: MIT
#include "editor/panels/placement_fields.h"

#include <array>

#include "document/worn_surface.h"
#include "editor/panels/choice_combo.h"
#include "editor/widgets/buttons.h"
#include "editor/widgets/form.h"
#include "editor/widgets/slider.h"

namespace patina::editor {
namespace {

std::vector<SourcePlace> places_of(const std::vector<PlacedSource>& sources) {
    std::vector<SourcePlace> places;
    for (const PlacedSource& each : sources) places.push_back(each.place);
    return places;
}

/// Only images can be on another UV set.
std::vector<SourcePlace> image_places_of(const std::vector<PlacedSource>& sources) {
    std::vector<SourcePlace> places;
    for (const PlacedSource& each : sources)
        if (std::holds_alternative<ImageSource>(*each.source)) places.push_back(each.place);
    return places;
}

/// As it is kept, be it in force or not.
Projection kept_projection(const Source& source) {
    if (const auto* image = std::get_if<ImageSource>(&source)) return image->projection;
    return std::get<ProceduralSource>(source).projection;
}

/// Two numbers with a switch between them that keeps them equal, where there is one.
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

Requests draw_uv_set(Ui& ui, const Rect& rect, const std::vector<PlacedSource>& sources,
                     int uv_set) {
    Requests requests;
    if (const auto set = uv_set_combo(ui, rect, Parameter::ImageUvSet, uv_set))
        requests.edit(at_all(image_places_of(sources), [&](const SourcePlace& place) {
            return set_image_uv_set(place, *set);
        }));
    return requests;
}

}  // namespace

std::optional<int> uv_set_combo(Ui& ui, const Rect& rect, Parameter parameter, int uv_set) {
    constexpr std::array<ComboItem, 2> kSets = {ComboItem{.label = "UV 0"},
                                                ComboItem{.label = "UV 1"}};
    const ParameterInfo& row = info(parameter);
    return combo(ui, rect, {.label = row.label, .tooltip = row.tooltip}, kSets, uv_set);
}

const UvTransform* transform_of(const Source& source) {
    if (const auto* image = std::get_if<ImageSource>(&source)) return &image->transform;
    if (const auto* procedural = std::get_if<ProceduralSource>(&source))
        return &procedural->transform;
    return nullptr;
}

bool lie_alike(const Source& a, const Source& b) {
    const UvTransform* const first = transform_of(a);
    const UvTransform* const second = transform_of(b);
    if (first == nullptr || second == nullptr || *first != *second) return false;
    if (projection_of(a) != projection_of(b)) return false;
    const auto* image = std::get_if<ImageSource>(&a);
    const auto* other = std::get_if<ImageSource>(&b);
    return image == nullptr || other == nullptr || image->uv_set == other->uv_set;
}

Requests draw_projection(Ui& ui, Rect& rest, const std::vector<PlacedSource>& sources) {
    Requests requests;
    const Projection now = kept_projection(*sources.front().source);
    const auto change = [&](const Projection& changed, Parameter parameter) {
        requests.edit(at_all(places_of(sources), [&](const SourcePlace& place) {
            return set_projection(place, changed, parameter);
        }));
    };
    Projection changed = now;
    if (const auto kind =
            parameter_combo(ui, next_line(ui, rest), Parameter::ProjectionKindChoice, now.kind)) {
        changed.kind = *kind;
        change(changed, Parameter::ProjectionKindChoice);
    }
    if (now.kind == ProjectionKind::Planar) {
        if (const auto axis = parameter_combo(ui, next_line(ui, rest),
                                              Parameter::ProjectionAxisChoice, now.axis)) {
            changed.axis = *axis;
            change(changed, Parameter::ProjectionAxisChoice);
        }
    }
    if (now.kind == ProjectionKind::TriPlanar) {
        if (const auto blend =
                number_field(ui, next_line(ui, rest), number_spec(Parameter::ProjectionBlend),
                             static_cast<double>(now.blend))) {
            changed.blend = static_cast<float>(*blend);
            change(changed, Parameter::ProjectionBlend);
        }
    }
    return requests;
}

Requests draw_transform(Ui& ui, Rect& rest, const std::vector<PlacedSource>& sources,
                        bool& scales_linked) {
    Requests requests;
    const auto change = [&](const std::function<Edit(const SourcePlace&)>& edit) {
        requests.edit(at_all(places_of(sources), edit));
    };
    const Source& shown = *sources.front().source;
    const UvTransform& transform = *transform_of(shown);
    if (const auto* image = std::get_if<ImageSource>(&shown))
        requests.append(draw_uv_set(ui, next_line(ui, rest), sources, image->uv_set));
    if (const auto scale = pair_fields(ui, next_line(ui, rest), Parameter::UvScale, transform.scale,
                                       &scales_linked))
        change([&](const SourcePlace& place) { return set_uv_scale(place, *scale); });
    if (const auto offset =
            pair_fields(ui, next_line(ui, rest), Parameter::UvOffset, transform.offset, nullptr))
        change([&](const SourcePlace& place) { return set_uv_offset(place, *offset); });
    const auto rotation = number_field(ui, next_line(ui, rest), number_spec(Parameter::UvRotation),
                                       static_cast<double>(transform.rotation_degrees));
    if (rotation)
        change([&](const SourcePlace& place) {
            return set_uv_rotation(place, static_cast<float>(*rotation));
        });
    return requests;
}

Edit reset_transform(const std::vector<PlacedSource>& sources) {
    return at_all(places_of(sources),
                  [](const SourcePlace& place) { return set_uv_transform(place, {}); });
}

}  // namespace patina::editor
