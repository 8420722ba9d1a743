// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include "document/choices.h"
#include "document/parameters.h"
#include "editor/widgets/combo.h"
#include "render/shading.h"

namespace patina::editor {

/// A combo over one of the renderer's tables. `Choices` is a std::array of render::Choice<Enum>.
template <typename Enum, std::size_t N>
std::optional<Enum> choice_combo(Ui& ui, const Rect& rect, const ComboSpec& spec,
                                 const std::array<render::Choice<Enum>, N>& choices, Enum current) {
    std::array<ComboItem, N> items;
    int chosen = -1;
    for (std::size_t i = 0; i < N; ++i) {
        items[i] = {.label = choices[i].label, .tooltip = choices[i].tooltip};
        if (choices[i].value == current) chosen = static_cast<int>(i);
    }
    const std::optional<int> picked = combo(ui, rect, spec, items, chosen);
    if (!picked) return std::nullopt;
    return choices[static_cast<std::size_t>(*picked)].value;
}

/// A combo over those of one of the document's tables that are `allowed` (null: all), named and
/// explained by its parameter.
template <typename Enum>
std::optional<Enum> parameter_combo(Ui& ui, const Rect& rect, Parameter parameter, Enum current,
                                    bool with_label = true, bool (*allowed)(Enum) = nullptr) {
    const auto table = patina::choices<Enum>();
    std::vector<ComboItem> items;
    std::vector<Enum> values;
    int chosen = -1;
    for (std::size_t i = 0; i < table.size(); ++i) {
        const auto value = static_cast<Enum>(i);
        if (allowed != nullptr && !allowed(value)) continue;
        if (value == current) chosen = static_cast<int>(items.size());
        items.push_back({.label = table[i].label});
        values.push_back(value);
    }
    const ParameterInfo& row = info(parameter);
    const ComboSpec spec{.label = row.label,
                         .shown_label = with_label ? row.label : std::string_view(),
                         .tooltip = row.tooltip};
    const std::optional<int> picked = combo(ui, rect, spec, items, chosen);
    if (!picked) return std::nullopt;
    return values[static_cast<std::size_t>(*picked)];
}

}  // namespace patina::editor
