// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gl/object.h"

namespace patina::gl {

enum class BufferKind { Vertices, Indices, Uniforms };
enum class BufferUse { Static, Dynamic };  // written once, or again and again

struct BufferDescription {
    std::string label;
    BufferKind kind = BufferKind::Vertices;
    BufferUse use = BufferUse::Static;
    std::span<const std::byte> content{};  // what it holds from the start; read by make() only
};

/// Bytes on the GPU.
class Buffer {
  public:
    static Buffer make(const BufferDescription& description);

    /// Replaces the whole content, which may have another size.
    void write(std::span<const std::byte> content);

    std::uint64_t bytes() const { return bytes_; }
    /// For engine/gl alone.
    std::uint32_t name() const { return object_.name(); }

  private:
    BufferKind kind_ = BufferKind::Vertices;
    BufferUse use_ = BufferUse::Static;
    std::uint64_t bytes_ = 0;
    Object object_;
};

/// One input of a vertex shader: floats, read from interleaved vertices.
struct VertexAttribute {
    int location = 0;              // layout(location = ...) in the shader
    int components = 3;            // 1 to 4
    std::size_t offset_bytes = 0;  // from the start of a vertex
};

struct VertexArrayDescription {
    std::string label;
    std::span<const std::byte> vertices{};  // interleaved; read by make() only
    std::size_t stride_bytes = 0;           // from one vertex to the next
    std::vector<VertexAttribute> attributes{};
    std::span<const std::uint32_t> indices{};  // empty: vertices are drawn in their order
};

/// Vertices, and indices where there are any, with what says how they are read. Without vertices it
/// serves passes whose vertex shader makes positions from gl_VertexID (a full-screen triangle).
class VertexArray {
  public:
    static VertexArray make(const VertexArrayDescription& description);

    /// Replaces the indices by as many others: the same triangles in another order.
    void reorder(std::span<const std::uint32_t> indices);

    /// How many indices, or vertices where there are none, a draw of everything takes.
    int count() const { return count_; }
    bool indexed() const { return indices_.has_value(); }
    std::uint64_t bytes() const;
    /// For engine/gl alone.
    std::uint32_t name() const { return object_.name(); }

  private:
    int count_ = 0;
    std::optional<Buffer> vertices_;
    std::optional<Buffer> indices_;
    Object object_;
};

}  // namespace patina::gl
