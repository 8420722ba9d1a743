// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/result.h"
#include "gl/format.h"
#include "gl/object.h"

namespace patina::gl {

enum class TextureShape { Flat, Cube };

struct TextureDescription {
    std::string label;
    glm::ivec2 size{1, 1};  // in texels; a cube's faces are square
    Format format = Format::Rgba8;
    TextureShape shape = TextureShape::Flat;
    int levels = 1;  // mip levels, at most full_level_count(size)
};

/// Levels from `size` down to 1 x 1.
int full_level_count(glm::ivec2 size);

/// A rectangle of texels of one level (and of one face of a cube: +X -X +Y -Y +Z -Z).
/// `row_texels` is how far apart the rows of the source lie, in texels; 0 means without gaps.
struct TextureRegion {
    glm::ivec2 offset{0, 0};
    glm::ivec2 size{0, 0};
    int level = 0;
    int face = 0;
    int row_texels = 0;
};

/// Texels on the GPU, of undefined content when made. Row 0 is the first row uploaded; texture
/// coordinate v = 0 lies at its edge, as in glTF when images are uploaded from their top row.
/// Without a Sampler it is read clamped to its edges, with levels by trilinear filtering, with one
/// level the nearest texel.
class Texture {
  public:
    /// Fails when the driver refuses the size.
    static Result<Texture> make(const TextureDescription& description);

    /// Replaces a region. `texels` holds channels(format) values per texel, row after row: bytes
    /// for 8-bit formats (taken as they are, encoded for sRGB), floats for any format, half floats'
    /// bits for the floating formats. Rows may have any alignment.
    void upload(const TextureRegion& region, std::span<const std::uint8_t> texels);
    void upload(const TextureRegion& region, std::span<const float> texels);
    void upload_halves(const TextureRegion& region, std::span<const std::uint16_t> texels);

    /// Makes levels 1 and up from level 0 by the driver's box filter.
    void generate_mip_levels();

    /// Reads a level back, channels(format) values per texel, row after row. Waits for the GPU.
    std::vector<float> read_floats(int level = 0, int face = 0) const;
    std::vector<std::uint8_t> read_bytes(int level = 0, int face = 0) const;

    const TextureDescription& description() const { return description_; }
    glm::ivec2 size(int level = 0) const;
    /// Memory of all levels and faces.
    std::uint64_t bytes() const;

    /// For engine/gl alone.
    std::uint32_t name() const { return object_.name(); }
    std::uint32_t target() const;

  private:
    void upload_values(const TextureRegion& region, std::uint32_t type, const void* texels);
    void read_values(int level, int face, std::uint32_t type, void* texels) const;
    std::size_t value_count(int level) const;

    TextureDescription description_;
    Object object_;
};

}  // namespace patina::gl
