// SPDX-License-Identifier: MIT
#pragma once

/// The editor: one window over the engine. Data flows one way: a snapshot of the document and the
/// view state go to the panels, edits and commands come back, the session carries them out.
/// widgets/ draws single controls, state/ is what panels read and return, panels/ has one file per
/// panel, session/ does the work that takes time. Only this folder's window.cpp touches GLFW.

#include <filesystem>
#include <optional>

namespace patina::editor {

struct Options {
    std::optional<std::filesystem::path> file;  ///< opened at the start; unset: the empty state
    /// Kept up to date with every visible control, as JSON, for tests and scripts.
    std::optional<std::filesystem::path> ui_map;
    float scale =
        0.0f;  ///< of the interface, 1 to 2.5; 0: as it was left, or as the monitor has it
    int window_width = 0;  ///< 0: as it was left, or 1600 x 900
    int window_height = 0;
    /// How many draws the picture of the viewport is the mean of when nothing moves; 0: of one.
    /// Unset: kRefiningDraws, or one where that was switched off.
    std::optional<int> refining_draws;
};

/// Opens the window and returns when it is closed: 0, or 1 after one line on standard error when no
/// window or no OpenGL 4.1 is to be had.
int run(const Options& options);

}  // namespace patina::editor
