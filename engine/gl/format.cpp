// SPDX-License-Identifier: MIT
#include "gl/format.h"

#include <epoxy/gl.h>

namespace patina::gl {

FormatTraits traits(Format format) {
    switch (format) {
        case Format::R8:
            return {GL_R8, GL_RED, 1, 1, false, false};
        case Format::Rgba8:
            return {GL_RGBA8, GL_RGBA, 4, 4, false, false};
        case Format::Srgb8Alpha8:
            return {GL_SRGB8_ALPHA8, GL_RGBA, 4, 4, false, false};
        case Format::Rgba16F:
            return {GL_RGBA16F, GL_RGBA, 4, 8, false, true};
        case Format::Rgba32F:
            return {GL_RGBA32F, GL_RGBA, 4, 16, false, true};
        case Format::Depth32F:
            return {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, 1, 4, true, true};
    }
    return {};
}

}  // namespace patina::gl
