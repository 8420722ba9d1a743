// SPDX-License-Identifier: MIT
#include "scene/uv_layout.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace patina {
namespace {

/// Corners are rounded to this part of a texel, so that edges are compared exactly.
constexpr std::int64_t kSteps = 256;
/// A triangle that reaches over more tiles than this covers every texel several times.
constexpr float kMostTiles = 8.0f;

using Point = std::array<std::int64_t, 2>;
using Corners = std::array<glm::vec2, 3>;

bool is_finite(const Corners& corners) {
    return std::all_of(corners.begin(), corners.end(), [](const glm::vec2& uv) {
        // Beyond that a float has no texels any more.
        return std::abs(uv.x) < 1e5f && std::abs(uv.y) < 1e5f;
    });
}

/// Calls visit(corners) for each triangle of the material that has UVs; returns how many have none.
template <typename Visit>
std::size_t for_each_triangle(const Scene& scene, int source_material, int uv_set,
                              const Visit& visit) {
    std::size_t without = 0;
    for (const Mesh& mesh : scene.meshes)
        for (const Primitive& primitive : mesh.primitives) {
            if (primitive.source_material != source_material) continue;
            const auto& uvs = primitive.uvs[static_cast<std::size_t>(uv_set)];
            for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
                Corners corners;
                for (std::size_t k = 0; k < 3 && !uvs.empty(); ++k)
                    corners[k] = uvs[primitive.indices[i + k]];
                if (uvs.empty() || !is_finite(corners))
                    ++without;
                else
                    visit(corners);
            }
        }
    return without;
}

/// Twice the area of a, b and c; above 0 where they turn as x turns to y.
std::int64_t area(const Point& a, const Point& b, const Point& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Of two triangles on the two sides of an edge, in opposite directions, one owns what lies on it.
bool owns_edge(const Point& from, const Point& to) {
    return to[1] < from[1] || (to[1] == from[1] && to[0] > from[0]);
}

class Rasteriser {
  public:
    explicit Rasteriser(UvCoverage& coverage) : coverage_(coverage) {}

    void add(const Corners& corners) {
        const glm::vec2 low = glm::min(corners[0], glm::min(corners[1], corners[2]));
        const glm::vec2 high = glm::max(corners[0], glm::max(corners[1], corners[2]));
        if (high.x - low.x > kMostTiles || high.y - low.y > kMostTiles) {
            for (std::uint8_t& count : coverage_.counts)
                count = static_cast<std::uint8_t>(std::min(count + 2, 255));
            return;
        }
        std::array<Point, 3> points;
        for (std::size_t k = 0; k < 3; ++k) points[k] = point_of(corners[k]);
        const std::int64_t turn = area(points[0], points[1], points[2]);
        if (turn == 0) return;
        if (turn < 0) std::swap(points[1], points[2]);
        fill(points);
    }

  private:
    Point point_of(const glm::vec2& uv) const {
        const double scale = static_cast<double>(coverage_.size * kSteps);
        return {std::llround(static_cast<double>(uv.x) * scale),
                std::llround(static_cast<double>(uv.y) * scale)};
    }

    /// The texels whose middles lie inside, the corners turning as x turns to y.
    void fill(const std::array<Point, 3>& points) {
        const auto bounds = [&](std::size_t axis) {
            return std::minmax({points[0][axis], points[1][axis], points[2][axis]});
        };
        const auto [low_x, high_x] = bounds(0);
        const auto [low_y, high_y] = bounds(1);
        for (std::int64_t y = texel(low_y); y <= texel(high_y); ++y)
            for (std::int64_t x = texel(low_x); x <= texel(high_x); ++x)
                if (holds(points, {x * kSteps + kSteps / 2, y * kSteps + kSteps / 2})) count(x, y);
    }

    static std::int64_t texel(std::int64_t steps) {
        return steps >= 0 ? steps / kSteps : -((-steps + kSteps - 1) / kSteps);
    }

    static bool holds(const std::array<Point, 3>& points, const Point& middle) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Point& from = points[k];
            const Point& to = points[(k + 1) % 3];
            const std::int64_t side = area(from, to, middle);
            if (side < 0 || (side == 0 && !owns_edge(from, to))) return false;
        }
        return true;
    }

    void count(std::int64_t x, std::int64_t y) {
        const auto wrapped = [&](std::int64_t i) {
            const std::int64_t rest = i % coverage_.size;
            return static_cast<std::size_t>(rest < 0 ? rest + coverage_.size : rest);
        };
        std::uint8_t& count =
            coverage_.counts[wrapped(y) * static_cast<std::size_t>(coverage_.size) + wrapped(x)];
        if (count < 255) ++count;
    }

    UvCoverage& coverage_;
};

}  // namespace

UvCoverage uv_coverage(const Scene& scene, int source_material, int uv_set, int size) {
    UvCoverage coverage{.size = size};
    coverage.counts.resize(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    Rasteriser rasteriser(coverage);
    for_each_triangle(scene, source_material, uv_set,
                      [&](const Corners& corners) { rasteriser.add(corners); });
    return coverage;
}

UvLayout uv_layout(const Scene& scene, int source_material, int uv_set, int size) {
    UvLayout layout{.low = glm::vec2(1e30f), .high = glm::vec2(-1e30f)};
    layout.without_uvs =
        for_each_triangle(scene, source_material, uv_set, [&](const Corners& corners) {
            ++layout.triangles;
            for (const glm::vec2& uv : corners) {
                layout.low = glm::min(layout.low, uv);
                layout.high = glm::max(layout.high, uv);
            }
        });
    if (layout.triangles == 0) layout.low = layout.high = glm::vec2(0.0f);
    layout.triangles += layout.without_uvs;
    const UvCoverage coverage = uv_coverage(scene, source_material, uv_set, size);
    std::size_t used = 0, shared = 0;
    for (const std::uint8_t count : coverage.counts) {
        used += count > 0;
        shared += count > 1;
    }
    layout.used = static_cast<double>(used) / static_cast<double>(coverage.counts.size());
    layout.overlapped = used == 0 ? 0.0 : static_cast<double>(shared) / static_cast<double>(used);
    return layout;
}

}  // namespace patina
