// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>

#include "document/edits.h"
#include "document/stack_tree.h"
#include "editor/panels/choice_combo.h"
#include "editor/panels/light_fields.h"
#include "editor/panels/panels.h"
#include "editor/panels/placement_fields.h"
#include "editor/panels/shading_fields.h"
#include "editor/widgets/buttons.h"
#include "editor/widgets/color_field.h"
#include "editor/widgets/form.h"
#include "editor/widgets/number_text.h"
#include "editor/widgets/slider.h"
#include "render/environment.h"

namespace patina::editor {
namespace {

bool unfold(Ui& ui, Rect& rest, std::string_view title, std::string_view count, bool& open) {
    const Rect head = rest.cut_top(ui.px(theme::kPanelTitle));
    hairline(ui, head);
    if (section(ui, head, {.title = title, .count = count, .open = open})) open = !open;
    return open;
}

void draw_head(Ui& ui, Rect& rest, const Material& material, const Shown& shown) {
    Rect head = rest.cut_top(ui.px(56)).inset(ui.px(12), 0);
    const Rect ball = head.cut_left(ui.px(40)).centered(ui.px(40), ui.px(40));
    const Picture thumbnail = shown.thumbnails->material(material);
    if (thumbnail.texture == nullptr) disc(ui, ball.center_x(), ball.center_y(), 19, theme::kField);
    picture(ui, ball, thumbnail);
    head.cut_left(ui.px(10));
    Rect words = head.centered(head.width(), ui.px(34));
    text(ui, words.cut_top(ui.px(18)), ui.fonts.name15, theme::kText, material.name);
    words.cut_top(ui.px(2));
    text(ui, words, ui.fonts.caption11, theme::kText3,
         fmt::format("{} \u00b7 {} px",
                     counted(static_cast<std::size_t>(layer_count(material.stack)), "layer"),
                     material.resolution));
}

Requests draw_surface(Ui& ui, Rect& rest, const Material& material, ViewState& view) {
    Requests requests;
    const Place place(ui, "Surface");
    if (!unfold(ui, rest, "Surface", {}, view.unfolded.surface)) return requests;
    const auto number = [&](const Rect& rect, Parameter parameter, float value) {
        return number_field(ui, rect, number_spec(parameter), static_cast<double>(value));
    };
    const auto alpha = side_by_side<2>(ui, padded_line(ui, rest));
    if (const auto mode =
            parameter_combo(ui, alpha[0], Parameter::MaterialAlphaMode, material.alpha_mode))
        requests.edit(set_material_alpha_mode(material, *mode));
    if (material.alpha_mode == AlphaMode::Mask)
        if (const auto v = number(alpha[1], Parameter::MaterialAlphaCutoff, material.alpha_cutoff))
            requests.edit(set_material_alpha_cutoff(material, static_cast<float>(*v)));
    const auto optics = side_by_side<2>(ui, padded_line(ui, rest));
    if (const auto v = number(optics[0], Parameter::MaterialIor, material.ior))
        requests.edit(set_material_ior(material, static_cast<float>(*v)));
    if (const auto v =
            number(optics[1], Parameter::MaterialSpecularFactor, material.specular_factor))
        requests.edit(set_material_specular_factor(material, static_cast<float>(*v)));
    const auto light = side_by_side<2>(ui, padded_line(ui, rest));
    const ParameterInfo& tint = info(Parameter::MaterialSpecularColor);
    if (const auto color = color_field(ui, light[0], {.label = tint.label, .tooltip = tint.tooltip},
                                       material.specular_color_linear))
        requests.edit(set_material_specular_color(material, *color));
    if (const auto v =
            number(light[1], Parameter::MaterialEmissiveStrength, material.emissive_strength))
        requests.edit(set_material_emissive_strength(material, static_cast<float>(*v)));
    if (const auto v =
            number(padded_line(ui, rest), Parameter::MaterialHeightScale, material.height_scale))
        requests.edit(set_material_height_scale(material, static_cast<float>(*v)));
    Rect baking = padded_line(ui, rest);
    if (const auto set = uv_set_combo(ui, baking.cut_right(ui.px(72)), Parameter::MaterialUvSet,
                                      material.uv_set))
        requests.edit(set_material_uv_set(material, *set));
    baking.cut_right(ui.px(theme::kGap));
    if (const auto padding =
            parameter_combo(ui, baking, Parameter::MaterialPadding, material.padding))
        requests.edit(set_material_padding(material, *padding));
    const auto flags = side_by_side<2>(ui, padded_line(ui, rest));
    const auto toggle = [&](const Rect& rect, Parameter parameter, bool on) {
        return labelled_checkbox(ui, rect, info(parameter).label, on, info(parameter).tooltip);
    };
    if (toggle(flags[0], Parameter::MaterialDoubleSided, material.double_sided))
        requests.edit(set_material_double_sided(material, !material.double_sided));
    if (toggle(flags[1], Parameter::MaterialUnlit, material.unlit))
        requests.edit(set_material_unlit(material, !material.unlit));
    rest.cut_top(ui.px(6));
    return requests;
}

/// How much of the texture the parts use, and a warning where several share a texel: what is laid
/// there is seen on all of them.
void draw_uv_layout(Ui& ui, Rect& rest, const UvLayout& layout) {
    const bool overlaps = layout.overlapped > 0.0;
    std::string words = "UVs: " + uv_layout_words(layout);
    if (overlaps) words += ". What is laid there is seen on all of them";
    Rect box = rest.inset(ui.px(12), 0);
    const Rect mark = box.cut_left(ui.px(16));
    box.cut_left(ui.px(6));
    const float height = paragraph(ui, box, ui.fonts.value12, theme::kText2, words);
    const Rect first_line{mark.x0, mark.y0, mark.x1, mark.y0 + ui.px(16)};
    icon_glyph(ui, first_line, overlaps ? icon::kWarning : icon::kInfo,
               overlaps ? theme::kWarning : theme::kText3, 12);
    note(ui, {mark.x0, mark.y0, box.x1, mark.y0 + height},
         {.label = "UV layout", .kind = overlaps ? "warning" : "note", .value = words});
    rest.cut_top(height + ui.px(10));
}

Requests draw_environment(Ui& ui, Rect& rest, const Document& document, ViewState& view) {
    Requests requests;
    const Place place(ui, "Environment");
    if (!unfold(ui, rest, "Environment", {}, view.unfolded.environment)) return requests;
    const auto rotation =
        number_field(ui, padded_line(ui, rest), number_spec(Parameter::EnvironmentRotation),
                     static_cast<double>(document.environment.rotation_degrees));
    if (rotation) requests.edit(set_environment_rotation(static_cast<float>(*rotation)));
    const auto intensity =
        number_field(ui, padded_line(ui, rest), number_spec(Parameter::EnvironmentIntensity),
                     static_cast<double>(document.environment.intensity));
    if (intensity) requests.edit(set_environment_intensity(static_cast<float>(*intensity)));
    if (document.environment.name == render::kSkyEnvironment) {
        const auto sun =
            number_field(ui, padded_line(ui, rest), number_spec(Parameter::EnvironmentSunElevation),
                         static_cast<double>(document.environment.sun_elevation_degrees));
        if (sun) requests.edit(set_sun_elevation(static_cast<float>(*sun)));
    }
    rest.cut_top(ui.px(6));
    return requests;
}

Requests draw_light(Ui& ui, Rect& rest, const Light& light, int index) {
    Requests requests;
    const std::string name = light.name.empty() ? fmt::format("Light {}", index + 1) : light.name;
    const Place place(ui, name, static_cast<std::uint64_t>(index) + 1);
    Rect line_box = padded_line(ui, rest);
    if (icon_button(ui, line_box.cut_right(ui.px(26)),
                    {.icon = icon::kTrash, .label = "Remove light"}))
        requests.edit(remove_light(index));
    line_box.cut_right(ui.px(4));
    Light changed = light;
    const ParameterInfo& color_row = info(Parameter::LightColor);
    if (const auto color = color_field(ui, line_box.cut_left(ui.px(84)),
                                       {.label = color_row.label, .tooltip = color_row.tooltip},
                                       light.color_linear))
        changed.color_linear = *color;
    line_box.cut_left(ui.px(4));
    if (const auto kind = parameter_combo(ui, line_box.cut_left(ui.px(96)), Parameter::LightKind,
                                          light.kind, false))
        changed.kind = *kind;
    line_box.cut_left(ui.px(4));
    NumberSpec spec = number_spec(Parameter::LightIntensity);
    spec.level = false;
    spec.drag_per_pixel = 0.02;
    if (line_box.width() < ui.px(110)) spec.shown_label = {};
    if (const auto v = number_field(ui, line_box, spec, static_cast<double>(light.intensity)))
        changed.intensity = static_cast<float>(*v);
    const Light placed = light_fields(ui, rest, changed);
    rest.cut_top(ui.px(4));
    if (!(placed == light)) requests.edit(set_light(index, placed));
    return requests;
}

Requests draw_lights(Ui& ui, Rect& rest, const Document& document, ViewState& view) {
    Requests requests;
    const Place place(ui, "Lights");
    Rect head = rest.cut_top(ui.px(theme::kPanelTitle));
    hairline(ui, head);
    head.cut_right(ui.px(6));
    if (icon_button(ui, head.cut_right(ui.px(26)), {.icon = icon::kPlus, .label = "Add light"})) {
        Light light;
        light.intensity = 2.0f;
        light.direction_world = glm::normalize(glm::vec3(-0.5f, -1.0f, -0.6f));
        // Should it become one that stands somewhere: outside of the model, where it shines from.
        const Bounds& bounds = document.scene->bounds_world;
        if (!bounds.empty())
            light.position_world = bounds.center() - 2.0f * bounds.radius() * light.direction_world;
        requests.edit(add_light(light));
    }
    const std::string count = document.lights.empty() ? "" : std::to_string(document.lights.size());
    if (section(ui, head, {.title = "Lights", .count = count, .open = view.unfolded.lights}))
        view.unfolded.lights = !view.unfolded.lights;
    if (!view.unfolded.lights) return requests;
    for (std::size_t i = 0; i < document.lights.size(); ++i)
        requests.append(draw_light(ui, rest, document.lights[i], static_cast<int>(i)));
    if (document.lights.empty())
        text(ui, padded_line(ui, rest), ui.fonts.value12, theme::kText3,
             "No lamps: the environment lights the model");
    rest.cut_top(ui.px(6));
    return requests;
}

void draw_shading(Ui& ui, Rect& rest, ViewState& view) {
    const Place place(ui, "Shading terms");
    if (!unfold(ui, rest, "Shading terms",
                view.view.left.model == render::ShadingModel::Pbr ? "left side" : "",
                view.unfolded.terms))
        return;
    render::Shading& shading = view.view.left;
    if (shading.model == render::ShadingModel::Pbr)
        term_fields(ui, rest, shading.terms);
    else
        phong_fields(ui, rest, view.view);
}

}  // namespace

Requests draw_material_tab(Ui& ui, const Rect& rect, const Shown& shown, ViewState& view) {
    Requests requests;
    if (!shown.material) {
        text(ui, Rect{rect.x0, rect.y0, rect.x1, rect.y0 + ui.px(60)}.inset(ui.px(12), 0),
             ui.fonts.body13, theme::kText3, "Open a model to see its materials");
        return requests;
    }
    ScrollArea area(ui, "material", rect);
    Rect rest = area.content();
    rest.y1 = rest.y0 + 1e6f;
    const float top = rest.y0;
    draw_head(ui, rest, *shown.material, shown);
    requests.append(draw_surface(ui, rest, *shown.material, view));
    if (shown.uv_layout) draw_uv_layout(ui, rest, *shown.uv_layout);
    requests.append(draw_material_parts(ui, rest, shown, view));
    requests.append(draw_environment(ui, rest, *shown.document, view));
    requests.append(draw_lights(ui, rest, *shown.document, view));
    draw_shading(ui, rest, view);
    area.set_height(rest.y0 - top + ui.px(12));
    return requests;
}

}  // namespace patina::editor
