// SPDX-License-Identifier: MIT
#include "editor/gltf_errors.h"

#include "support/gltf_validator.h"

namespace patina::editor_tests {

ErrorCodes errors_in_gltf(const std::filesystem::path& file) {
    if (!tests::has_gltf_validator()) return std::nullopt;
    std::map<std::string, int> codes;
    const tests::GltfErrors errors = tests::gltf_errors_in({file});
    for (const std::string& error : errors.at(file)) ++codes[tests::gltf_error_code(error)];
    return codes;
}

}  // namespace patina::editor_tests
