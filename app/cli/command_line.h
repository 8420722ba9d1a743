// SPDX-License-Identifier: MIT
#pragma once

/// What was typed: a command.

#include <filesystem>
#include <functional>
#include <optional>
#include <variant>

#include "core/result.h"

namespace patina::cli {

/// Nothing is left to do: help was printed (0) or the usage was wrong (2).
struct ExitStatus {
    int value = 0;
};

/// No command: the editor is to be opened.
struct EditorRequest {
    std::optional<std::filesystem::path> file;
    std::optional<std::filesystem::path> ui_map;
    float scale = 0.0f;    ///< 1 to 2.5; 0: as it was left, or as the monitor has it
    int window_width = 0;  ///< 0: as the window was left
    int window_height = 0;
    std::optional<int> refining_draws;  ///< 0: none; unset: as it was left
};

using Invocation = std::variant<std::function<Status()>, EditorRequest, ExitStatus>;

/// Reads the command line. Help goes to the standard output, wrong usage to the standard error
/// stream as one line.
Invocation parse(int argc, char** argv);

/// Runs a command: 0, or 1 after its one line on the standard error stream.
int run(const std::function<Status()>& command);

}  // namespace patina::cli
