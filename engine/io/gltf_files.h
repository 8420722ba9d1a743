// SPDX-License-Identifier: MIT
#pragma once

/// The bytes that a glTF file names: its buffers and encoded images, wherever they lie.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "io/gltf_model.h"
#include "scene/source_asset.h"

namespace patina::io {

struct GltfFiles {
    std::vector<std::span<const std::byte>> buffers;   ///< by index; empty where there is no data
    std::vector<std::shared_ptr<const Bytes>> images;  ///< by index; null where there is none
    /// Decoded data: URIs of buffers. The spans point into these and into the asset.
    std::vector<std::shared_ptr<const Bytes>> owned;
};

/// Reads external files into `asset.external_files` (under the folder of `asset.path`, each once)
/// and gathers all bytes, at most `limit_bytes` of them. A buffer that is missing or too short is a
/// failure, an image that is missing a warning; what leads out of the folder is a failure for both.
/// `asset` must stay where it is as long as the result is used.
/// @param buffer_bytes  byteLength by buffer: what CheckedGltf has
Result<GltfFiles> gather_files(SourceAsset& asset, const tinygltf::Model& model,
                               const std::vector<std::uint64_t>& buffer_bytes,
                               std::uint64_t limit_bytes, std::vector<std::string>& warnings);

}  // namespace patina::io
