// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace patina::gl {

/// Texel formats. 8-bit ones are normalised to 0..1; Srgb8Alpha8 is decoded to linear when sampled
/// (alpha is linear) and encoded when drawn to with State::encode_srgb.
enum class Format {
    R8,
    Rgba8,
    Srgb8Alpha8,
    Rgba16F,
    Rgba32F,
    Depth32F,
};

/// How OpenGL names a format, and how its texels lie in memory.
struct FormatTraits {
    std::uint32_t internal;    // e.g. GL_RGBA16F
    std::uint32_t components;  // e.g. GL_RGBA
    int channels;
    int bytes;  // per texel on the GPU, for accounting
    bool depth;
    bool floating;
};
FormatTraits traits(Format format);

}  // namespace patina::gl
