// SPDX-License-Identifier: MIT
#include "gl/program.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace patina::gl {
namespace {

/// A shader object, which need not outlive the linking of its program.
class Shader {
  public:
    explicit Shader(GLenum stage) : name_(glCreateShader(stage)) {}
    ~Shader() { glDeleteShader(name_); }
    Shader(const Shader&) = delete;
    Shader& operator=(const Shader&) = delete;
    GLuint name() const { return name_; }

  private:
    GLuint name_;
};

std::string shader_log(GLuint shader) {
    GLint length = 0;
    glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    glGetShaderInfoLog(shader, length, &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    return log;
}

std::string program_log(GLuint program) {
    GLint length = 0;
    glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    glGetProgramInfoLog(program, length, &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    return log;
}

std::string_view first_line(std::string_view text) {
    return text.substr(0, text.find('\n'));
}

Status compile(const Shader& shader, const ProgramDescription& description, std::string_view file) {
    const Result<ShaderSource> source =
        load_shader_source(description.folders, file, description.defines);
    if (!source) return passed_on(source);
    const GLchar* text = source->text.c_str();
    glShaderSource(shader.name(), 1, &text, nullptr);
    glCompileShader(shader.name());
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_TRUE) return {};
    const std::string log = log_with_file_names(shader_log(shader.name()), *source);
    return failure("shader {} does not compile: {}", file, first_line(log));
}

}  // namespace

Result<Program> Program::make(const ProgramDescription& description) {
    const Shader vertex(GL_VERTEX_SHADER);
    const Shader fragment(GL_FRAGMENT_SHADER);
    const Shader geometry(GL_GEOMETRY_SHADER);
    const bool has_geometry = !description.geometry_file.empty();
    if (Status done = compile(vertex, description, description.vertex_file); !done)
        return passed_on(done);
    if (Status done = compile(fragment, description, description.fragment_file); !done)
        return passed_on(done);
    if (has_geometry)
        if (Status done = compile(geometry, description, description.geometry_file); !done)
            return passed_on(done);

    Program program;
    program.object_ = Object(ObjectKind::Program, glCreateProgram(), description.label);
    glAttachShader(program.name(), vertex.name());
    glAttachShader(program.name(), fragment.name());
    if (has_geometry) glAttachShader(program.name(), geometry.name());
    glLinkProgram(program.name());
    if (has_geometry) glDetachShader(program.name(), geometry.name());
    glDetachShader(program.name(), vertex.name());
    glDetachShader(program.name(), fragment.name());
    GLint linked = GL_FALSE;
    glGetProgramiv(program.name(), GL_LINK_STATUS, &linked);
    if (linked != GL_TRUE)
        return failure("shaders {} and {} do not link: {}", description.vertex_file,
                       description.fragment_file, first_line(program_log(program.name())));
    return program;
}

int Program::location(std::string_view uniform) {
    if (const auto known = locations_.find(uniform); known != locations_.end())
        return known->second;
    std::string text(uniform);
    const int found = glGetUniformLocation(name(), text.c_str());
    return locations_.emplace(std::move(text), found).first->second;
}

void Program::set(std::string_view uniform, float value) {
    glProgramUniform1f(name(), location(uniform), value);
}
void Program::set(std::string_view uniform, int value) {
    glProgramUniform1i(name(), location(uniform), value);
}
void Program::set(std::string_view uniform, const glm::ivec2& value) {
    glProgramUniform2i(name(), location(uniform), value.x, value.y);
}
void Program::set(std::string_view uniform, const glm::vec2& value) {
    glProgramUniform2fv(name(), location(uniform), 1, glm::value_ptr(value));
}
void Program::set(std::string_view uniform, const glm::vec3& value) {
    glProgramUniform3fv(name(), location(uniform), 1, glm::value_ptr(value));
}
void Program::set(std::string_view uniform, const glm::vec4& value) {
    glProgramUniform4fv(name(), location(uniform), 1, glm::value_ptr(value));
}
void Program::set(std::string_view uniform, const glm::mat3& value) {
    glProgramUniformMatrix3fv(name(), location(uniform), 1, GL_FALSE, glm::value_ptr(value));
}
void Program::set(std::string_view uniform, const glm::mat4& value) {
    glProgramUniformMatrix4fv(name(), location(uniform), 1, GL_FALSE, glm::value_ptr(value));
}
void Program::set(std::string_view uniform, std::span<const float> values) {
    glProgramUniform1fv(name(), location(uniform), static_cast<GLsizei>(values.size()),
                        values.data());
}
void Program::set(std::string_view uniform, std::span<const glm::vec4> values) {
    if (values.empty()) return;
    glProgramUniform4fv(name(), location(uniform), static_cast<GLsizei>(values.size()),
                        glm::value_ptr(values.front()));
}

void Program::set_block(std::string_view block, int slot) {
    const GLuint index = glGetUniformBlockIndex(name(), std::string(block).c_str());
    if (index != GL_INVALID_INDEX) glUniformBlockBinding(name(), index, static_cast<GLuint>(slot));
}

}  // namespace patina::gl
