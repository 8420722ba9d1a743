// SPDX-License-Identifier: MIT
#include "gl/pass.h"

#include <epoxy/gl.h>

#include <cassert>
#include <glm/gtc/type_ptr.hpp>

namespace patina::gl {
namespace {

void enable(GLenum capability, bool on) {
    if (on)
        glEnable(capability);
    else
        glDisable(capability);
}

GLenum comparison(DepthTest test) {
    switch (test) {
        case DepthTest::Less:
            return GL_LESS;
        case DepthTest::LessOrEqual:
            return GL_LEQUAL;
        case DepthTest::Greater:
            return GL_GREATER;
        case DepthTest::Off:
            return GL_ALWAYS;
    }
    return GL_ALWAYS;
}

void apply_blend(Blend blend) {
    enable(GL_BLEND, blend != Blend::Replace);
    glBlendEquation(GL_FUNC_ADD);
    switch (blend) {
        case Blend::Replace:
            return glBlendFunc(GL_ONE, GL_ZERO);
        case Blend::Premultiplied:
            return glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
        case Blend::Add:
            return glBlendFunc(GL_ONE, GL_ONE);
    }
}

void apply(const State& state) {
    enable(GL_DEPTH_TEST, state.depth_test != DepthTest::Off);
    glDepthFunc(comparison(state.depth_test));
    glDepthMask(state.write_depth ? GL_TRUE : GL_FALSE);
    enable(GL_CULL_FACE, state.cull != Cull::None);
    glCullFace(state.cull == Cull::Front ? GL_FRONT : GL_BACK);
    glFrontFace(state.front_is_clockwise ? GL_CW : GL_CCW);
    apply_blend(state.blend);
    enable(GL_FRAMEBUFFER_SRGB, state.encode_srgb);
}

/// State that Patina never varies but that another user of the context (the interface) may.
void apply_constants() {
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_PRIMITIVE_RESTART);
    glDisable(GL_DITHER);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

void clear(const PassDescription& description) {
    for (std::size_t i = 0; i < description.clear_colors.size(); ++i)
        glClearBufferfv(GL_COLOR, static_cast<GLint>(i),
                        glm::value_ptr(description.clear_colors[i]));
    if (description.clear_depth) glClearBufferfv(GL_DEPTH, 0, &*description.clear_depth);
}

}  // namespace

Pass::Pass(const PassDescription& description)
    : group_(description.label), state_(description.state) {
    assert(description.target != nullptr || description.viewport);
    const Viewport area = description.viewport
                              ? *description.viewport
                              : Viewport{.offset = {0, 0}, .size = description.target->size()};
    glBindFramebuffer(GL_FRAMEBUFFER, description.target ? description.target->name() : 0);
    glViewport(area.offset.x, area.offset.y, area.size.x, area.size.y);
    glEnable(GL_SCISSOR_TEST);  // clears know no viewport
    const Viewport touched = description.scissor.value_or(area);
    glScissor(touched.offset.x, touched.offset.y, touched.size.x, touched.size.y);
    apply_constants();
    // Masks hold for clears too, so these come before the state that the pass draws with.
    apply({.encode_srgb = state_.encode_srgb});
    clear(description);
    apply(state_);
}

void Pass::set_state(const State& state) {
    if (state == state_) return;
    state_ = state;
    apply(state_);
}

void Pass::bind_texture(Program& program, std::string_view uniform, int unit,
                        const Texture& texture, const Sampler* sampler) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(texture.target(), texture.name());
    glBindSampler(static_cast<GLuint>(unit), sampler ? sampler->name() : 0);
    program.set(uniform, unit);
}

void Pass::bind_block(int slot, const Buffer& buffer) {
    glBindBufferBase(GL_UNIFORM_BUFFER, static_cast<GLuint>(slot), buffer.name());
}

void Pass::draw(const Program& program, const VertexArray& vertices, const DrawRange& range) {
    glUseProgram(program.name());
    glBindVertexArray(vertices.name());
    if (vertices.indexed()) {
        const auto offset_bytes = static_cast<std::size_t>(range.first) * sizeof(std::uint32_t);
        // NOLINTNEXTLINE(performance-no-int-to-ptr): OpenGL takes offsets as pointers
        const auto* offset = reinterpret_cast<const void*>(offset_bytes);
        glDrawElementsInstanced(GL_TRIANGLES, range.count, GL_UNSIGNED_INT, offset,
                                range.instances);
    } else {
        glDrawArraysInstanced(GL_TRIANGLES, range.first, range.count, range.instances);
    }
    // Nothing else may record element buffers or attributes into this array by mistake.
    glBindVertexArray(0);
}

}  // namespace patina::gl
