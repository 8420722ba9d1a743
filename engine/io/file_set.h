// SPDX-License-Identifier: MIT
#pragma once

/// Several files written as one: the last one commits.

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/files.h"

namespace patina::io {

struct SideFile {
    std::filesystem::path path;
    std::shared_ptr<const Bytes> bytes;
};

/// Writes and flushes the side files, making folders where they are missing, then renames the main
/// file into place. A side file that is there with the same content is left alone. On failure the
/// main file is as it was and side files that were not there before are gone again.
Status write_files(const std::vector<SideFile>& side_files, const std::filesystem::path& main,
                   std::span<const std::span<const std::byte>> pieces);

/// Keeps the file at `path`, if there is one, under its name with a "~" behind it, in the place of
/// what had that name. Without copying, where the file system can give a file two names.
Status keep_previous_version(const std::filesystem::path& path);

/// Names of the external image files that the .gltf at `path` lists as Patina's own; none where
/// there is no such file. Only names with the hash of their content in them count.
std::vector<std::string> owned_files_of(const std::filesystem::path& path);

/// Deletes from the folder of `gltf` those of `candidates` that no .gltf there, nor a
/// previous version that was kept, names any more.
void remove_superseded(const std::filesystem::path& gltf,
                       const std::vector<std::string>& candidates);

}  // namespace patina::io
