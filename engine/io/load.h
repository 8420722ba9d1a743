// SPDX-License-Identifier: MIT
#pragma once

/// glTF in. The whole text is checked before any of it is used: no file can crash or hang the
/// program, take memory beyond the limits, or reach out of its folder.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/progress.h"
#include "core/result.h"
#include "document/document.h"
#include "io/image_store.h"

namespace patina::io {

struct LoadLimits {
    std::uint64_t file_bytes = kFileLimitBytes;  ///< of the model; of all files beside it together
    std::uint64_t decoded_image_bytes = std::uint64_t{2} << 30;  ///< of all images together
    std::uint64_t geometry_bytes = std::uint64_t{2} << 30;       ///< of all meshes together
    int nodes = 1'000'000;
    int node_depth = 1'000;
    int json_depth = 64;
};

struct LoadedDocument {
    DocumentPtr document;
    std::shared_ptr<ImageStore> images;  ///< serves every image of the document
    std::vector<std::string> warnings;   ///< one line each, for people
};

/// Opens a .gltf or .glb (told apart by content). A material that Patina saved comes back with its
/// stack; any other becomes a stack whose lowest layer, "Imported textures", is its maps and
/// factors. Failure: one line that names the file, the JSON pointer, the fault and the remedy.
Result<LoadedDocument> load_document(const std::filesystem::path& path,
                                     const LoadLimits& limits = {}, const Progress& progress = {});

/// The same from memory, for a scene made by code. Nothing outside `glb` can be referenced.
Result<LoadedDocument> load_document_from_memory(Bytes glb, std::string name,
                                                 const LoadLimits& limits = {},
                                                 const Progress& progress = {});

}  // namespace patina::io
