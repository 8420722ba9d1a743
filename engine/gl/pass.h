// SPDX-License-Identifier: MIT
#pragma once

/// A pass states all of its fixed-function state as a value when it begins, so it never matters
/// what was set before, and nothing is put back afterwards.
///
///   gl::Pass pass({.label = "lighting", .target = &image, .state = {.depth_test =
///   DepthTest::Off}}); program.set("exposure", exposure); pass.bind_texture(program, "albedo", 0,
///   gbuffer.color(0)); pass.draw(program, full_screen, {.count = 3});

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gl/buffer.h"
#include "gl/debug.h"
#include "gl/framebuffer.h"
#include "gl/program.h"
#include "gl/sampler.h"
#include "gl/texture.h"

namespace patina::gl {

enum class DepthTest { Off, Less, LessOrEqual, Greater };
enum class Cull { None, Back, Front };
enum class Blend {
    Replace,        // source
    Premultiplied,  // source + target x (1 - alpha)
    Add,            // source + target
};

/// All the fixed-function state that Patina uses.
struct State {
    // Off: depth is neither tested nor written, whatever write_depth says.
    DepthTest depth_test = DepthTest::Less;
    bool write_depth = true;
    Cull cull = Cull::None;
    bool front_is_clockwise = false;  // for node transforms that mirror
    Blend blend = Blend::Replace;
    bool encode_srgb = false;  // linear to sRGB when writing to Srgb8Alpha8
    bool operator==(const State&) const = default;
};

/// A rectangle of the target in texels, from its lower left corner.
struct Viewport {
    glm::ivec2 offset{0, 0};
    glm::ivec2 size{0, 0};
    bool operator==(const Viewport&) const = default;
};

struct PassDescription {
    std::string label;
    const Framebuffer* target = nullptr;  // null: the window
    std::optional<Viewport> viewport{};   // nothing outside is touched; the window needs one
    std::optional<Viewport> scissor{};    // nothing outside is touched; the viewport unless given
    State state{};
    std::vector<glm::vec4> clear_colors{};  // one for each target to clear, from the first; linear
    std::optional<float> clear_depth{};
};

/// What of a vertex array is drawn: triangles, counted in indices, or in vertices where it has no
/// indices.
struct DrawRange {
    int first = 0;
    int count = 0;
    int instances = 1;
};

/// Drawing to one target, from construction to destruction; a debug group of its label.
class Pass {
  public:
    explicit Pass(const PassDescription& description);

    /// Replaces the whole state, e.g. between single- and double-sided materials.
    void set_state(const State& state);

    /// Lets the program's sampler uniform read `texture` through texture unit `unit`, with the
    /// texture's own filters or a sampler's.
    void bind_texture(Program& program, std::string_view uniform, int unit, const Texture& texture,
                      const Sampler* sampler = nullptr);
    /// Binds a uniform buffer to a slot, see Program::set_block.
    void bind_block(int slot, const Buffer& buffer);

    void draw(const Program& program, const VertexArray& vertices, const DrawRange& range);

  private:
    DebugGroup group_;
    State state_;
};

}  // namespace patina::gl
