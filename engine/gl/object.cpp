// SPDX-License-Identifier: MIT
#include "gl/object.h"

#include <epoxy/gl.h>

#include <algorithm>

#include "gl/debug.h"

namespace patina::gl {
namespace {

constexpr std::size_t kLongestLabel = 255;

GLenum identifier(ObjectKind kind) {
    switch (kind) {
        case ObjectKind::Buffer:
            return GL_BUFFER;
        case ObjectKind::Framebuffer:
            return GL_FRAMEBUFFER;
        case ObjectKind::Program:
            return GL_PROGRAM;
        case ObjectKind::Query:
            return GL_QUERY;
        case ObjectKind::Sampler:
            return GL_SAMPLER;
        case ObjectKind::Texture:
            return GL_TEXTURE;
        case ObjectKind::VertexArray:
            return GL_VERTEX_ARRAY;
    }
    return GL_NONE;
}

void destroy(ObjectKind kind, GLuint name) {
    switch (kind) {
        case ObjectKind::Buffer:
            return glDeleteBuffers(1, &name);
        case ObjectKind::Framebuffer:
            return glDeleteFramebuffers(1, &name);
        case ObjectKind::Program:
            return glDeleteProgram(name);
        case ObjectKind::Query:
            return glDeleteQueries(1, &name);
        case ObjectKind::Sampler:
            return glDeleteSamplers(1, &name);
        case ObjectKind::Texture:
            return glDeleteTextures(1, &name);
        case ObjectKind::VertexArray:
            return glDeleteVertexArrays(1, &name);
    }
}

}  // namespace

Object::Object(ObjectKind kind, std::uint32_t name, std::string_view label)
    : kind_(kind), name_(name) {
    if (has_debug_output())
        // Drivers take at least so much (GL_MAX_LABEL_LENGTH); the constants of a shader's variant
        // can be longer.
        glObjectLabel(identifier(kind), name,
                      static_cast<GLsizei>(std::min(label.size(), kLongestLabel)), label.data());
}

Object::~Object() {
    if (name_ != 0) destroy(kind_, name_);
}

}  // namespace patina::gl
