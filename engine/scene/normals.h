// SPDX-License-Identifier: MIT
#pragma once

/// Normals that a file lacks or has got wrong.

#include "scene/mesh.h"

namespace patina {

/// Gives every triangle its own three vertices and the normal of its plane.
void make_flat_normals(Primitive& primitive);

/// Makes normals unit vectors; those of no length become the mean normal of the triangles around.
void repair_normals(Primitive& primitive);

/// Makes tangents unit vectors and w 1 or -1; those of no length are made from the normal.
void repair_tangents(Primitive& primitive);

/// A unit vector at a right angle to `normal` (unit), the same one for the same normal.
glm::vec3 any_perpendicular(const glm::vec3& normal);

}  // namespace patina
