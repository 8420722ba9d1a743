// SPDX-License-Identifier: MIT
#pragma once

/// The curve of an adjustment: a graph with its points. A press between the points adds one, which
/// follows the pointer at once; drag a point to move it, drag it off the graph or press Delete over
/// the graph to remove it, right-click for the rest. With the keyboard, Enter goes to the next
/// point and the arrows move it.

#include <optional>
#include <string_view>
#include <vector>

#include "document/adjustment.h"
#include "editor/widgets/ui.h"

namespace patina::editor {

/// Which point is selected and, while one is dragged, where the others lie.
struct CurveHold {
    std::size_t selected = 0;
    bool dragging = false;
    std::vector<CurvePoint> others = {};  ///< all but the one that is dragged
    glm::vec2 from_pointer = {};          ///< to that one, in pixels
};

/// The points with one of them moved, kept between its neighbours.
std::vector<CurvePoint> with_point_at(std::vector<CurvePoint> points, std::size_t index,
                                      CurvePoint to);
/// The points without one of them; all of them where two are left.
std::vector<CurvePoint> without_point(std::vector<CurvePoint> points, std::size_t index);

/// Returns all points when something changed.
std::optional<std::vector<CurvePoint>> curve_field(Ui& ui, const Rect& rect, std::string_view label,
                                                   const std::vector<CurvePoint>& points,
                                                   CurveHold& hold);

}  // namespace patina::editor
