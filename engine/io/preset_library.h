// SPDX-License-Identifier: MIT
#pragma once

/// Presets on disk: those that ship (the folder "presets" beside the program), the user's own, and
/// any other file.

#include <filesystem>
#include <string>
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

/// Where the user's own presets lie, $XDG_DATA_HOME/patina/presets or the same below
/// ~/.local/share; empty where there is neither variable. It need not exist.
std::filesystem::path user_preset_folder();

/// Those that ship and the user's own, in the order of their ids. What is no good preset is left
/// out with a warning, and so is a user's that has the id of one that ships.
Result<std::vector<PresetFile>> all_presets();

/// The preset that people name: the id of one of these, or the path of a file (whatever contains
/// a '/' or ends in .json). An unknown id is a failure that lists the known ones.
Result<PresetFile> find_preset(std::string_view name_or_path);

/// Reads the images that a preset's layers need into `images`, in the order of Preset::images.
/// One that is missing, or whose pixels are not those that the preset states, is a failure.
Result<std::vector<ImageAssetPtr>> add_preset_images(const PresetFile& file, ImageStore& images);

/// The id of a preset that is called so: "Worn paint, red" is worn-paint-red.
std::string preset_id_of(std::string_view name);

/// Writes a preset, whose folder is made if it is missing, and beside it the images that its layers
/// read. What is not fit for a preset is a failure, and nothing is written.
/// @param preset    without its images
/// @param document  that has them
Result<PresetFile> write_preset(const std::filesystem::path& file, Preset preset,
                                const Document& document);

}  // namespace patina::io
