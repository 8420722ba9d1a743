// SPDX-License-Identifier: MIT
#include "gl/object.h"

#include <epoxy/gl.h>

#include "gl/debug.h"

namespace patina::gl {
namespace {

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
        glObjectLabel(identifier(kind), name, static_cast<GLsizei>(label.size()), label.data());
}

Object::~Object() {
    if (name_ != 0) destroy(kind_, name_);
}

}  // namespace patina::gl
