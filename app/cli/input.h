// SPDX-License-Identifier: MIT
#pragma once

/// Opening what a command works on, and finding in it what the command line names.

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/progress.h"
#include "core/result.h"
#include "document/document.h"
#include "document/preset_knobs.h"
#include "io/load.h"

namespace patina::cli {

/// Opens a .gltf or .glb file; its warnings go to the log.
Result<io::LoadedDocument> opened_document(const std::filesystem::path& path,
                                           const Progress& progress);

/// The materials with that name; an empty name means all. None is a failure that lists the names.
Result<std::vector<MaterialPtr>> named_materials(const Document& document, std::string_view name);

/// `NAME[@MATERIAL]` as it was typed after --preset.
struct PresetRequest {
    std::string preset;
    std::string material;  ///< empty: every material
};

/// `[PRESET/]KNOB=VALUE` as it was typed after --knob.
struct KnobRequest {
    std::string preset;  ///< as after --preset, with or without its material; empty: every preset
    KnobSetting setting;
};

/// The presets that a command lays on, and how their knobs are turned.
struct PresetRequests {
    std::vector<PresetRequest> presets;
    std::vector<KnobRequest> knobs;
};

/// `--preset NAME[@MATERIAL]` and `--knob [PRESET/]NAME=VALUE`, which may be given several times.
void add_preset_options(CLI::App& app, PresetRequests& requests);

/// Lays each preset in turn on top of the stacks that it names. A knob is turned in every preset
/// that has it, or in the one that it names, which counts for more; one that none has is a failure.
Status apply_presets(io::LoadedDocument& loaded, const PresetRequests& requests);

}  // namespace patina::cli
