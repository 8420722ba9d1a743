// SPDX-License-Identifier: MIT
#pragma once

/// What belongs to the program and lies in files, installed or in a build: found from wherever the
/// executable is.

#include <filesystem>
#include <string_view>

#include "core/result.h"

namespace patina {

/// Where the program's own files of one kind lie: "shaders", "presets" or "fonts". Looked for
/// beside the program (../share/patina/NAME from the executable), then in the source tree above the
/// executable. Never an absolute path from the time of the build.
Result<std::filesystem::path> resource_folder(std::string_view name);

/// A module that the program loads when it is needed: in ../lib/patina from an installed program,
/// else in the engine folder of the build that the program lies in.
Result<std::filesystem::path> module_file(std::string_view name);

}  // namespace patina
