// SPDX-License-Identifier: MIT
#pragma once

/// A mesh made by code as a GLB file in memory: how the sample scene comes to be. Files that were
/// opened are never written this way, only by splicing (io/save.h).

#include <glm/glm.hpp>
#include <span>
#include <string>

#include "core/files.h"
#include "scene/mesh.h"
#include "scene/shapes.h"

namespace patina::io {

/// A glTF material without textures.
struct PlainMaterial {
    std::string name;
    glm::vec3 base_color_linear = glm::vec3(0.5f);
    float metalness = 0.0f;
    float roughness = 0.5f;
};

/// One scene with one node that shows `mesh`. Primitives refer to `materials` by source_material
/// (-1 for none; beyond the list must not be). Attributes that are empty are left out; all arrays
/// of a primitive are as long as its positions, of which there is at least one. Equal input gives
/// equal bytes.
Bytes mesh_to_glb(const Mesh& mesh, std::span<const PlainMaterial> materials);

/// A scene to look at materials on: the shader ball has a material for the ball and one for its
/// stand, every other shape has one that is named as it is.
Bytes shape_to_glb(Shape shape);

}  // namespace patina::io
