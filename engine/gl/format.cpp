// SPDX-License-Identifier: MIT
#include "gl/format.h"

#include <epoxy/gl.h>

namespace patina::gl {

FormatTraits traits(Format format) {
    switch (format) {
        case Format::R8:
            return {GL_R8, GL_RED, 1, 1, false, false};
        case Format::Rg8:
            return {GL_RG8, GL_RG, 2, 2, false, false};
        case Format::Rgb8:
            return {GL_RGB8, GL_RGB, 3, 3, false, false};
        case Format::Rgba8:
            return {GL_RGBA8, GL_RGBA, 4, 4, false, false};
        case Format::Srgb8:
            return {GL_SRGB8, GL_RGB, 3, 3, false, false};
        case Format::Srgb8Alpha8:
            return {GL_SRGB8_ALPHA8, GL_RGBA, 4, 4, false, false};
        case Format::R16F:
            return {GL_R16F, GL_RED, 1, 2, false, true};
        case Format::Rg16F:
            return {GL_RG16F, GL_RG, 2, 4, false, true};
        case Format::Rgba16F:
            return {GL_RGBA16F, GL_RGBA, 4, 8, false, true};
        case Format::R32F:
            return {GL_R32F, GL_RED, 1, 4, false, true};
        case Format::Rg32F:
            return {GL_RG32F, GL_RG, 2, 8, false, true};
        case Format::Rgba32F:
            return {GL_RGBA32F, GL_RGBA, 4, 16, false, true};
        case Format::Depth24:
            return {GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, 1, 4, true, false};
        case Format::Depth32F:
            return {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, 1, 4, true, true};
    }
    return {};
}

}  // namespace patina::gl
