// SPDX-License-Identifier: MIT
#include "editor/widgets/curve_field.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "composite/curve_slopes.h"
#include "core/formulae/formulae.h"
#include "document/parameters.h"
#include "editor/widgets/number_text.h"
#include "editor/widgets/popup_menu.h"

namespace patina::editor {
namespace {

// Logical pixels.
constexpr float kMargin = 8.0f;  // of the graph in its field, so that a point at a corner is whole
constexpr float kGrabRadius = 9.0f;
constexpr float kDragOff = 28.0f;  // beyond the field, where a point that is let go is removed
constexpr float kPointDragStart = 3.0f;

constexpr float kLeastGap = 0.002f;  // between two points: they have to ascend
constexpr float kRound = 1000.0f;    // a drag stops at thousandths

const std::vector<CurvePoint> kStraight = {{0.0f, 0.0f}, {1.0f, 1.0f}};

/// The square 0..1 of the curve in pixels of the window.
struct Graph {
    Rect rect;

    glm::vec2 pixel(const CurvePoint& point) const {
        return {rect.x0 + point.x * rect.width(), rect.y1 - point.y * rect.height()};
    }
    CurvePoint point(const glm::vec2& pixel) const {
        const auto rounded = [](float share) {
            return std::clamp(std::round(share * kRound) / kRound, 0.0f, 1.0f);
        };
        return {rounded((pixel.x - rect.x0) / rect.width()),
                rounded((rect.y1 - pixel.y) / rect.height())};
    }
};

glm::vec2 pointer() {
    const ImVec2 mouse = ImGui::GetMousePos();
    return {mouse.x, mouse.y};
}

std::optional<std::size_t> point_under(const Ui& ui, const Graph& graph,
                                       const std::vector<CurvePoint>& points) {
    std::optional<std::size_t> nearest;
    float least = kGrabRadius * ui.scale;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const float distance = glm::distance(graph.pixel(points[i]), pointer());
        if (distance > least) continue;
        least = distance;
        nearest = i;
    }
    return nearest;
}

void hold_point(const Graph& graph, const std::vector<CurvePoint>& points, std::size_t index,
                CurveHold& hold) {
    hold = {.selected = index, .dragging = true, .others = points};
    hold.others.erase(hold.others.begin() + static_cast<std::ptrdiff_t>(index));
    hold.from_pointer = graph.pixel(points[index]) - pointer();
}

/// The points with a new one at the pointer, which is held; unset where there can be no more.
std::optional<std::vector<CurvePoint>> with_point_added(const Graph& graph,
                                                        const std::vector<CurvePoint>& points,
                                                        CurveHold& hold) {
    if (points.size() >= std::size_t{kMaxCurvePoints}) return std::nullopt;
    const CurvePoint added = graph.point(pointer());
    const auto after = std::find_if(points.begin(), points.end(),
                                    [&](const CurvePoint& each) { return each.x > added.x; });
    const auto index = static_cast<std::size_t>(after - points.begin());
    std::vector<CurvePoint> more = points;
    more.insert(more.begin() + static_cast<std::ptrdiff_t>(index), added);
    more = with_point_at(std::move(more), index, added);
    hold_point(graph, more, index, hold);
    hold.from_pointer = {};
    return more;
}

/// The points while one is dragged: without it where the pointer has left the field.
std::vector<CurvePoint> dragged(const Ui& ui, const Rect& field, const Graph& graph,
                                const CurveHold& hold) {
    const glm::vec2 at = pointer();
    if (!field.inset(-kDragOff * ui.scale).contains(at.x, at.y) && hold.others.size() >= 2)
        return hold.others;
    std::vector<CurvePoint> points = hold.others;
    points.insert(points.begin() + static_cast<std::ptrdiff_t>(hold.selected), CurvePoint{});
    return with_point_at(std::move(points), hold.selected, graph.point(at + hold.from_pointer));
}

void paint_curve(const Ui& ui, const Graph& graph, const std::vector<CurvePoint>& points) {
    formulae::Curve curve = {};
    curve.count = static_cast<int>(points.size());
    const std::vector<float> slopes = curve_slopes(points);
    for (std::size_t i = 0; i < points.size(); ++i)
        curve.points[i] = {points[i].x, points[i].y, slopes[i]};
    constexpr int kSteps = 96;
    std::array<ImVec2, kSteps + 1> corners;
    for (int i = 0; i <= kSteps; ++i) {
        const float x = static_cast<float>(i) / kSteps;
        const glm::vec2 pixel = graph.pixel({x, formulae::curve_value(curve, x)});
        corners[static_cast<std::size_t>(i)] = ImVec2(pixel.x, pixel.y);
    }
    ImGui::GetWindowDrawList()->AddPolyline(
        corners.data(), kSteps + 1, with_alpha(theme::kAccentHigh, ui.alpha), 0, 1.5f * ui.scale);
}

void paint(const Ui& ui, const Rect& field, const Graph& graph,
           const std::vector<CurvePoint>& points, const CurveHold& hold) {
    fill(ui, field, theme::kField, 4);
    const Rect& box = graph.rect;
    for (int i = 0; i <= 4; ++i) {
        const float share = 0.25f * static_cast<float>(i);
        const float x = std::floor(box.x0 + share * box.width()) + 0.5f;
        const float y = std::floor(box.y0 + share * box.height()) + 0.5f;
        line(ui, x, box.y0, x, box.y1, theme::kTrack, 1);
        line(ui, box.x0, y, box.x1, y, theme::kTrack, 1);
    }
    line(ui, box.x0, box.y1, box.x1, box.y0, theme::kFieldPressed, 1);
    paint_curve(ui, graph, points);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::vec2 at = graph.pixel(points[i]);
        const bool selected = i == hold.selected;
        disc(ui, at.x, at.y, 4, selected ? theme::kAccentHigh : theme::kText);
        if (selected) ring(ui, at.x, at.y, 6, theme::kText, 1);
    }
}

