// SPDX-License-Identifier: MIT
#include "scene/uv_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/uv_triangle.h"

namespace patina {
namespace {

/// Calls visit(corners) for each triangle that has UVs; returns how many have none.
template <typename Visit>
std::size_t for_each_triangle(const UvSurface& surface, const Visit& visit) {
    std::size_t without = 0;
    for (std::uint32_t triangle = 0; triangle < surface.triangle_count(); ++triangle) {
        if (const auto corners = surface.corners_of(triangle))
            visit(*corners);
        else
            ++without;
    }
    return without;
}

/// Texels looked at, about a second's worth.
constexpr std::uint64_t kMostTexelsSeen = std::uint64_t{1} << 28;

void count(std::size_t index, UvCoverage& coverage, int times) {
    std::uint8_t& counted = coverage.counts[index];
    counted = static_cast<std::uint8_t>(std::min(counted + times, 255));
}

void add(const UvCorners& corners, UvCoverage& coverage) {
    if (is_vast(corners)) {
        for (std::size_t i = 0; i < coverage.counts.size(); ++i) count(i, coverage, 2);
        return;
    }
    const auto triangle = UvTriangle::on_map(corners, coverage.size);
    if (!triangle) return;
    for (std::int64_t y = triangle->low_y(); y <= triangle->high_y(); ++y)
        for (std::int64_t x = triangle->low_x(); x <= triangle->high_x(); ++x)
            if (triangle->holds(x, y))
                count(wrapped_texel(y, coverage.size) * static_cast<std::size_t>(coverage.size) +
                          wrapped_texel(x, coverage.size),
                      coverage, 1);
}

/// Nothing is "0 %" but nothing, and nothing "100 %" but all.
std::string percent(double share) {
    if (share > 0.0 && share < 0.01) return "less than 1 %";
    return fmt::format("{:.0f} %", share < 1.0 ? std::floor(100.0 * share) : 100.0);
}

}  // namespace

UvCoverage uv_coverage(const UvSurface& surface, int size) {
    UvCoverage coverage{.size = size};
    coverage.counts.resize(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    for_each_triangle(surface, [&](const UvCorners& corners) { add(corners, coverage); });
    return coverage;
}

UvLayout uv_layout(const UvSurface& surface, int size) {
    UvLayout layout{.low = glm::vec2(1e30f), .high = glm::vec2(-1e30f)};
    std::uint64_t work = 0;
    layout.without_uvs = for_each_triangle(surface, [&](const UvCorners& corners) {
        ++layout.triangles;
        work = std::min(work + texels_looked_at(corners, size), kMostTexelsSeen + 1);
        for (const glm::vec2& uv : corners) {
            layout.low = glm::min(layout.low, uv);
            layout.high = glm::max(layout.high, uv);
        }
    });
    if (layout.triangles == 0) layout.low = layout.high = glm::vec2(0.0f);
    layout.triangles += layout.without_uvs;
    layout.measured = work <= kMostTexelsSeen;
    if (!layout.measured) return layout;
    const UvCoverage coverage = uv_coverage(surface, size);
    std::size_t used = 0, shared = 0;
    for (const std::uint8_t count : coverage.counts) {
        used += count > 0;
        shared += count > 1;
    }
    layout.used = static_cast<double>(used) / static_cast<double>(coverage.counts.size());
    layout.overlapped = used == 0 ? 0.0 : static_cast<double>(shared) / static_cast<double>(used);
    return layout;
}

std::string uv_layout_words(const UvLayout& layout) {
    if (layout.triangles == 0) return "no triangle is made of it";
    if (layout.without_uvs == layout.triangles) return "its triangles have no UVs";
    std::string text =
        layout.measured ? fmt::format("{} of the texture is used", percent(layout.used))
                        : fmt::format("too many large triangles to measure ({})", layout.triangles);
    if (layout.overlapped > 0.0)
        text += fmt::format(", {} of that by several triangles", percent(layout.overlapped));
    if (!layout.within_a_tile())
        text += fmt::format(", from ({:.3g}, {:.3g}) to ({:.3g}, {:.3g})", layout.low.x,
                            layout.low.y, layout.high.x, layout.high.y);
    if (layout.without_uvs > 0)
        text += fmt::format(", {} triangles have no UVs", layout.without_uvs);
    return text;
}

}  // namespace patina
