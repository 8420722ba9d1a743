// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/fwd.hpp>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "gl/object.h"
#include "gl/shader_source.h"

namespace patina::gl {

struct ProgramDescription {
    std::string label;
    std::vector<std::filesystem::path> folders;  // where shader files are, see load_shader_source
    std::string vertex_file;                     // e.g. "passes/surface.vert"
    std::string fragment_file;
    std::vector<ShaderDefine> defines{};
    std::string geometry_file{};  // empty: none
};

/// A vertex and a fragment shader, and maybe one for geometry, linked, with the values of their
/// uniforms.
class Program {
  public:
    /// Fails with the first line of the driver's log, which names file and line.
    static Result<Program> make(const ProgramDescription& description);

    /// Sets a uniform. One that the shaders do not use is passed over, as a compiler may remove it.
    /// Array elements are named "lights[2].position"; spans fill an array from its first element.
    void set(std::string_view uniform, float value);
    void set(std::string_view uniform, int value);
    void set(std::string_view uniform, const glm::ivec2& value);
    void set(std::string_view uniform, const glm::vec2& value);
    void set(std::string_view uniform, const glm::vec3& value);
    void set(std::string_view uniform, const glm::vec4& value);
    void set(std::string_view uniform, const glm::mat3& value);
    void set(std::string_view uniform, const glm::mat4& value);
    void set(std::string_view uniform, std::span<const float> values);
    void set(std::string_view uniform, std::span<const glm::vec4> values);

    /// Lets the uniform block read the buffer that a pass binds to `slot`.
    void set_block(std::string_view block, int slot);

    /// For engine/gl alone.
    std::uint32_t name() const { return object_.name(); }

  private:
    int location(std::string_view uniform);

    Object object_;
    std::map<std::string, int, std::less<>>
        locations_;  // asked once, then remembered; -1: not used
};

}  // namespace patina::gl
