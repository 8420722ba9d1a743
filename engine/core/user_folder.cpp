// SPDX-License-Identifier: MIT
#include "core/user_folder.h"

#include <cstdlib>

namespace patina {

namespace fs = std::filesystem;

fs::path user_folder(const char* variable, const char* below_home) {
    const char* folder = std::getenv(variable);
    if (folder != nullptr && fs::path(folder).is_absolute()) return fs::path(folder) / "patina";
    const char* home = std::getenv("HOME");
    if (home == nullptr || !fs::path(home).is_absolute()) return {};
    return fs::path(home) / below_home / "patina";
}

}  // namespace patina
