// SPDX-License-Identifier: MIT
#pragma once

/// How the triangles of a material lie in its texture: what of it they use, and where several share
/// a place, so that whatever is there shows on all of them.

#include <cstdint>
#include <string>
#include <vector>

#include "scene/uv_surface.h"

namespace patina {

/// How many triangles cover the middle of each texel, 255 at most; row 0 is at the top, v = 0.
/// Triangles that share an edge do not share the texels on it. UVs beyond 0..1 repeat.
struct UvCoverage {
    int size = 0;
    std::vector<std::uint8_t> counts = {};
};

struct UvLayout {
    double used = 0.0;                ///< share of the texture that triangles cover, 0 to 1
    double overlapped = 0.0;          ///< share of what is covered that several do, 0 to 1
    glm::vec2 low = glm::vec2(0.0f);  ///< where the UVs reach
    glm::vec2 high = glm::vec2(0.0f);
    std::size_t triangles = 0;
    std::size_t without_uvs = 0;  ///< triangles that have none, or no finite ones
    bool measured = true;         ///< false: `used` and `overlapped` are not known

    /// Whether all lies in one tile of the texture.
    bool within_a_tile() const { return low.x >= 0 && low.y >= 0 && high.x <= 1 && high.y <= 1; }
};

/// @param size  texels a side, 1 to 16384
UvCoverage uv_coverage(const UvSurface& surface, int size);
/// Of so many large triangles that it would take longer than a second or so, only what needs no
/// texels is told: see UvLayout::measured.
UvLayout uv_layout(const UvSurface& surface, int size = 1024);

/// In words for people: "62 % of the texture is used, 8 % of that by several triangles".
std::string uv_layout_words(const UvLayout& layout);

}  // namespace patina
