// SPDX-License-Identifier: MIT
#pragma once

/// Where the panels are: fixed columns with draggable gaps, chosen by the logical width (pixels /
/// scale) of the window.

#include "editor/state/view_state.h"
#include "editor/widgets/ui.h"

namespace patina::editor {

enum class WidthClass { Narrow, Medium, Wide };  ///< under 1200, to 1599, 1600 and more

struct Layout {
    WidthClass width_class = WidthClass::Wide;
    Rect top_bar;
    Rect left;       ///< empty when narrow or hidden
    Rect materials;  ///< within left; of a narrow window within right, while that tab is chosen
    Rect layers;     ///< likewise
    Rect history;    ///< within left; empty unless wide
    Rect center;     ///< the panel with bar, viewport and strip
    Rect viewport_bar;
    Rect viewport;
    Rect strip;  ///< of channels, or the histogram
    bool histogram = false;
    Rect shelf;
    Rect right;
    Rect status_bar;
};

/// What decides the heights within the left column.
struct LayoutNeeds {
    std::size_t materials = 0;
    float histogram =
        0.0f;  ///< logical height below the viewport instead of the strip; 0: the strip
};

Layout layout_for(const Ui& ui, const Rect& window, const ViewState& view,
                  const LayoutNeeds& needs);

/// The gaps between the panels: drag to resize, double-click to reset.
void draw_splitters(Ui& ui, const Layout& layout, Splitters& splitters);

}  // namespace patina::editor
