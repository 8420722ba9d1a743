// SPDX-License-Identifier: MIT
#include "editor/gltf_errors.h"

#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace patina::editor_tests {

namespace fs = std::filesystem;

ErrorCodes errors_in_gltf(const fs::path& file) {
    const fs::path source = PATINA_SOURCE_DIR;
    const fs::path modules = source / "build/node/node_modules";
    if (!fs::is_directory(modules / "gltf-validator")) return std::nullopt;
    const std::string command = "node '" + (source / "tests/cli/validate.cjs").string() + "' '" +
                                modules.string() + "' '" + file.string() + "'";
    std::FILE* const pipe = ::popen(command.c_str(), "r");
    std::string out;
    std::array<char, 4096> buffer = {};
    while (const std::size_t got = std::fread(buffer.data(), 1, buffer.size(), pipe))
        out.append(buffer.data(), got);
    EXPECT_EQ(::pclose(pipe), 0) << command;
    std::map<std::string, int> codes;
    const auto report = nlohmann::json::parse(out, nullptr, false);
    if (!report.is_object()) return codes = {{"the validator said: " + out, 1}};
    for (const auto& error : report.at(file.string())) {
        // "CODE /json/pointer"
        const auto text = error.get<std::string>();
        ++codes[text.substr(0, text.find(' '))];
    }
    return codes;
}

}  // namespace patina::editor_tests
