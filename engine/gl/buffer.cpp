// SPDX-License-Identifier: MIT
#include "gl/buffer.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <cassert>

namespace patina::gl {
namespace {

GLenum bind_target(BufferKind kind) {
    switch (kind) {
        case BufferKind::Vertices:
            return GL_ARRAY_BUFFER;
        case BufferKind::Indices:
            return GL_ELEMENT_ARRAY_BUFFER;
        case BufferKind::Uniforms:
            return GL_UNIFORM_BUFFER;
    }
    return GL_ARRAY_BUFFER;
}

void enable(const VertexAttribute& attribute, std::size_t stride_bytes) {
    const auto location = static_cast<GLuint>(attribute.location);
    // NOLINTNEXTLINE(performance-no-int-to-ptr): OpenGL takes offsets as pointers
    const auto* offset = reinterpret_cast<const void*>(attribute.offset_bytes);
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, attribute.components, GL_FLOAT, GL_FALSE,
                          static_cast<GLsizei>(stride_bytes), offset);
}

}  // namespace

Buffer Buffer::make(const BufferDescription& description) {
    Buffer buffer;
    buffer.kind_ = description.kind;
    buffer.use_ = description.use;
    GLuint name = 0;
    glGenBuffers(1, &name);
    glBindBuffer(bind_target(description.kind), name);
    buffer.object_ = Object(ObjectKind::Buffer, name, description.label);
    buffer.write(description.content);
    return buffer;
}

void Buffer::write(std::span<const std::byte> content) {
    bytes_ = content.size();
    glBindBuffer(bind_target(kind_), name());
    glBufferData(bind_target(kind_), static_cast<GLsizeiptr>(content.size()), content.data(),
                 use_ == BufferUse::Static ? GL_STATIC_DRAW : GL_DYNAMIC_DRAW);
}

VertexArray VertexArray::make(const VertexArrayDescription& description) {
    assert(description.vertices.empty() || description.stride_bytes > 0);
    GLuint name = 0;
    glGenVertexArrays(1, &name);
    glBindVertexArray(name);
    VertexArray array;
    array.object_ = Object(ObjectKind::VertexArray, name, description.label);
    if (!description.vertices.empty()) {
        array.vertices_ = Buffer::make({.label = fmt::format("{}.vertices", description.label),
                                        .kind = BufferKind::Vertices,
                                        .content = description.vertices});
        for (const VertexAttribute& attribute : description.attributes)
            enable(attribute, description.stride_bytes);
        array.count_ = static_cast<int>(description.vertices.size() / description.stride_bytes);
    }
    if (!description.indices.empty()) {
        array.indices_ = Buffer::make({.label = fmt::format("{}.indices", description.label),
                                       .kind = BufferKind::Indices,
                                       .content = std::as_bytes(description.indices)});
        array.count_ = static_cast<int>(description.indices.size());
    }
    glBindVertexArray(0);
    return array;
}

void VertexArray::reorder(std::span<const std::uint32_t> indices) {
    assert(indices_ && static_cast<int>(indices.size()) == count_);
    glBindVertexArray(name());
    indices_->write(std::as_bytes(indices));
    glBindVertexArray(0);
}

std::uint64_t VertexArray::bytes() const {
    return (vertices_ ? vertices_->bytes() : 0) + (indices_ ? indices_->bytes() : 0);
}

}  // namespace patina::gl
