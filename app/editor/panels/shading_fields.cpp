// SPDX-License-Identifier: MIT
#include "editor/panels/shading_fields.h"

#include "editor/panels/choice_combo.h"
#include "editor/widgets/buttons.h"
#include "editor/widgets/color_field.h"
#include "editor/widgets/form.h"
#include "editor/widgets/slider.h"

namespace patina::editor {
namespace {

/// What a box begins with when it is ticked.
constexpr float kFirstExponent = 32.0f;
constexpr glm::vec3 kFirstSpecular = glm::vec3(0.5f);
constexpr glm::vec3 kFirstAmbient = glm::vec3(0.05f);

/// A tick box with the name of an override; what is right of it stays in `line_box`.
template <typename Value>
void override_box(Ui& ui, Rect& line_box, std::string_view label, std::string_view tooltip,
                  std::optional<Value>& value, const Value& first) {
    const Rect box = line_box.cut_left(ui.px(112));
    line_box.cut_left(ui.px(4));
    if (!labelled_checkbox(ui, box, label, value.has_value(), tooltip)) return;
    if (value)
        value.reset();
    else
        value = first;
}

void from_where(Ui& ui, const Rect& rect, std::string_view words) {
    text(ui, rect, ui.fonts.value12, theme::kText3, words);
}

void color_override(Ui& ui, Rect line_box, std::string_view label, std::string_view tooltip,
                    std::string_view otherwise, std::optional<glm::vec3>& color,
                    const glm::vec3& first) {
    override_box(ui, line_box, label, tooltip, color, first);
    if (!color) return from_where(ui, line_box, otherwise);
    const Place place(ui, label);
    if (const auto v = color_field(ui, line_box, {.label = label, .tooltip = tooltip}, *color))
        color = *v;
}

void exponent_override(Ui& ui, Rect line_box, std::optional<float>& exponent) {
    constexpr std::string_view tooltip = "Specular power, 1 to 10000: higher is narrower";
    override_box(ui, line_box, "Set exponent", tooltip, exponent, kFirstExponent);
    if (!exponent) return from_where(ui, line_box, "from roughness");
    const NumberSpec spec{.label = "Exponent",
                          .minimum = double{render::kLeastPhongExponent},
                          .maximum = double{render::kMostPhongExponent},
                          .standard = double{kFirstExponent},
                          .step = 1.0,
                          .decimals = 0,
                          .curve = SliderCurve::Logarithmic,
                          .tooltip = tooltip};
    if (const auto v = number_field(ui, line_box, spec, double{*exponent}))
        exponent = static_cast<float>(*v);
}

}  // namespace

void term_fields(Ui& ui, Rect& rest, render::PbrTerms& terms) {
    if (const auto d = choice_combo(ui, padded_line(ui, rest),
                                    {.label = "Distribution", .shown_label = "Distribution"},
                                    render::kDistributionTerms, terms.distribution))
        terms.distribution = *d;
    if (const auto g = choice_combo(ui, padded_line(ui, rest),
                                    {.label = "Geometry", .shown_label = "Geometry"},
                                    render::kGeometryTerms, terms.geometry))
        terms.geometry = *g;
    if (const auto f =
            choice_combo(ui, padded_line(ui, rest), {.label = "Fresnel", .shown_label = "Fresnel"},
                         render::kFresnelTerms, terms.fresnel))
        terms.fresnel = *f;
    if (const auto d =
            choice_combo(ui, padded_line(ui, rest), {.label = "Diffuse", .shown_label = "Diffuse"},
                         render::kDiffuseTerms, terms.diffuse))
        terms.diffuse = *d;
    if (labelled_checkbox(ui, padded_line(ui, rest), "Multiple scattering",
                          terms.multiple_scattering,
                          "Gives back the energy that single scattering loses"))
        terms.multiple_scattering = !terms.multiple_scattering;
    Rect line_box = padded_line(ui, rest);
    const TextButton standard{.label = "glTF set"};
    const TextButton lecture{.label = "Lecture set",
                             .tooltip = "Lacks 1/pi and energy balance: not physical"};
    if (text_button(ui, line_box.cut_left(text_button_width(ui, standard)), standard)) terms = {};
    line_box.cut_left(ui.px(4));
    if (text_button(ui, line_box.cut_left(text_button_width(ui, lecture)), lecture))
        terms = render::kLectureTerms;
}

void phong_fields(Ui& ui, Rect& rest, render::View& view) {
    const bool left = view.left.model != render::ShadingModel::Pbr;
    render::PhongSettings phong = left ? view.left.phong : view.right.phong;
    const render::PhongSettings before = phong;
    exponent_override(ui, padded_line(ui, rest), phong.exponent);
    color_override(ui, padded_line(ui, rest), "Set specular",
                   "The highlight's colour, in place of the material's", "from the material",
                   phong.specular_color_linear, kFirstSpecular);
    color_override(ui, padded_line(ui, rest), "Set ambient",
                   "Light from everywhere, in place of the environment's mean",
                   "from the environment", phong.ambient_linear, kFirstAmbient);
    const NumberSpec strength{.label = "Specular strength",
                              .shown_label = "Specular strength",
                              .maximum = double{render::kMostPhongStrength},
                              .standard = 1.0,
                              .step = 0.05,
                              .tooltip = "Times the highlight's colour, 0 to 4"};
    if (const auto v =
            number_field(ui, padded_line(ui, rest), strength, double{phong.specular_strength}))
        phong.specular_strength = static_cast<float>(*v);
    if (phong == before) return;
    view.left.phong = view.right.phong = phong;
}

}  // namespace patina::editor
