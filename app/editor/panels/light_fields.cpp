// SPDX-License-Identifier: MIT
#include "editor/panels/light_fields.h"

#include <fmt/format.h>

#include "editor/widgets/form.h"
#include "editor/widgets/slider.h"

namespace patina::editor {
namespace {

constexpr double kMetresPerPixel = 0.01;

NumberSpec without_level(Parameter parameter) {
    NumberSpec spec = number_spec(parameter);
    spec.level = false;
    spec.drag_per_pixel = kMetresPerPixel;
    return spec;
}

/// Three numbers side by side, named after the axes, behind what they are together.
void vector_fields(Ui& ui, Rect line_box, Parameter parameter, glm::vec3& value) {
    constexpr std::array<std::string_view, 3> axes = {"X", "Y", "Z"};
    text(ui, line_box.cut_left(ui.px(56)), ui.fonts.value12, theme::kText2, info(parameter).label);
    const auto boxes = side_by_side<3>(ui, line_box);
    for (std::size_t i = 0; i < axes.size(); ++i) {
        NumberSpec spec = without_level(parameter);
        const std::string label = fmt::format("{} {}", info(parameter).label, axes[i]);
        spec.label = label;
        spec.shown_label = axes[i];
        spec.unit = {};
        float& number = value[static_cast<int>(i)];
        if (const auto v = number_field(ui, boxes[i], spec, static_cast<double>(number)))
            number = static_cast<float>(*v);
    }
}

void number(Ui& ui, const Rect& rect, const NumberSpec& spec, float& value) {
    if (const auto v = number_field(ui, rect, spec, static_cast<double>(value)))
        value = static_cast<float>(*v);
}

}  // namespace

Light light_fields(Ui& ui, Rect& rest, const Light& light) {
    using Kind = Light::Kind;
    Light changed = light;
    const auto next = [&] { return next_line(ui, rest).inset(ui.px(12), 0); };
    if (light.kind != Kind::Directional)
        vector_fields(ui, next(), Parameter::LightPosition, changed.position_world);
    if (light.kind != Kind::Point && light.kind != Kind::Sphere)
        vector_fields(ui, next(), Parameter::LightDirection, changed.direction_world);
    // A direction of length 0 is none.
    if (glm::length(changed.direction_world) < 1e-6f)
        changed.direction_world = light.direction_world;
    if (light.kind == Kind::Directional) return changed;
    if (light.kind == Kind::Spot) {
        const auto cones = side_by_side<2>(ui, next());
        number(ui, cones[0], number_spec(Parameter::LightInnerCone), changed.inner_cone_radians);
        number(ui, cones[1], number_spec(Parameter::LightOuterCone), changed.outer_cone_radians);
    } else if (light.kind == Kind::Rectangle) {
        const auto sides = side_by_side<2>(ui, next());
        number(ui, sides[0], without_level(Parameter::LightWidth), changed.width_m);
        number(ui, sides[1], without_level(Parameter::LightHeight), changed.height_m);
    }
    const auto last = side_by_side<2>(ui, next());
    number(ui, last[0], without_level(Parameter::LightRange), changed.range);
    if (light.kind == Kind::Sphere)
        number(ui, last[1], without_level(Parameter::LightRadius), changed.radius_m);
    if (light.kind == Kind::Rectangle)
        number(ui, last[1], number_spec(Parameter::LightTurn), changed.turn_radians);
    return changed;
}

}  // namespace patina::editor
