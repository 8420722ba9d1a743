// SPDX-License-Identifier: MIT
#pragma once

/// The parts of read_gltf_model, one for each group of arrays. All report to the place's fault.

#include "io/gltf_model.h"
#include "io/json_place.h"

namespace patina::io::gltf {

/// asset.version, minVersion, extensionsRequired. Unsupported but harmless extensions are warnings.
void check_versions(const JsonPlace& root, Model& model);
/// Buffers, views and accessors, with all their extents.
void read_buffers(const JsonPlace& root, Model& model);
void read_accessors(const JsonPlace& root, Model& model);
/// Meshes, skins and animations: the indices that they hold.
void read_meshes(const JsonPlace& root, Model& model);
void read_skins(const JsonPlace& root, Model& model);
void check_animations(const JsonPlace& root);
/// Images, samplers, textures, materials and variants.
void read_textures(const JsonPlace& root, Model& model);
void read_materials(const JsonPlace& root, Model& model);
/// Cameras, lights, nodes and scenes; that the nodes are trees within the limits.
void read_cameras_and_lights(const JsonPlace& root, Model& model);
void read_nodes(const JsonPlace& root, Model& model, const ModelLimits& limits);

}  // namespace patina::io::gltf
