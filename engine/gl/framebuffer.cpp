// SPDX-License-Identifier: MIT
#include "gl/framebuffer.h"

#include <epoxy/gl.h>

#include <cassert>
#include <string_view>
#include <utility>

namespace patina::gl {
namespace {

std::string_view why_incomplete(GLenum status) {
    switch (status) {
        case GL_FRAMEBUFFER_UNSUPPORTED:
            return "this combination of formats is not supported";
        case GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT:
            return "a target cannot be drawn to";
        case GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT:
            return "it has no target";
        default:
            return "it is incomplete";
    }
}

TextureDescription texture_description(const FramebufferDescription& framebuffer,
                                       std::string_view label, Format format) {
    return {.label = fmt::format("{}.{}", framebuffer.label, label),
            .size = framebuffer.size,
            .format = format};
}

void attach(GLenum point, const Texture& texture) {
    glFramebufferTexture2D(GL_FRAMEBUFFER, point, texture.target(), texture.name(), 0);
}

void select_draw_buffers(std::size_t count) {
    std::vector<GLenum> points;
    for (std::size_t i = 0; i < count; ++i)
        points.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i));
    if (points.empty()) points.push_back(GL_NONE);
    glDrawBuffers(static_cast<GLsizei>(points.size()), points.data());
}

void bind_to_copy(const Framebuffer& from, const Framebuffer& to) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to.name());
    glDisable(GL_SCISSOR_TEST);
}

}  // namespace

Result<Framebuffer> Framebuffer::make(const FramebufferDescription& description) {
    Framebuffer framebuffer;
    framebuffer.description_ = description;
    for (const ColorTarget& target : description.colors) {
        Result<Texture> texture =
            Texture::make(texture_description(description, target.label, target.format));
        if (!texture) return passed_on(texture);
        framebuffer.colors_.push_back(std::move(*texture));
    }
    if (description.depth) {
        Result<Texture> texture =
            Texture::make(texture_description(description, "depth", *description.depth));
        if (!texture) return passed_on(texture);
        framebuffer.depth_ = std::move(*texture);
    }

    GLuint name = 0;
    glGenFramebuffers(1, &name);
    glBindFramebuffer(GL_FRAMEBUFFER, name);
    framebuffer.object_ = Object(ObjectKind::Framebuffer, name, description.label);
    for (std::size_t i = 0; i < framebuffer.colors_.size(); ++i)
        attach(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i), framebuffer.colors_[i]);
    if (framebuffer.depth_) attach(GL_DEPTH_ATTACHMENT, *framebuffer.depth_);
    select_draw_buffers(framebuffer.colors_.size());
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE)
        return failure("framebuffer {}: {} (status 0x{:04x})", description.label,
                       why_incomplete(status), status);
    return framebuffer;
}

Status Framebuffer::resize(glm::ivec2 size) {
    if (size == description_.size) return {};
    FramebufferDescription wanted = description_;
    wanted.size = size;
    Result<Framebuffer> resized = make(wanted);
    if (!resized) return passed_on(resized);
    *this = std::move(*resized);
    return {};
}

std::uint64_t Framebuffer::bytes() const {
    std::uint64_t total = depth_ ? depth_->bytes() : 0;
    for (const Texture& color : colors_) total += color.bytes();
    return total;
}

std::vector<float> Framebuffer::read_color(std::size_t index, glm::ivec2 offset,
                                           glm::ivec2 size) const {
    assert(index < colors_.size());
    std::vector<float> texels(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
                              4);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, name());
    glReadBuffer(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(index));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(offset.x, offset.y, size.x, size.y, GL_RGBA, GL_FLOAT, texels.data());
    return texels;
}

void copy_depth(const Framebuffer& from, glm::ivec2 from_offset, const Framebuffer& to,
                glm::ivec2 to_offset, glm::ivec2 size) {
    bind_to_copy(from, to);
    const glm::ivec2 from_end = from_offset + size;
    const glm::ivec2 to_end = to_offset + size;
    glBlitFramebuffer(from_offset.x, from_offset.y, from_end.x, from_end.y, to_offset.x,
                      to_offset.y, to_end.x, to_end.y, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
}

void copy_color(const Framebuffer& from, const Framebuffer& to) {
    assert(from.size() == to.size());
    bind_to_copy(from, to);
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    const glm::ivec2 size = from.size();
    glBlitFramebuffer(0, 0, size.x, size.y, 0, 0, size.x, size.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

}  // namespace patina::gl