/// Enter goes to the next point, the arrows move the one that is selected.
std::optional<std::vector<CurvePoint>> moved_by_keys(Ui& ui, const std::vector<CurvePoint>& points,
                                                     CurveHold& hold) {
    ui.focus.take({ImGuiKey_LeftArrow, ImGuiKey_RightArrow, ImGuiKey_UpArrow, ImGuiKey_DownArrow});
    if (ui.focus.pressed()) hold.selected = (hold.selected + 1) % points.size();
    const auto step = [](Parameter parameter, int steps) {
        return static_cast<float>(info(parameter).step) * static_cast<float>(steps);
    };
    const float right = step(Parameter::CurveX, ui.focus.arrow_step());
    const float down = step(Parameter::CurveY, ui.focus.row_step());
    if (right == 0.0f && down == 0.0f) return std::nullopt;
    const CurvePoint& now = points[hold.selected];
    return with_point_at(points, hold.selected, {now.x + right, now.y - down});
}

std::optional<std::vector<CurvePoint>> point_menu(Ui& ui, const std::vector<CurvePoint>& points,
                                                  const CurveHold& hold) {
    std::optional<std::vector<CurvePoint>> changed;
    PopupMenu menu(ui, "curve menu", 150);
    if (!menu.open()) return changed;
    if (menu.item({.icon = icon::kTrash,
                   .label = "Remove point",
                   .key = "Delete",
                   .enabled = points.size() > 2}))
        changed = without_point(points, hold.selected);
    if (menu.item({.icon = icon::kReset, .label = "Straight line", .enabled = points != kStraight}))
        changed = kStraight;
    return changed;
}

