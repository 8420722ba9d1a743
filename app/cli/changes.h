// SPDX-License-Identifier: MIT
#pragma once

/// What the command line lays on a document before it is baked or drawn: folders of textures,
/// presets, layers, single values and lights, in this order.

#include <CLI/CLI.hpp>

#include "cli/input.h"
#include "document/setting.h"

namespace patina::cli {

/// `WHAT[@MATERIAL]`, as typed.
struct LayRequest {
    std::string what;
    std::string material;  ///< empty: every material
};

struct Changes {
    std::vector<LayRequest> textures;  ///< folders
    PresetRequests presets;
    std::vector<LayRequest> layers;  ///< files of JSON, or JSON itself
    std::vector<Setting> settings;
    std::vector<Light> lights;  ///< added to those of the file
};

/// `--textures`, `--preset`, `--knob`, `--layer`, `--set` and `--light`, each of which may be given
/// several times.
void add_change_options(CLI::App& app, Changes& changes);

/// Opens a file and lays the changes on.
/// @param quiet  the guesses of --textures are not printed (they go to the standard error stream)
Result<io::LoadedDocument> changed_document(const std::filesystem::path& path,
                                            const Changes& changes, bool quiet,
                                            const Progress& progress);

}  // namespace patina::cli
