// SPDX-License-Identifier: MIT
#include "scene/uv_density.h"

#include <cmath>

#include "scene/uv_triangle.h"

namespace patina {

UvAreas& UvAreas::operator+=(const UvAreas& other) {
    of_surface += other.of_surface;
    of_texture += other.of_texture;
    has_uvs = has_uvs || other.has_uvs;
    return *this;
}

float UvAreas::length_per_uv(float otherwise) const {
    if (!(of_surface > 0.0 && of_texture > 0.0)) return otherwise;
    return static_cast<float>(std::sqrt(of_surface / of_texture));
}

UvAreas uv_areas(const Primitive& primitive, const glm::mat4& space_from_local, int uv_set) {
    UvAreas areas;
    const auto& uvs = primitive.uvs[static_cast<std::size_t>(uv_set)];
    if (uvs.empty()) return areas;
    const glm::dmat3 turn{glm::mat3(space_from_local)};
    for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
        const std::uint32_t* const corner = primitive.indices.data() + i;
        if (!has_texels({uvs[corner[0]], uvs[corner[1]], uvs[corner[2]]})) continue;
        areas.has_uvs = true;
        const auto side = [&](std::size_t k) {
            return turn * (glm::dvec3(primitive.positions[corner[k]]) -
                           glm::dvec3(primitive.positions[corner[0]]));
        };
        areas.of_surface += glm::length(glm::cross(side(1), side(2)));
        const glm::dvec2 a = glm::dvec2(uvs[corner[1]]) - glm::dvec2(uvs[corner[0]]);
        const glm::dvec2 b = glm::dvec2(uvs[corner[2]]) - glm::dvec2(uvs[corner[0]]);
        areas.of_texture += std::abs(a.x * b.y - a.y * b.x);
    }
    return areas;
}

}  // namespace patina
