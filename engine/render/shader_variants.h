// SPDX-License-Identifier: MIT
#pragma once

/// The programs of the passes. A pass names the variant that it needs as values (the constants that
/// its text is compiled with); each is compiled when it is first used and kept. Constants and not
/// uniforms, because a software rasteriser runs both sides of a branch.

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "gl/program.h"

namespace patina::render {

struct ShaderVariant {
    std::string_view vertex_file;
    std::string_view fragment_file;
    std::vector<gl::ShaderDefine> constants;
    std::string_view geometry_file{};  ///< empty: none
};

class ShaderVariants {
  public:
    explicit ShaderVariants(std::filesystem::path folder);
    /// Valid as long as the ShaderVariants.
    Result<gl::Program*> program(const ShaderVariant& variant);

  private:
    std::filesystem::path folder_;
    std::map<std::string, gl::Program> programs_;
};

/// A constant for a shader that is the number of an enumerator, a truth value or an integer.
template <typename T>
gl::ShaderDefine shader_constant(std::string_view name, T value) {
    return {.name = std::string(name), .value = std::to_string(static_cast<int>(value))};
}

}  // namespace patina::render
