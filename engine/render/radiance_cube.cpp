// SPDX-License-Identifier: MIT
#include "render/radiance_cube.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/formulae/formulae.h"
#include "core/parallel.h"

namespace patina::render {
namespace {

/// Where a direction meets the cube, s and t in -1..1: the inverse of formulae::cube_direction.
struct FacePoint {
    int face;
    float s;
    float t;
};

FacePoint face_point(const glm::vec3& d) {
    const glm::vec3 a = glm::abs(d);
    if (a.x >= a.y && a.x >= a.z)
        return d.x > 0.0f ? FacePoint{0, -d.z / a.x, -d.y / a.x}
                          : FacePoint{1, d.z / a.x, -d.y / a.x};
    if (a.y >= a.z)
        return d.y > 0.0f ? FacePoint{2, d.x / a.y, d.z / a.y}
                          : FacePoint{3, d.x / a.y, -d.z / a.y};
    return d.z > 0.0f ? FacePoint{4, d.x / a.z, -d.y / a.z} : FacePoint{5, -d.x / a.z, -d.y / a.z};
}

float face_coordinate(int texel, int side) {
    return (2.0f * static_cast<float>(texel) + 1.0f) / static_cast<float>(side) - 1.0f;
}

glm::vec3 cube_direction(int face, float s, float t) {
    const formulae::Real3 direction = formulae::cube_direction(face, s, t);
    return {direction.x, direction.y, direction.z};
}

CubeLevel empty_level(int side) {
    CubeLevel level{side, {}};
    level.texels.resize(std::size_t(kCubeFaces) * std::size_t(side + 2) * std::size_t(side + 2));
    return level;
}

/// The texel nearest to a direction, without the border.
std::size_t nearest_texel(const CubeLevel& level, const glm::vec3& direction) {
    const FacePoint point = face_point(direction);
    const auto texel = [&](float coordinate) {
        return std::clamp(int((coordinate * 0.5f + 0.5f) * static_cast<float>(level.side)), 0,
                          level.side - 1);
    };
    return level.index(point.face, texel(point.s), texel(point.t));
}

void fill_border(CubeLevel& level) {
    const int side = level.side;
    for (int face = 0; face < kCubeFaces; ++face)
        for (int i = -1; i <= side; ++i)
            for (const auto& [x, y] :
                 std::array<std::array<int, 2>, 4>{{{i, -1}, {i, side}, {-1, i}, {side, i}}}) {
                const glm::vec3 outside =
                    cube_direction(face, face_coordinate(x, side), face_coordinate(y, side));
                level.texels[level.index(face, x, y)] = level.texels[nearest_texel(level, outside)];
            }
}

CubeLevel halved(const CubeLevel& fine) {
    CubeLevel coarse = empty_level(fine.side / 2);
    for (int face = 0; face < kCubeFaces; ++face)
        for (int y = 0; y < coarse.side; ++y)
            for (int x = 0; x < coarse.side; ++x) {
                glm::vec4 sum(0.0f);
                float weight = 0.0f;
                for (int point = 0; point < 4; ++point) {
                    const int fine_x = 2 * x + (point & 1);
                    const int fine_y = 2 * y + (point >> 1);
                    const float solid_angle = cube_texel_solid_angle(fine.side, fine_x, fine_y);
                    sum += solid_angle * fine.texels[fine.index(face, fine_x, fine_y)];
                    weight += solid_angle;
                }
                coarse.texels[coarse.index(face, x, y)] = sum / weight;
            }
    fill_border(coarse);
    return coarse;
}

}  // namespace

glm::vec3 cube_texel_direction(int face, int side, int x, int y) {
    return glm::normalize(cube_direction(face, face_coordinate(x, side), face_coordinate(y, side)));
}

float cube_texel_solid_angle(int side, int x, int y) {
    return formulae::cube_texel_solid_angle(face_coordinate(x, side), face_coordinate(y, side),
                                            static_cast<float>(side));
}

CubeLevel cube_level(const RadianceMap& map, int side) {
    CubeLevel level = empty_level(side);
    parallel_for(0, std::int64_t{kCubeFaces} * side, 8, [&](std::int64_t first, std::int64_t last) {
        for (std::int64_t row = first; row < last; ++row) {
            const int face = int(row / side);
            const int y = int(row % side);
            for (int x = 0; x < side; ++x) {
                glm::vec3 sum(0.0f);  // of 2 x 2 points inside the texel
                for (int point = 0; point < 4; ++point) {
                    const int sub_x = 2 * x + (point & 1);
                    const int sub_y = 2 * y + (point >> 1);
                    sum += radiance_from(
                        map, glm::normalize(cube_direction(face, face_coordinate(sub_x, 2 * side),
                                                           face_coordinate(sub_y, 2 * side))));
                }
                level.texels[level.index(face, x, y)] = glm::vec4(0.25f * sum, 0.0f);
            }
        }
    });
    fill_border(level);
    return level;
}

RadianceCube radiance_cube(const RadianceMap& map, int side) {
    RadianceCube cube;
    cube.push_back(cube_level(map, side));
    while (cube.back().side > 1) cube.push_back(halved(cube.back()));
    return cube;
}

glm::vec3 radiance_from(const CubeLevel& level, const glm::vec3& direction_map) {
    const FacePoint point = face_point(direction_map);
    const float half_side = 0.5f * static_cast<float>(level.side);
    // In bordered texels: the middle of texel 0 is at 1.
    const float x = point.s * half_side + half_side + 0.5f;
    const float y = point.t * half_side + half_side + 0.5f;
    const int x0 = std::min(int(x), level.side);
    const int y0 = std::min(int(y), level.side);
    const float fx = x - static_cast<float>(x0);
    const float fy = y - static_cast<float>(y0);
    const glm::vec4* top = level.texels.data() + level.index(point.face, x0 - 1, y0 - 1);
    const glm::vec4* bottom = top + level.stride();
    return glm::vec3(
        glm::mix(glm::mix(top[0], top[1], fx), glm::mix(bottom[0], bottom[1], fx), fy));
}

}  // namespace patina::render
