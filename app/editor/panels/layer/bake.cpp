// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "document/edits.h"
#include "editor/panels/choice_combo.h"
#include "editor/panels/layer/parts.h"
#include "editor/widgets/buttons.h"
#include "editor/widgets/combo.h"
#include "editor/widgets/form.h"
#include "editor/widgets/slider.h"

namespace patina::editor {
namespace {

std::optional<int> resolution_combo(Ui& ui, const Rect& rect, int resolution) {
    std::vector<std::string> labels;
    std::vector<int> sizes;
    int chosen = -1;
    for (int size = kMinResolution; size <= kMaxResolution; size *= 2) {
        if (size == resolution) chosen = static_cast<int>(sizes.size());
        sizes.push_back(size);
        labels.push_back(fmt::format("{} px", size));
    }
    std::vector<ComboItem> items;
    for (const std::string& label : labels) items.push_back({.label = label});
    const ParameterInfo& row = info(Parameter::MaterialResolution);
    const auto picked =
        combo(ui, rect, {.label = row.label, .shown_label = row.label, .tooltip = row.tooltip},
              items, chosen);
    if (!picked) return std::nullopt;
    return sizes[static_cast<std::size_t>(*picked)];
}

}  // namespace

Requests draw_bake(Ui& ui, Rect& rest, const LayerSubject& subject, ViewState& view) {
    Requests requests;
    const Place place(ui, "Bake");
    const Material& material = subject.material;
    const Rect head = rest.cut_top(ui.px(theme::kPanelTitle));
    hairline(ui, head);
    if (section(ui, head,
                {.title = "Bake",
                 .summary = fmt::format("{} px", material.resolution),
                 .open = view.unfolded.bake}))
        view.unfolded.bake = !view.unfolded.bake;
    if (!view.unfolded.bake) return requests;
    const auto next_pair = [&] {
        return side_by_side<2>(ui, next_line(ui, rest).inset(ui.px(12), 0));
    };
    const auto first = next_pair();
    if (const auto size = resolution_combo(ui, first[0], material.resolution))
        requests.edit(set_material_resolution(material, *size));
    if (const auto mode =
            parameter_combo(ui, first[1], Parameter::MaterialAlphaMode, material.alpha_mode))
        requests.edit(set_material_alpha_mode(material, *mode));
    const auto second = next_pair();
    if (const auto ior = number_field(ui, second[0], number_spec(Parameter::MaterialIor),
                                      static_cast<double>(material.ior)))
        requests.edit(set_material_ior(material, static_cast<float>(*ior)));
    NumberSpec emission = number_spec(Parameter::MaterialEmissiveStrength);
    const auto strength =
        number_field(ui, second[1], emission, static_cast<double>(material.emissive_strength));
    if (strength)
        requests.edit(set_material_emissive_strength(material, static_cast<float>(*strength)));
    return requests;
}

}  // namespace patina::editor
