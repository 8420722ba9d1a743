// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace patina {

/// Patina's own folder of one kind, as the XDG Base Directory Specification has it:
/// `$variable/patina`, else `~/below_home/patina`. Empty where neither is an absolute path; nothing
/// is made.
std::filesystem::path user_folder(const char* variable, const char* below_home);

}  // namespace patina
