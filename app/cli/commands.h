// SPDX-License-Identifier: MIT
#pragma once

/// The commands of the program: one file each. What lives in this folder: words on the command line
/// turned into calls of the engine, and results turned into text or JSON. The one idea: a command
/// is parsed first (wrong usage ends there, status 2) and run afterwards (a failure is one line,
/// status 1). May include the engine; knows nothing of the editor.
///
/// Each add_* declares a subcommand with its options and help on `app`; when it was typed, parsing
/// leaves in `chosen` what is to be run.

#include <CLI/CLI.hpp>
#include <functional>

#include "core/result.h"

namespace patina::cli {

/// A command with all its arguments. It prints its own results on the standard output.
using Command = std::function<Status()>;

void add_bake(CLI::App& app, Command& chosen);
void add_render(CLI::App& app, Command& chosen);
void add_compare(CLI::App& app, Command& chosen);
void add_completion(CLI::App& app, Command& chosen);
void add_explain(CLI::App& app, Command& chosen);
void add_export(CLI::App& app, Command& chosen);
void add_info(CLI::App& app, Command& chosen);
void add_check(CLI::App& app, Command& chosen);
void add_preset(CLI::App& app, Command& chosen);
void add_sample(CLI::App& app, Command& chosen);

}  // namespace patina::cli
