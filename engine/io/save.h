// SPDX-License-Identifier: MIT
#pragma once

/// glTF out, by splicing: the text and chunks of the source as they were read, with the spans of
/// what was edited replaced. Nothing else moves by a byte.

#include <filesystem>
#include <optional>
#include <vector>

#include "composite/image_provider.h"
#include "core/progress.h"
#include "core/result.h"
#include "document/document.h"

namespace patina::io {

struct SaveOptions {
    /// Overrides every edited material's resolution (`bake --size`).
    std::optional<int> size = std::nullopt;
    /// Keeps the file that was there as `path` with a "~" behind it (the editor: once a session).
    bool keep_previous = false;
};

struct SaveReport {
    std::filesystem::path path;
    int materials_written = 0;  ///< whose span in the JSON changed
    int maps_baked = 0;
    std::uint64_t bytes = 0;
    std::vector<std::string> warnings;  ///< one line each
};

/// Saves as .gltf or .glb by the extension of `path`, all or nothing. A document equal to its
/// source gives the identical file. The document stays based on the source it was opened from, so
/// an edit undone and saved is again the identical file, and ten saves are as large as one.
Result<SaveReport> save_document(const Document& document, ImageProvider& images,
                                 const std::filesystem::path& path, const SaveOptions& options = {},
                                 const Progress& progress = {});

}  // namespace patina::io
