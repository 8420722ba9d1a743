// SPDX-License-Identifier: MIT
#include "gl/debug.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <utility>

namespace patina::gl {
namespace {

void APIENTRY on_message(GLenum source, GLenum type, GLuint /*id*/, GLenum severity, GLsizei length,
                         const GLchar* text, const void* callback) {
    // What a compiler says is the error of Program::make.
    if (source == GL_DEBUG_SOURCE_SHADER_COMPILER) return;
    if (type != GL_DEBUG_TYPE_ERROR && severity != GL_DEBUG_SEVERITY_HIGH) return;
    const std::size_t size =
        length >= 0 ? static_cast<std::size_t>(length) : std::char_traits<char>::length(text);
    (*static_cast<const ErrorCallback*>(callback))(std::string_view(text, size));
}

std::string_view text_of(GLenum name) {
    const GLubyte* text = glGetString(name);
    return text != nullptr ? reinterpret_cast<const char*>(text) : "unknown";
}

}  // namespace

bool has_debug_output() {
    return epoxy_gl_version() >= 43 || epoxy_has_gl_extension("GL_KHR_debug");
}

DebugOutput::DebugOutput(ErrorCallback on_error) : on_error_(std::move(on_error)) {
    if (!has_debug_output()) return;
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(on_message, &on_error_);
}

DebugOutput::~DebugOutput() {
    if (has_debug_output()) glDebugMessageCallback(nullptr, nullptr);
}

void DebugOutput::poll() const {
    // The callback has reported these already where there is one; here they are only cleared.
    const bool reported = has_debug_output();
    for (GLenum error = glGetError(); error != GL_NO_ERROR; error = glGetError())
        if (!reported) on_error_(fmt::format("OpenGL error 0x{:04x}", error));
}

DebugGroup::DebugGroup(std::string_view label) {
    if (has_debug_output())
        glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, static_cast<GLsizei>(label.size()),
                         label.data());
}

DebugGroup::~DebugGroup() {
    if (has_debug_output()) glPopDebugGroup();
}

std::string renderer_description() {
    return fmt::format("{}, {}, {}", text_of(GL_VENDOR), text_of(GL_RENDERER), text_of(GL_VERSION));
}

}  // namespace patina::gl
