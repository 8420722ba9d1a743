// SPDX-License-Identifier: MIT
#include "support/gltf_validator.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>

namespace patina::tests {
namespace {

namespace fs = std::filesystem;

const fs::path kSource = PATINA_SOURCE_DIR;
const fs::path kModules = kSource / "build/node/node_modules";

/// What a command prints.
std::string output_of(const std::string& command) {
    std::FILE* const pipe = ::popen(command.c_str(), "r");
    std::string out;
    std::array<char, 4096> buffer = {};
    while (const std::size_t got = std::fread(buffer.data(), 1, buffer.size(), pipe))
        out.append(buffer.data(), got);
    EXPECT_EQ(::pclose(pipe), 0) << command;
    return out;
}

}  // namespace

bool has_gltf_validator() {
    return fs::is_directory(kModules / "gltf-validator") &&
           std::system("node --version >/dev/null 2>&1") == 0;
}

GltfErrors gltf_errors_in(const std::vector<fs::path>& files) {
    // Whatever happens to it, a test ends.
    std::string command = "timeout 120 node '" + (kSource / "tests/support/validate.cjs").string() +
                          "' '" + kModules.string() + "'";
    for (const fs::path& file : files) command += " '" + file.string() + "'";
    const std::string out = output_of(command);
    const auto report = nlohmann::json::parse(out, nullptr, false);
    GltfErrors errors;
    for (const fs::path& file : files) {
        std::vector<std::string>& found = errors[file];
        if (report.is_object() && report.contains(file.string()))
            found = report[file.string()].get<std::vector<std::string>>();
        else
            ADD_FAILURE() << file << " has no report; the validator said: " << out;
    }
    return errors;
}

std::string gltf_error_code(const std::string& error) {
    return error.substr(0, error.find(' '));
}

}  // namespace patina::tests
