// SPDX-License-Identifier: MIT
#pragma once

/// Presets on disk: those that ship (the folder "presets" beside the program) and any other file.

#include <filesystem>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "document/document.h"
#include "document/preset.h"
#include "io/image_store.h"

namespace patina::io {

/// A preset and where it was read; its images lie beside that file.
struct PresetFile {
    std::filesystem::path path;
    Preset preset;
};

/// Reads one preset file. The message names it.
Result<PresetFile> read_preset(const std::filesystem::path& path);

/// Every preset that ships, in the order of their ids. Fails when there is no such folder; a file
/// that is no good preset is left out with a warning in the log.
Result<std::vector<PresetFile>> shipped_presets();

/// The preset that people name: the id of one that ships, or the path of a file (whatever contains
/// a '/' or ends in .json). An unknown id is a failure that lists the known ones.
Result<PresetFile> find_preset(std::string_view name_or_path);

/// Reads the images that a preset's layers need into `images`, in the order of Preset::images.
/// One that is missing, or whose pixels are not those that the preset states, is a failure.
Result<std::vector<ImageAssetPtr>> add_preset_images(const PresetFile& file, ImageStore& images);

}  // namespace patina::io
