// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "gl/object.h"
#include "gl/texture.h"

namespace patina::gl {

struct ColorTarget {
    std::string label;
    Format format = Format::Rgba8;
};

struct FramebufferDescription {
    std::string label;
    glm::ivec2 size{1, 1};
    std::vector<ColorTarget> colors{};  // target i is what a shader writes at location i
    std::optional<Format> depth{};      // Depth24 or Depth32F
};

/// Textures to draw to, all of one size, owned. Row 0 is the bottom row of the picture, as OpenGL
/// has it: turn rows over when writing an image file.
class Framebuffer {
  public:
    /// Fails when the driver refuses the size or the combination of formats.
    static Result<Framebuffer> make(const FramebufferDescription& description);

    /// Makes the targets anew at another size, their content lost; nothing when it has that size.
    /// On an error the old targets are still there.
    Status resize(glm::ivec2 size);

    const FramebufferDescription& description() const { return description_; }
    glm::ivec2 size() const { return description_.size; }
    const Texture& color(std::size_t index) const { return colors_[index]; }
    /// Only where the description has a depth format.
    const Texture& depth() const { return *depth_; }
    /// Memory of all targets.
    std::uint64_t bytes() const;

    /// Reads a rectangle of a colour target, four floats per texel, bottom row first; what a
    /// target lacks reads as 0, alpha as 1. Waits for the GPU.
    std::vector<float> read_color(std::size_t index, glm::ivec2 offset, glm::ivec2 size) const;

    /// For engine/gl alone.
    std::uint32_t name() const { return object_.name(); }

  private:
    FramebufferDescription description_;
    std::vector<Texture> colors_;
    std::optional<Texture> depth_;
    Object object_;
};

/// Copies a rectangle of depth, whose lower left corners are given, to a framebuffer of the same
/// depth format.
void copy_depth(const Framebuffer& from, glm::ivec2 from_offset, const Framebuffer& to,
                glm::ivec2 to_offset, glm::ivec2 size);

/// Copies the first colour target to that of a framebuffer of the same size and format.
void copy_color(const Framebuffer& from, const Framebuffer& to);

}  // namespace patina::gl
