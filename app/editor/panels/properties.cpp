// SPDX-License-Identifier: MIT
#include "editor/panels/panels.h"
#include "editor/widgets/buttons.h"

namespace patina::editor {

Requests draw_properties(Ui& ui, const Rect& rect, bool narrow, const Shown& shown,
                         ViewState& view) {
    const Place place(ui, "Properties");
    fill(ui, rect, theme::kPanel, 6);
    Rect rest = rect;
    Rect tabs = rest.cut_top(ui.px(theme::kPanelTitle));
    hairline(ui, rest);
    rest.cut_top(ui.px(1));
    tabs.cut_left(ui.px(theme::kPadding));
    // Next to the tabs of the selection: what the view needs, comparing or explaining.
    const bool comparing = is_comparing(view);
    const RightTab chosen =
        !narrow && view.right_tab == RightTab::Layers ? RightTab::Layer : view.right_tab;
    if (narrow && tab(ui, tabs, {"Layers", chosen == RightTab::Layers}))
        view.right_tab = RightTab::Layers;
    if (tab(ui, tabs, {"Layer", chosen == RightTab::Layer})) view.right_tab = RightTab::Layer;
    if (tab(ui, tabs, {"Material", view.right_tab == RightTab::Material}))
        view.right_tab = RightTab::Material;
    if (tab(ui, tabs, {comparing ? "Compare" : "Explain", view.right_tab == RightTab::Inspect}))
        view.right_tab = RightTab::Inspect;
    switch (chosen) {
        case RightTab::Layers:
            return {};
        case RightTab::Layer:
            return draw_layer_tab(ui, rest, shown, view);
        case RightTab::Material:
            return draw_material_tab(ui, rest, shown, view);
        case RightTab::Inspect:
            return comparing ? draw_compare_tab(ui, rest, shown, view)
                             : draw_explain_tab(ui, rest, shown, view);
    }
    return {};
}

}  // namespace patina::editor
