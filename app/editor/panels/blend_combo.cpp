// SPDX-License-Identifier: MIT
#include "editor/panels/blend_combo.h"

#include <fmt/format.h>

#include <vector>

namespace patina::editor {
namespace {

/// The rows of a menu of modes and what each of them means.
struct ModeMenu {
    std::vector<ComboItem> items;
    std::vector<std::optional<BlendMode>> modes;
    int chosen = -1;

    void add(const ComboItem& item, std::optional<BlendMode> mode,
             std::optional<BlendMode> current) {
        if (mode == current) chosen = static_cast<int>(items.size());
        items.push_back(item);
        modes.push_back(mode);
    }
    void add_modes(ChannelKind kind, BlendOf of, std::optional<BlendMode> current) {
        for (const BlendModeInfo& row : kBlendModes) {
            const bool passes = of == BlendOf::Group && row.mode == BlendMode::PassThrough;
            if ((row.kinds & kind_bit(kind)) == 0 && !passes) continue;
            if (of == BlendOf::Mask && !combines_masks(row.mode)) continue;
            add({.label = row.label, .group = row.group, .tooltip = row.tooltip}, row.mode,
                current);
        }
    }
};

}  // namespace

std::optional<BlendMode> blend_combo(Ui& ui, const Rect& rect, const ComboSpec& spec,
                                     ChannelKind kind, BlendMode current, BlendOf of) {
    ModeMenu menu;
    menu.add_modes(kind, of, current);
    const std::optional<int> picked = combo(ui, rect, spec, menu.items, menu.chosen);
    if (!picked) return std::nullopt;
    return menu.modes[static_cast<std::size_t>(*picked)];
}

std::optional<std::optional<BlendMode>> channel_blend_combo(Ui& ui, const Rect& rect,
                                                            const ComboSpec& spec,
                                                            const Layer& layer, Channel channel) {
    const std::optional<BlendMode> current = at(layer.channels, channel).mode;
    Layer unset = layer;
    at(unset.channels, channel).mode.reset();
    const std::string_view standard = info(effective_blend_mode(unset, channel)).label;
    const std::string default_label = fmt::format("Default ({})", standard);
    ModeMenu menu;
    menu.add(
        {.label = default_label, .tooltip = "The layer's mode, or what the channel is wont to"},
        std::nullopt, current);
    menu.add_modes(info(channel).kind, BlendOf::Channel, current);
    ComboSpec shown = spec;
    if (!current) shown.shown_value = standard;
    const std::optional<int> picked = combo(ui, rect, shown, menu.items, menu.chosen);
    if (!picked) return std::nullopt;
    return menu.modes[static_cast<std::size_t>(*picked)];
}

}  // namespace patina::editor
