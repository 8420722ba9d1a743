// SPDX-License-Identifier: MIT
#pragma once

/// Cube maps in 32-bit floats with mips and a border, as the filters sample them. Faces +X -X +Y -Y
/// +Z -Z with OpenGL's orientation.

#include <glm/glm.hpp>
#include <vector>

#include "render/radiance_map.h"

namespace patina::render {

inline constexpr int kCubeFaces = 6;

/// One level: each face side x side texels inside a border one texel wide, which continues the face
/// on its neighbours, so that bilinear reading shows no edge. Four floats a texel, the last unused.
struct CubeLevel {
    int side = 0;
    std::vector<glm::vec4> texels;

    int stride() const { return side + 2; }
    /// x and y from -1 (border) to side.
    std::size_t index(int face, int x, int y) const {
        return (std::size_t(face) * std::size_t(stride()) + std::size_t(y + 1)) *
                   std::size_t(stride()) +
               std::size_t(x + 1);
    }
};

using RadianceCube = std::vector<CubeLevel>;  ///< level i is side >> i, down to 1

/// The direction of the middle of a texel, unit.
glm::vec3 cube_texel_direction(int face, int side, int x, int y);
/// Steradians of a texel.
float cube_texel_solid_angle(int side, int x, int y);

/// A map resampled to faces of `side`.
CubeLevel cube_level(const RadianceMap& map, int side);
/// The same for a power of two, with all mips.
RadianceCube radiance_cube(const RadianceMap& map, int side);

/// Bilinear, from one level; the direction need not be unit.
glm::vec3 radiance_from(const CubeLevel& level, const glm::vec3& direction_map);

}  // namespace patina::render
