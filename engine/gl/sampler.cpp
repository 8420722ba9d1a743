// SPDX-License-Identifier: MIT
#include "gl/sampler.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>

namespace patina::gl {
namespace {

GLint wrap_mode(Wrap wrap) {
    switch (wrap) {
        case Wrap::Repeat:
            return GL_REPEAT;
        case Wrap::MirroredRepeat:
            return GL_MIRRORED_REPEAT;
        case Wrap::ClampToEdge:
            return GL_CLAMP_TO_EDGE;
    }
    return GL_REPEAT;
}

GLint minifying_filter(Filter filter, MipFilter mip) {
    const bool linear = filter == Filter::Linear;
    switch (mip) {
        case MipFilter::None:
            return linear ? GL_LINEAR : GL_NEAREST;
        case MipFilter::Nearest:
            return linear ? GL_LINEAR_MIPMAP_NEAREST : GL_NEAREST_MIPMAP_NEAREST;
        case MipFilter::Linear:
            return linear ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST_MIPMAP_LINEAR;
    }
    return GL_NEAREST;
}

bool draws_in_software() {
    const GLubyte* renderer = glGetString(GL_RENDERER);
    return renderer != nullptr && is_software_renderer(reinterpret_cast<const char*>(renderer));
}

void set_anisotropy(GLuint name, float wanted) {
    if (wanted <= 1.0f || draws_in_software() ||
        !epoxy_has_gl_extension("GL_EXT_texture_filter_anisotropic"))
        return;
    GLfloat largest = 1.0f;
    glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &largest);
    glSamplerParameterf(name, GL_TEXTURE_MAX_ANISOTROPY_EXT, std::min(wanted, largest));
}

}  // namespace

bool is_software_renderer(std::string_view renderer) {
    // Mesa's three, Google's, and what Windows and macOS have where there is no driver.
    constexpr std::array<std::string_view, 6> kNames = {"llvmpipe",    "softpipe",    "swrast",
                                                        "SwiftShader", "GDI Generic", "Software"};
    return std::any_of(kNames.begin(), kNames.end(), [&](std::string_view name) {
        return renderer.find(name) != std::string_view::npos;
    });
}

Sampler Sampler::make(const SamplerDescription& description) {
    GLuint name = 0;
    glGenSamplers(1, &name);
    glBindSampler(0, name);  // brings it into being, so that it can be labelled
    glBindSampler(0, 0);
    Sampler sampler;
    sampler.object_ = Object(ObjectKind::Sampler, name, description.label);
    glSamplerParameteri(name, GL_TEXTURE_WRAP_S, wrap_mode(description.wrap_u));
    glSamplerParameteri(name, GL_TEXTURE_WRAP_T, wrap_mode(description.wrap_v));
    glSamplerParameteri(name, GL_TEXTURE_MAG_FILTER,
                        description.magnify == Filter::Linear ? GL_LINEAR : GL_NEAREST);
    glSamplerParameteri(name, GL_TEXTURE_MIN_FILTER,
                        minifying_filter(description.minify, description.mip));
    set_anisotropy(name, description.anisotropy);
    return sampler;
}

}  // namespace patina::gl
