// SPDX-License-Identifier: MIT
#include "scene/uv_triangle.h"

#include <cmath>

namespace patina {
namespace {

/// Corners are rounded to this part of a texel.
constexpr std::int64_t kSteps = 256;

struct Box {
    glm::vec2 low;
    glm::vec2 high;
};

Box box_of(const UvCorners& corners) {
    return {glm::min(corners[0], glm::min(corners[1], corners[2])),
            glm::max(corners[0], glm::max(corners[1], corners[2]))};
}

}  // namespace

bool has_texels(const UvCorners& corners) {
    return std::all_of(corners.begin(), corners.end(), [](const glm::vec2& uv) {
        return std::abs(uv.x) < 1e5f && std::abs(uv.y) < 1e5f;
    });
}

bool is_vast(const UvCorners& corners) {
    const Box box = box_of(corners);
    return box.high.x - box.low.x > kMostUvTiles || box.high.y - box.low.y > kMostUvTiles;
}

std::optional<UvTriangle> UvTriangle::on_map(const UvCorners& corners, int size) {
    const double scale = static_cast<double>(size * kSteps);
    UvTriangle triangle;
    for (std::size_t k = 0; k < 3; ++k)
        triangle.points_[k] = {std::llround(static_cast<double>(corners[k].x) * scale),
                               std::llround(static_cast<double>(corners[k].y) * scale)};
    const std::int64_t turn = area(triangle.points_[0], triangle.points_[1], triangle.points_[2]);
    if (turn == 0) return std::nullopt;
    if (turn < 0) std::swap(triangle.points_[1], triangle.points_[2]);
    return triangle;
}

std::int64_t UvTriangle::bound(std::size_t axis, bool low) const {
    const auto [least, most] = std::minmax({points_[0][axis], points_[1][axis], points_[2][axis]});
    return low ? least : most;
}

std::int64_t UvTriangle::texel_of(std::int64_t steps) {
    return steps >= 0 ? steps / kSteps : -((-steps + kSteps - 1) / kSteps);
}

bool UvTriangle::holds(std::int64_t x, std::int64_t y) const {
    const Point middle = {x * kSteps + kSteps / 2, y * kSteps + kSteps / 2};
    for (std::size_t k = 0; k < 3; ++k) {
        const Point& from = points_[k];
        const Point& to = points_[(k + 1) % 3];
        const std::int64_t side = area(from, to, middle);
        const bool owns_edge = to[1] < from[1] || (to[1] == from[1] && to[0] > from[0]);
        if (side < 0 || (side == 0 && !owns_edge)) return false;
    }
    return true;
}

bool UvTriangle::touches(std::int64_t x, std::int64_t y) const {
    const Point middle = {x * kSteps + kSteps / 2, y * kSteps + kSteps / 2};
    for (std::size_t k = 0; k < 3; ++k) {
        const Point& from = points_[k];
        const Point& to = points_[(k + 1) % 3];
        // What the corner of the texel that lies furthest inside has more than its middle.
        const std::int64_t more =
            (std::abs(to[0] - from[0]) + std::abs(to[1] - from[1])) * (kSteps / 2);
        if (area(from, to, middle) + more <= 0) return false;
    }
    return true;
}

std::uint64_t texels_looked_at(const UvCorners& corners, int size) {
    if (is_vast(corners))
        return static_cast<std::uint64_t>(size) * static_cast<std::uint64_t>(size);
    const Box box = box_of(corners);
    const auto side = [size](float low, float high) {
        return static_cast<std::uint64_t>((static_cast<double>(high) - static_cast<double>(low)) *
                                          size) +
               2;
    };
    return side(box.low.x, box.high.x) * side(box.low.y, box.high.y);
}

}  // namespace patina
