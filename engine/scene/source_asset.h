// SPDX-License-Identifier: MIT
#pragma once

/// The glTF file as it was read, kept whole so that a save can copy every byte that was not edited.

#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "core/files.h"

namespace patina {

enum class Container { Gltf, Glb };

struct SourceAsset {
    std::filesystem::path path;  ///< where it was opened; empty for a scene made by code
    Container container = Container::Glb;
    Bytes file;             ///< the whole .gltf or .glb, byte for byte
    std::string json_text;  ///< of a GLB: the JSON chunk without its padding
    Bytes binary_chunk;     ///< of a GLB: the BIN chunk with its padding; empty without one
    Bytes trailing_chunks;  ///< of a GLB: chunks of unknown type after BIN, headers included
    /// External files that the JSON names, by the URI as it is written there.
    std::map<std::string, std::shared_ptr<const Bytes>> external_files;
};

using SourceAssetPtr = std::shared_ptr<const SourceAsset>;

}  // namespace patina
