// SPDX-License-Identifier: MIT
#pragma once

/// How large a texture lies on a surface.

#include <glm/glm.hpp>

#include "scene/mesh.h"

namespace patina {

/// The areas of all triangles that have UVs, twice each: on the surface, and in the texture in UV
/// units.
struct UvAreas {
    double of_surface = 0.0;
    double of_texture = 0.0;
    bool has_uvs = false;  ///< whether there is such a triangle

    UvAreas& operator+=(const UvAreas& other);
    /// The length on the surface of what is 1 long in the texture, in the mean; `otherwise` where
    /// either area is 0.
    float length_per_uv(float otherwise) const;
};

/// Of a primitive in the space that `space_from_local` takes it to.
UvAreas uv_areas(const Primitive& primitive, const glm::mat4& space_from_local, int uv_set);

}  // namespace patina
