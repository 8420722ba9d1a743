// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "gl/object.h"

namespace patina::gl {

enum class Wrap { Repeat, MirroredRepeat, ClampToEdge };
enum class Filter { Nearest, Linear };
enum class MipFilter { None, Nearest, Linear };

struct SamplerDescription {
    std::string label;
    Wrap wrap_u = Wrap::ClampToEdge;
    Wrap wrap_v = Wrap::ClampToEdge;
    Filter magnify = Filter::Linear;
    Filter minify = Filter::Linear;
    MipFilter mip = MipFilter::None;
    float anisotropy = 1.0f;  // 1 to 16; taken down to what the driver has, and to 1 on the CPU
};

/// Whether that is the GL_RENDERER of a driver that draws on the CPU. Anisotropy doubles the time
/// of a G-buffer there.
bool is_software_renderer(std::string_view renderer);

/// How a texture is read, apart from the texture.
class Sampler {
  public:
    static Sampler make(const SamplerDescription& description);
    /// For engine/gl alone.
    std::uint32_t name() const { return object_.name(); }

  private:
    Object object_;
};

}  // namespace patina::gl
