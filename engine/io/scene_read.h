// SPDX-License-Identifier: MIT
#pragma once

/// The file's scene, flattened: where each mesh, camera and light stands in the world.

#include "core/progress.h"
#include "io/mesh_read.h"
#include "scene/scene.h"

namespace patina::io {

/// Reads the scene that the model shows, and every mesh in it once (once a node where skins or
/// morph weights pose it). A file without nodes shows its meshes at the origin. Failure: JSON
/// pointer and fault.
Result<Scene> read_scene(const GltfData& data, std::uint64_t geometry_bytes,
                         std::vector<std::string>& warnings, const Progress& progress);

}  // namespace patina::io
