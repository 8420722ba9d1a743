// SPDX-License-Identifier: MIT
#pragma once

/// Where the fonts of the interface lie.

#include <filesystem>
#include <initializer_list>
#include <string_view>

#include "core/result.h"

namespace patina {

/// The first file that has one of these names, in their order: beside the program where it is
/// installed whole, else where Debian's packages put fonts.
Result<std::filesystem::path> font_file(std::initializer_list<std::string_view> names);

}  // namespace patina