/// For the UiMap: the points are part of one control.
void note_points(Ui& ui, const Graph& graph, const std::vector<CurvePoint>& points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::vec2 at = graph.pixel(points[i]);
        const float radius = ui.px(4);
        ui.map.add(fmt::format("Point {}", i + 1), "point",
                   fmt::format("{}, {}", number_text(static_cast<double>(points[i].x)),
                               number_text(static_cast<double>(points[i].y))),
                   visible_part({at.x - radius, at.y - radius, at.x + radius, at.y + radius}),
                   true);
    }
}

/// What the mouse does to the points.
std::optional<std::vector<CurvePoint>> worked_by_mouse(const Ui& ui, const Rect& field,
                                                       const Graph& graph, const Press& pressed,
                                                       const std::vector<CurvePoint>& points,
                                                       CurveHold& hold) {
    if (pressed.started) {
        if (const auto under = point_under(ui, graph, points)) {
            hold_point(graph, points, *under, hold);
            return std::nullopt;
        }
        return with_point_added(graph, points, hold);
    }
    if (!hold.dragging || !pressed.held) return std::nullopt;
    const ImVec2 moved =
        ImGui::GetMouseDragDelta(ImGuiMouseButton_Left, kPointDragStart * ui.scale);
    if (moved.x == 0.0f && moved.y == 0.0f) return std::nullopt;
    std::vector<CurvePoint> next = dragged(ui, field, graph, hold);
    return next != points ? std::optional(std::move(next)) : std::nullopt;
}

}  // namespace

std::vector<CurvePoint> with_point_at(std::vector<CurvePoint> points, std::size_t index,
                                      CurvePoint to) {
    const float low = index == 0 ? 0.0f : points[index - 1].x + kLeastGap;
    const float high = index + 1 == points.size() ? 1.0f : points[index + 1].x - kLeastGap;
    // Where the neighbours leave no room, the middle between them still ascends.
    const float x = low < high ? std::clamp(to.x, low, high) : 0.5f * (low + high);
    points[index] = {x, std::clamp(to.y, 0.0f, 1.0f)};
    return points;
}

std::vector<CurvePoint> without_point(std::vector<CurvePoint> points, std::size_t index) {
    if (points.size() > 2) points.erase(points.begin() + static_cast<std::ptrdiff_t>(index));
    return points;
}

std::optional<std::vector<CurvePoint>> curve_field(Ui& ui, const Rect& rect, std::string_view label,
                                                   const std::vector<CurvePoint>& points,
                                                   CurveHold& hold) {
    if (!hold.dragging) hold.selected = std::min(hold.selected, points.size() - 1);
    const Place place(ui, label);
    const Graph graph{rect.inset(ui.px(kMargin))};
    const Tip tip{
        std::string(label),
        fmt::format("Click to add a point, {} at most; drag one to move it, off the graph "
                    "to remove it",
                    kMaxCurvePoints),
        "Delete"};
    const Press pressed = press(
        ui, rect,
        {.label = label, .kind = "curve", .value = counted(points.size(), "point"), .tip = &tip});
    auto changed = worked_by_mouse(ui, rect, graph, pressed, points, hold);
    if (pressed.released) {
        hold.dragging = false;
        ui.edit_ended = true;
    }
    if (pressed.focused && !changed) changed = moved_by_keys(ui, points, hold);
    if (pressed.hovered || pressed.focused) {
        ui.focus.take({ImGuiKey_Delete});
        const bool removed = !hold.dragging && points.size() > 2 &&
                             ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Delete));
        if (removed) changed = without_point(points, hold.selected);
        ui.edit_ended = ui.edit_ended || removed;
    }
    if (pressed.right_clicked) {
        hold.selected = point_under(ui, graph, points).value_or(hold.selected);
        ImGui::OpenPopup("curve menu");
    }
    if (auto chosen = point_menu(ui, points, hold)) {
        changed = std::move(chosen);
        ui.edit_ended = true;
    }
    paint(ui, rect, graph, points, hold);
    note_points(ui, graph, points);
    return changed;
}

}  // namespace patina::editor
