// SPDX-License-Identifier: MIT
#pragma once

/// The JSON of a glTF file checked whole, types, ranges, indices and extents, before tinygltf sees
/// it: tinygltf trusts most of what it reads. Nothing is kept but what later checks ask of earlier
/// ones.

#include <cstdint>
#include <string>
#include <vector>

#include "io/element_layout.h"
#include "io/json_place.h"

namespace patina::io {

struct ModelLimits {
    int nodes = 1'000'000;
    int node_depth = 1'000;
};

struct CheckedView {
    std::uint64_t bytes = 0;
    std::size_t stride = 0;  ///< 0: packed
};

struct CheckedAccessor {
    std::int64_t count = 0;
    ElementLayout layout;
};

/// What the checks of the arrays before found out; by index.
struct CheckedGltf {
    std::vector<std::uint64_t> buffer_bytes;
    std::vector<CheckedView> views;
    std::vector<CheckedAccessor> accessors;
    std::vector<std::string> warnings;  ///< harmless, and worth a word
};

/// Failure: the JSON pointer and the fault, without the file's name.
Result<CheckedGltf> check_gltf(const nlohmann::json& json, const ModelLimits& limits = {});

/// The parts of check_gltf, one for each group of arrays. All report to the place's fault.
/// asset.version, minVersion, extensionsRequired.
void check_versions(const JsonPlace& root, CheckedGltf& checked);
/// Buffers, views and accessors, with all their extents.
void check_buffers(const JsonPlace& root, CheckedGltf& checked);
void check_accessors(const JsonPlace& root, CheckedGltf& checked);
/// Images, samplers, textures and materials.
void check_textures(const JsonPlace& root, const CheckedGltf& checked);
void check_materials(const JsonPlace& root);
/// Meshes, skins and animations: the indices that they hold.
void check_meshes(const JsonPlace& root, const CheckedGltf& checked);
void check_skins(const JsonPlace& root, const CheckedGltf& checked);
void check_animations(const JsonPlace& root);
/// Cameras, lights, nodes and scenes; that the nodes are trees within the limits.
void check_cameras_and_lights(const JsonPlace& root);
void check_nodes(const JsonPlace& root, const ModelLimits& limits);

}  // namespace patina::io
