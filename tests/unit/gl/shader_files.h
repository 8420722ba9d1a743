// SPDX-License-Identifier: MIT
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace patina {

/// A folder of shader files for one test, gone with it. Every shader needs shared/prelude.glsl,
/// which is looked for in the source tree's shaders.
class ShaderFiles {
  public:
    ShaderFiles()
        : folder_(std::filesystem::temp_directory_path() /
                  ("patina-shaders-" + std::to_string(getpid()))) {
        std::filesystem::create_directories(folder_);
    }
    ~ShaderFiles() { std::filesystem::remove_all(folder_); }
    ShaderFiles(const ShaderFiles&) = delete;
    ShaderFiles& operator=(const ShaderFiles&) = delete;

    void write(std::string_view name, std::string_view text) const {
        const std::filesystem::path path = folder_ / name;
        std::filesystem::create_directories(path.parent_path());
        std::ofstream(path) << text;
    }
    std::vector<std::filesystem::path> folders() const {
        return {folder_, std::filesystem::path(PATINA_SOURCE_DIR) / "shaders"};
    }

  private:
    std::filesystem::path folder_;
};

inline constexpr std::string_view kFullScreenVertexShader = R"(
void main() {
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    gl_Position = vec4(corner, 0.0, 1.0);
}
)";

}  // namespace patina
