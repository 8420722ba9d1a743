// SPDX-License-Identifier: MIT
#pragma once

/// Meshes of the file as triangles ready to draw: morphed, skinned, with normals and tangents.

#include <span>
#include <string>
#include <vector>

#include "io/accessor_read.h"
#include "scene/mesh.h"

namespace patina::io {

/// Memory that all meshes together may take; what would go beyond is refused before it is read.
class GeometryBudget {
  public:
    explicit GeometryBudget(std::uint64_t bytes) : left_(bytes), limit_(bytes) {}
    Status take(std::uint64_t bytes);

  private:
    std::uint64_t left_;
    std::uint64_t limit_;
};

/// How the vertices of a mesh are moved, at rest.
struct MeshPose {
    std::span<const float> morph_weights;     ///< missing ones are 0
    std::span<const glm::mat4> joints_world;  ///< world from bind space; empty: not skinned
};

/// The mesh with that index. Points, lines and primitives without positions are left out with a
/// warning. Failure: JSON pointer and fault.
Result<Mesh> read_mesh(const GltfData& data, int mesh, const MeshPose& pose, GeometryBudget& budget,
                       std::vector<std::string>& warnings);

}  // namespace patina::io
