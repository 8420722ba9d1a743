// SPDX-License-Identifier: MIT
#include "editor/panels/kind_menus.h"

#include "document/choices.h"
#include "document/procedural_kinds.h"
#include "editor/widgets/popup_menu.h"

namespace patina::editor {

ProceduralRows procedural_rows() {
    ProceduralRows rows;
    for (const std::string_view group : kProceduralGroups)
        for (const ProceduralKindInfo& row : kProceduralKindInfos) {
            if (row.group != group) continue;
            rows.items.push_back(
                {.label = choice(row.kind).label, .group = row.group, .tooltip = row.tooltip});
            rows.kinds.push_back(row.kind);
        }
    return rows;
}

std::optional<ProceduralKind> procedural_menu(Ui& ui, const char* popup) {
    std::optional<ProceduralKind> chosen;
    PopupMenu menu(ui, popup, 180);
    if (!menu.open()) return chosen;
    const ProceduralRows rows = procedural_rows();
    std::string_view group;
    for (std::size_t i = 0; i < rows.items.size(); ++i) {
        const ComboItem& row = rows.items[i];
        if (row.group != group) menu.heading(row.group);
        group = row.group;
        if (menu.item({.label = row.label, .tooltip = row.tooltip})) chosen = rows.kinds[i];
    }
    return chosen;
}

std::optional<AdjustmentKind> adjustment_menu(Ui& ui, const char* popup) {
    std::optional<AdjustmentKind> chosen;
    PopupMenu menu(ui, popup, 180);
    if (!menu.open()) return chosen;
    const auto table = choices<AdjustmentKind>();
    for (std::size_t i = 0; i < table.size(); ++i)
        if (menu.item({.label = table[i].label})) chosen = static_cast<AdjustmentKind>(i);
    return chosen;
}

}  // namespace patina::editor
