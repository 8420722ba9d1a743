// SPDX-License-Identifier: MIT
#include "editor/panels/blend_combo.h"

#include <vector>

namespace patina::editor {

std::optional<BlendMode> blend_combo(Ui& ui, const Rect& rect, const ComboSpec& spec,
                                     ChannelKind kind, BlendMode current, BlendOf of) {
    std::vector<ComboItem> items;
    std::vector<BlendMode> modes;
    int chosen = -1;
    for (const BlendModeInfo& row : kBlendModes) {
        const bool passes = of == BlendOf::Group && row.mode == BlendMode::PassThrough;
        if ((row.kinds & kind_bit(kind)) == 0 && !passes) continue;
        if (of == BlendOf::Mask && !combines_masks(row.mode)) continue;
        if (row.mode == current) chosen = static_cast<int>(items.size());
        items.push_back({.label = row.label, .group = row.group, .tooltip = row.tooltip});
        modes.push_back(row.mode);
    }
    const std::optional<int> picked = combo(ui, rect, spec, items, chosen);
    if (!picked) return std::nullopt;
    return modes[static_cast<std::size_t>(*picked)];
}

}  // namespace patina::editor
