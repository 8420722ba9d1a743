// SPDX-License-Identifier: MIT
#pragma once

/// What the editor remembers from one session to the next, in $XDG_CONFIG_HOME/patina/editor.json
/// (or ~/.config). It is convenience: what cannot be read is as if it were not there.

#include <filesystem>
#include <set>
#include <string>

#include "core/result.h"
#include "editor/state/view_state.h"

namespace patina::editor {

struct Settings {
    int window_width = 0;  ///< in pixels; 0 until it is known
    int window_height = 0;
    float scale = 0.0f;  ///< of the interface; 0 asks the monitor
    Splitters splitters;
    bool shelf_open = true;
    bool small_cards = false;          ///< in the shelf
    std::set<std::string> favourites;  ///< ids of presets
    bool keep_previous = true;         ///< SaveOptions::keep_previous
    bool refine_when_idle = true;
    bool operator==(const Settings&) const = default;
};

/// Where it is kept; empty where there is neither variable.
std::filesystem::path settings_file();
/// Standard values for all that is missing, damaged or out of range.
Settings read_settings(const std::filesystem::path& file);
Status write_settings(const std::filesystem::path& file, const Settings& settings);

}  // namespace patina::editor
