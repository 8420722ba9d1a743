// SPDX-License-Identifier: MIT
#pragma once

/// The Khronos glTF validator, for the tests that write models.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace patina::tests {

/// Whether ./test has installed it into build/node, and there is a Node.js to run it.
bool has_gltf_validator();

/// The errors that it finds in each file: a code and a JSON pointer each. A run that fails is a
/// failure of the test.
using GltfErrors = std::map<std::filesystem::path, std::vector<std::string>>;
GltfErrors gltf_errors_in(const std::vector<std::filesystem::path>& files);

/// "CODE /json/pointer" without the pointer.
std::string gltf_error_code(const std::string& error);

}  // namespace patina::tests
