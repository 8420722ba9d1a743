// SPDX-License-Identifier: MIT
#pragma once

/// Tangents where a file has none, equal to those that MikkTSpace (Morten S. Mikkelsen, "Simulation
/// of Wrinkled Surfaces Revisited", 2008) makes and that normal maps are baked against.

#include "scene/mesh.h"

namespace patina {

/// Fills `tangents` in glTF's convention: w is such that w * cross(n, t) points up in the texture,
/// against v. Corners of a vertex that belong to differently turned or mirrored charts need
/// different tangents: the vertex is then split, and copies are appended to every attribute.
/// Corners of triangles whose UVs enclose no area take the tangent of a neighbour, else any.
/// Needs unit normals and uvs[uv_set]. The result does not depend on threads.
void generate_tangents(Primitive& primitive, int uv_set);

}  // namespace patina
