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

/// A combo over one of the document's tables, named and explained by its parameter.
template <typename Enum>
std::optional<Enum> parameter_combo(Ui& ui, const Rect& rect, Parameter parameter, Enum current,
                                    bool with_label = true) {
    const auto table = patina::choices<Enum>();
    std::vector<ComboItem> items;
    for (const Choice& row : table) items.push_back({.label = row.label});
    const ParameterInfo& row = info(parameter);
    const ComboSpec spec{.label = row.label,
                         .shown_label = with_label ? row.label : std::string_view(),
                         .tooltip = row.tooltip};
    const std::optional<int> picked = combo(ui, rect, spec, items, static_cast<int>(current));
    if (!picked) return std::nullopt;
    return static_cast<Enum>(*picked);
}

}  // namespace patina::editor
