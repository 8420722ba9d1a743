// SPDX-License-Identifier: MIT
#include "gl/texture.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <bit>
#include <cassert>

namespace patina::gl {
namespace {

constexpr int kCubeFaces = 6;

int face_count(TextureShape shape) {
    return shape == TextureShape::Cube ? kCubeFaces : 1;
}

GLenum bind_target(TextureShape shape) {
    return shape == TextureShape::Cube ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D;
}

GLenum image_target(TextureShape shape, int face) {
    return shape == TextureShape::Cube ? GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(face)
                                       : GL_TEXTURE_2D;
}

GLint largest_size(TextureShape shape) {
    GLint largest = 0;
    glGetIntegerv(shape == TextureShape::Cube ? GL_MAX_CUBE_MAP_TEXTURE_SIZE : GL_MAX_TEXTURE_SIZE,
                  &largest);
    return largest;
}

glm::ivec2 level_size(glm::ivec2 size, int level) {
    return {std::max(size.x >> level, 1), std::max(size.y >> level, 1)};
}

/// A texture without all its levels cannot be sampled with mip-maps unless it says where they end.
/// Filters are those of a texture that is read without a Sampler.
void set_parameters(GLenum target, int levels) {
    glTexParameteri(target, GL_TEXTURE_BASE_LEVEL, 0);
    glTexParameteri(target, GL_TEXTURE_MAX_LEVEL, levels - 1);
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER,
                    levels > 1 ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, levels > 1 ? GL_LINEAR : GL_NEAREST);
    glTexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void allocate(const TextureDescription& description) {
    const FormatTraits format = traits(description.format);
    const GLenum type = format.floating || format.depth ? GL_FLOAT : GL_UNSIGNED_BYTE;
    for (int face = 0; face < face_count(description.shape); ++face)
        for (int level = 0; level < description.levels; ++level) {
            const glm::ivec2 size = level_size(description.size, level);
            glTexImage2D(image_target(description.shape, face), level,
                         static_cast<GLint>(format.internal), size.x, size.y, 0, format.components,
                         type, nullptr);
        }
}

}  // namespace

int full_level_count(glm::ivec2 size) {
    return std::bit_width(static_cast<unsigned>(std::max({size.x, size.y, 1})));
}

Result<Texture> Texture::make(const TextureDescription& description) {
    assert(description.levels >= 1 && description.levels <= full_level_count(description.size));
    const GLint largest = largest_size(description.shape);
    const glm::ivec2 size = description.size;
    if (size.x < 1 || size.y < 1 || size.x > largest || size.y > largest)
        return failure("texture {}: {} x {} texels, but this OpenGL driver takes 1 to {} a side",
                       description.label, size.x, size.y, largest);

    Texture texture;
    texture.description_ = description;
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(bind_target(description.shape), name);
    texture.object_ = Object(ObjectKind::Texture, name, description.label);
    set_parameters(bind_target(description.shape), description.levels);
    allocate(description);
    return texture;
}

std::uint32_t Texture::target() const {
    return bind_target(description_.shape);
}

glm::ivec2 Texture::size(int level) const {
    return level_size(description_.size, level);
}

std::uint64_t Texture::bytes() const {
    std::uint64_t texels = 0;
    for (int level = 0; level < description_.levels; ++level)
        texels +=
            static_cast<std::uint64_t>(size(level).x) * static_cast<std::uint64_t>(size(level).y);
    return texels * static_cast<std::uint64_t>(traits(description_.format).bytes) *
           static_cast<std::uint64_t>(face_count(description_.shape));
}

std::size_t Texture::value_count(int level) const {
    return static_cast<std::size_t>(size(level).x) * static_cast<std::size_t>(size(level).y) *
           static_cast<std::size_t>(traits(description_.format).channels);
}

void Texture::upload_values(const TextureRegion& region, std::uint32_t type, const void* texels) {
    assert(region.offset.x >= 0 && region.offset.x + region.size.x <= size(region.level).x);
    assert(region.offset.y >= 0 && region.offset.y + region.size.y <= size(region.level).y);
    glBindTexture(target(), name());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, region.row_texels);
    glTexSubImage2D(image_target(description_.shape, region.face), region.level, region.offset.x,
                    region.offset.y, region.size.x, region.size.y,
                    traits(description_.format).components, type, texels);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
}

void Texture::upload(const TextureRegion& region, std::span<const std::uint8_t> texels) {
    upload_values(region, GL_UNSIGNED_BYTE, texels.data());
}

void Texture::upload(const TextureRegion& region, std::span<const float> texels) {
    upload_values(region, GL_FLOAT, texels.data());
}

void Texture::upload_halves(const TextureRegion& region, std::span<const std::uint16_t> texels) {
    upload_values(region, GL_HALF_FLOAT, texels.data());
}

void Texture::generate_mip_levels() {
    glBindTexture(target(), name());
    glGenerateMipmap(target());
}

void Texture::read_values(int level, int face, std::uint32_t type, void* texels) const {
    glBindTexture(target(), name());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTexImage(image_target(description_.shape, face), level,
                  traits(description_.format).components, type, texels);
}

std::vector<float> Texture::read_floats(int level, int face) const {
    std::vector<float> texels(value_count(level));
    read_values(level, face, GL_FLOAT, texels.data());
    return texels;
}

std::vector<std::uint8_t> Texture::read_bytes(int level, int face) const {
    std::vector<std::uint8_t> texels(value_count(level));
    read_values(level, face, GL_UNSIGNED_BYTE, texels.data());
    return texels;
}

}  // namespace patina::gl
