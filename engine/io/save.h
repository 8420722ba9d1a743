// SPDX-License-Identifier: MIT
#pragma once

/// glTF out, by splicing: the text and chunks of the source as they were read, with the spans of
/// what was edited replaced. Nothing else moves by a byte.

#include <filesystem>
#include <map>
#include <optional>
#include <vector>

#include "composite/image_provider.h"
#include "core/progress.h"
#include "core/result.h"
#include "document/document.h"
#include "io/baked_files.h"

namespace patina::io {

struct SaveOptions {
    /// Overrides every edited material's resolution (`bake --size`).
    std::optional<int> size = std::nullopt;
    int png_level = PngOptions{}.level;  ///< of baked maps
    /// Keeps the file that was there as `path` with a "~" behind it (the editor: once a session).
    bool keep_previous = false;
    /// Hands back the maps that were baked.
    bool keep_maps = false;
};

struct SaveReport {
    std::filesystem::path path;
    int materials_written = 0;  ///< whose span in the JSON changed
    int maps_baked = 0;
    std::uint64_t bytes = 0;
    std::vector<std::string> warnings;       ///< one line each
    std::map<MaterialId, EncodedMaps> maps;  ///< those that were baked, if they are kept
};

/// Saves as .gltf or .glb by the extension of `path`, all or nothing. A document equal to its
/// source gives the identical file. The document stays based on the source it was opened from, so
/// an edit undone and saved is again the identical file, and ten saves are as large as one.
Result<SaveReport> save_document(const Document& document, ImageProvider& images,
                                 const std::filesystem::path& path, const SaveOptions& options = {},
                                 const Progress& progress = {});

}  // namespace patina::io
