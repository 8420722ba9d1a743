// SPDX-License-Identifier: MIT
#include "io/safe_name.h"

namespace patina::io {

std::string safe_file_name(std::string_view name, std::size_t limit_bytes) {
    std::string safe;
    for (const char c : name.substr(0, limit_bytes)) {
        const bool letter = (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
        const bool kept = letter || (c >= '0' && c <= '9') || c == '.' || c == '_' || c == '-';
        safe += kept ? c : '_';
    }
    if (safe.empty()) return "unnamed";
    if (safe.front() == '.') safe.front() = '_';
    return safe;
}

}  // namespace patina::io
