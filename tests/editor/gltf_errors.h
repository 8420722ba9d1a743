// SPDX-License-Identifier: MIT
#pragma once

/// What the Khronos validator finds in a file.

#include <gmock/gmock.h>

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace patina::editor_tests {

/// How often each error code occurs; nothing where there is no validator (./test installs it).
using ErrorCodes = std::optional<std::map<std::string, int>>;
ErrorCodes errors_in_gltf(const std::filesystem::path& file);

/// No error code occurs more often than in `before`.
MATCHER_P(IsNotWorseThan, before, "has no error that was not there before") {
    if (!arg || !before) return !arg == !before;
    for (const auto& [code, count] : *arg) {
        const auto known = before->find(code);
        const int allowed = known == before->end() ? 0 : known->second;
        if (count <= allowed) continue;
        *result_listener << code << " occurs " << count << " times instead of " << allowed;
        return false;
    }
    return true;
}

}  // namespace patina::editor_tests
