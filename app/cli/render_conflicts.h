// SPDX-License-Identifier: MIT
#pragma once

/// What cannot be asked of `patina render` at once.

#include <string_view>

#include "cli/render_options.h"

namespace patina::cli {

/// Why what was typed on `command` cannot all be done, and what to do; empty where it can.
std::string_view conflict_in(const CLI::App& command, const RenderOptions& options);

}  // namespace patina::cli
