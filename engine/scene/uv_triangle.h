// SPDX-License-Identifier: MIT
#pragma once

/// A triangle of UVs on the texels of a square map, in whole steps of a fraction of a texel, so
/// that edges are compared exactly: no texel is lost or taken twice between two triangles that
/// share one.

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>

namespace patina {

using UvCorners = std::array<glm::vec2, 3>;

/// A triangle that reaches over more tiles than this lies on every texel many times.
inline constexpr float kMostUvTiles = 8.0f;

/// Whether a float has texels left where the corners are: all within 100 000 tiles of the first.
bool has_texels(const UvCorners& corners);
/// Whether it reaches over more than kMostUvTiles.
bool is_vast(const UvCorners& corners);

class UvTriangle {
  public:
    /// Nothing of a triangle without area. The corners have texels and are not vast.
    static std::optional<UvTriangle> on_map(const UvCorners& corners, int size);

    /// The texels around it: [low, high], past the border where it lies in other tiles.
    std::int64_t low_x() const { return texel_of(bound(0, true)); }
    std::int64_t high_x() const { return texel_of(bound(0, false)); }
    std::int64_t low_y() const { return texel_of(bound(1, true)); }
    std::int64_t high_y() const { return texel_of(bound(1, false)); }

    /// Whether the middle of the texel lies inside. Of two triangles that share an edge one has
    /// what lies on it.
    bool holds(std::int64_t x, std::int64_t y) const;
    /// Whether any of the texel, which is among those around the triangle, does.
    bool touches(std::int64_t x, std::int64_t y) const;

  private:
    using Point = std::array<std::int64_t, 2>;

    std::int64_t bound(std::size_t axis, bool low) const;
    static std::int64_t texel_of(std::int64_t steps);
    static std::int64_t area(const Point& a, const Point& b, const Point& c) {
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    }

    std::array<Point, 3> points_;  ///< turning as x turns to y
};

/// How many texels are looked at to find those of a triangle.
std::uint64_t texels_looked_at(const UvCorners& corners, int size);

/// An index from beyond the border, brought inside.
inline std::size_t wrapped_texel(std::int64_t index, int size) {
    const std::int64_t rest = index % size;
    return static_cast<std::size_t>(rest < 0 ? rest + size : rest);
}

}  // namespace patina
