// SPDX-License-Identifier: MIT
#include "editor/layout.h"

#include <algorithm>

namespace patina::editor {
namespace {

constexpr float kLeastLeft = 232.0f;
constexpr float kLeastRight = 272.0f;
constexpr float kLeastCenter = 560.0f;
constexpr float kLeastViewport = 240.0f;

/// The table of UI.md.
struct Measures {
    float left;
    float right;
    float shelf;
    float strip;
};

constexpr Measures measures_of(WidthClass width_class) {
    switch (width_class) {
        case WidthClass::Wide:
            return {312, 376, 170, 104};
        case WidthClass::Medium:
            return {256, 284, 140, 71};
        case WidthClass::Narrow:
            return {0, 284, 140, 71};
    }
    return {};
}

float chosen(float splitter, float standard) {
    return splitter > 0.0f ? splitter : standard;
}

struct Columns {
    float left = 0.0f;
    float right = 0.0f;
};

/// The centre keeps its least width; the left column gives way first.
Columns columns_of(const Measures& measures, const Splitters& splitters, float logical_width) {
    Columns columns;
    const float room = logical_width - kLeastCenter - 4 * theme::kGap;
    columns.right = std::max(chosen(splitters.right, measures.right), kLeastRight);
    columns.right = std::min(columns.right, std::max(room, kLeastRight));
    if (measures.left > 0.0f) {
        columns.left = std::max(chosen(splitters.left, measures.left), kLeastLeft);
        columns.left = std::min(columns.left, std::max(room - columns.right, kLeastLeft));
    }
    return columns;
}

void cut_left_column(const Ui& ui, Layout& layout, Rect column, const ViewState& view,
                     const LayoutNeeds& needs) {
    const float gap = ui.px(theme::kGap);
    const std::size_t rows = layout.width_class == WidthClass::Wide ? 5 : 2;
    const auto shown = static_cast<float>(std::clamp<std::size_t>(needs.materials, 1, rows));
    const float standard = theme::kPanelTitle + shown * theme::kMaterialRow + 6;
    layout.materials = column.cut_top(ui.px(chosen(view.splitters.materials, standard)));
    column.cut_top(gap);
    if (layout.width_class == WidthClass::Wide) {
        layout.history = column.cut_bottom(ui.px(theme::kPanelTitle + 4 * theme::kHistoryRow + 6));
        column.cut_bottom(gap);
    }
    layout.layers = column;
}

void cut_center_column(const Ui& ui, Layout& layout, Rect column, const ViewState& view,
                       const LayoutNeeds& needs) {
    const Measures measures = measures_of(layout.width_class);
    if (!view.panels_hidden && needs.histogram <= 0.0f) {
        const bool narrow = layout.width_class == WidthClass::Narrow;
        const bool open = narrow ? view.unfolded.narrow_shelf : view.unfolded.shelf;
        const float standard =
            open ? chosen(view.splitters.shelf, measures.shelf) : theme::kPanelTitle;
        layout.shelf = column.cut_bottom(ui.px(standard));
        column.cut_bottom(ui.px(theme::kGap));
    }
    layout.center = column;
    layout.viewport_bar = column.cut_top(ui.px(theme::kViewportBar));
    const float strip = needs.histogram > 0.0f ? needs.histogram : measures.strip;
    layout.histogram = needs.histogram > 0.0f;
    const float least = ui.px(kLeastViewport);
    if (!view.panels_hidden && column.height() - ui.px(strip) >= least)
        layout.strip = column.cut_bottom(ui.px(strip));
    layout.viewport = column;
}

struct Splitter {
    const char* name;
    Rect rect;
    bool vertical;  ///< the line is; the drag is sideways
    float sign;     ///< of the pointer's movement on the size
    float current;  ///< logical
    float* stored;
};

void draw_splitter(Ui& ui, const Splitter& splitter) {
    if (splitter.rect.empty()) return;
    const Press pressed =
        press(ui, splitter.rect, {.label = splitter.name, .kind = "splitter", .focusable = false});
    if (pressed.hovered || pressed.held) {
        ImGui::SetMouseCursor(splitter.vertical ? ImGuiMouseCursor_ResizeEW
                                                : ImGuiMouseCursor_ResizeNS);
        const float mid = ui.px(1);
        fill(ui, splitter.vertical ? splitter.rect.inset(mid, 0) : splitter.rect.inset(0, mid),
             theme::kAccent);
    }
    if (pressed.double_clicked) *splitter.stored = 0.0f;
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    const float along = (splitter.vertical ? moved.x : moved.y) * splitter.sign / ui.scale;
    if (pressed.held && !pressed.started && along != 0.0f)
        *splitter.stored = std::max(splitter.current + along, 48.0f);
}

}  // namespace

Layout layout_for(const Ui& ui, const Rect& window, const ViewState& view,
                  const LayoutNeeds& needs) {
    Layout layout;
    const float logical_width = window.width() / ui.scale;
    layout.width_class = logical_width >= 1600   ? WidthClass::Wide
                         : logical_width >= 1200 ? WidthClass::Medium
                                                 : WidthClass::Narrow;
    const float gap = ui.px(theme::kGap);
    Rect rest = window;
    layout.top_bar = rest.cut_top(ui.px(theme::kTopBar));
    layout.status_bar = rest.cut_bottom(ui.px(theme::kStatusBar));
    rest = rest.inset(gap);
    if (!view.panels_hidden) {
        // Three views need the room of the left column.
        const bool views_only = needs.histogram > 0.0f && layout.width_class != WidthClass::Wide;
        const Columns columns =
            columns_of(measures_of(layout.width_class), view.splitters, logical_width);
        if (columns.left > 0.0f && !views_only) {
            layout.left = rest.cut_left(ui.px(columns.left));
            rest.cut_left(gap);
            cut_left_column(ui, layout, layout.left, view, needs);
        }
        layout.right = rest.cut_right(ui.px(columns.right));
        rest.cut_right(gap);
        if (layout.width_class == WidthClass::Narrow && view.right_tab == RightTab::Layers) {
            Rect below_tabs = layout.right;
            below_tabs.cut_top(ui.px(theme::kPanelTitle) + ui.px(1));
            cut_left_column(ui, layout, below_tabs, view, needs);
        }
    }
    cut_center_column(ui, layout, rest, view, needs);
    return layout;
}

void draw_splitters(Ui& ui, const Layout& layout, Splitters& splitters) {
    const float gap = ui.px(theme::kGap);
    const auto beside = [&](const Rect& rect, bool right) {
        if (rect.empty()) return Rect{};
        return right ? Rect{rect.x1, rect.y0, rect.x1 + gap, rect.y1}
                     : Rect{rect.x0 - gap, rect.y0, rect.x0, rect.y1};
    };
    const auto above = [&](const Rect& rect) {
        return rect.empty() ? Rect{} : Rect{rect.x0, rect.y0 - gap, rect.x1, rect.y0};
    };
    const float scale = ui.scale;
    draw_splitter(ui, {"Left splitter", beside(layout.left, true), true, 1.0f,
                       layout.left.width() / scale, &splitters.left});
    draw_splitter(ui, {"Right splitter", beside(layout.right, false), true, -1.0f,
                       layout.right.width() / scale, &splitters.right});
    draw_splitter(ui, {"Materials splitter", above(layout.layers), false, 1.0f,
                       layout.materials.height() / scale, &splitters.materials});
    if (layout.shelf.height() > ui.px(theme::kPanelTitle) + 1)
        draw_splitter(ui, {"Shelf splitter", above(layout.shelf), false, -1.0f,
                           layout.shelf.height() / scale, &splitters.shelf});
}

}  // namespace patina::editor
