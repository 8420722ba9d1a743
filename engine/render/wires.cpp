// SPDX-License-Identifier: MIT
#include "render/wires.h"

#include "render/frame.h"
#include "render/picture_passes.h"
#include "scene/paint.h"

namespace patina::render {
namespace {

/// Light enough for dark surfaces, and coloured so that white ones show it too.
constexpr glm::vec4 kLineColor(0.27f, 0.75f, 0.66f, 0.7f);

/// The wires of what is nearest, alone: a triangle behind another is hidden by it.
Status draw_lines(RendererState& state, const View& view, const gl::Framebuffer& lines) {
    const FrameCamera camera =
        frame_camera(view, state.scene->bounds_world, lines.size(), glm::vec2(0.0f));
    SurfacePrograms programs(state.shaders,
                             {kSurfaceVertexFile, "passes/wires.frag", {}, "passes/wires.geom"}, 0,
                             [&](gl::Program& program) {
                                 program.set("clip_from_world", camera.clip_from_world);
                                 program.set("picture_size", glm::vec2(lines.size()));
                                 program.set("line_color", kLineColor);
                             });
    gl::Pass pass({.label = "wires",
                   .target = &lines,
                   .clear_colors = {glm::vec4(0.0f)},
                   .clear_depth = 1.0f});
    return draw_surfaces(state, pass, programs, {}, front_to_back(state.scene->items, view.camera),
                         SurfaceSet::All);
}

Status lay_lines_over(RendererState& state, const gl::Framebuffer& lines, glm::ivec2 offset,
                      const gl::Framebuffer& picture) {
    const Result<gl::Program*> found =
        state.shaders.program({kFullScreenVertexFile, "passes/overlay.frag", {}});
    if (!found) return passed_on(found);
    gl::Program& program = **found;
    gl::State over = kFullScreenState;
    over.blend = gl::Blend::Premultiplied;
    gl::Pass pass({.label = "wires over the picture",
                   .target = &picture,
                   .viewport = gl::Viewport{offset, lines.size()},
                   .state = over});
    program.set("offset", offset);
    pass.bind_texture(program, "picture", 0, lines.color(0));
    pass.draw(program, state.full_screen, {.count = 3});
    return {};
}

/// Wires that are drawn once, and where they lie in the picture, from its lower left corner.
struct Wires {
    const gl::Framebuffer* lines;
    std::vector<glm::ivec2> offsets;
};

Result<Wires> drawn_wires(RendererState& state, const View& view, glm::ivec2 size) {
    const SideArea left = side_area(view, size, FrameSide::Left);
    const Result<gl::Framebuffer*> lines = state.wires.at(left.gbuffer_size);
    if (!lines) return passed_on(lines);
    if (Status drawn = draw_lines(state, view, **lines); !drawn) return passed_on(drawn);
    std::vector<glm::ivec2> offsets = {left.offset};
    if (view.compare == CompareMode::TwoViews) {
        offsets.push_back(side_area(view, size, FrameSide::Right).offset);
        if (shows_difference_beside(view)) offsets.push_back({size.x - left.gbuffer_size.x, 0});
    }
    return Wires{*lines, std::move(offsets)};
}

}  // namespace

Status draw_wires(RendererState& state, const View& view, const gl::Framebuffer& picture) {
    const Result<Wires> wires = drawn_wires(state, view, picture.size());
    if (!wires) return passed_on(wires);
    for (const glm::ivec2 offset : wires->offsets)
        if (Status done = lay_lines_over(state, *wires->lines, offset, picture); !done) return done;
    return {};
}

Status lay_wires(RendererState& state, const View& view, Image& still) {
    const Result<Wires> wires = drawn_wires(state, view, {still.width, still.height});
    if (!wires) return passed_on(wires);
    const glm::ivec2 size = wires->lines->size();
    const std::vector<float> lines = wires->lines->read_color(0, {0, 0}, size);
    for (const glm::ivec2 offset : wires->offsets)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const std::size_t texel =
                    static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) +
                    static_cast<std::size_t>(x);
                lay_over(still, offset.x + x, still.height - 1 - (offset.y + y),
                         glm::vec4(glm::vec3(kLineColor), lines[4 * texel + 3]));
            }
    return {};
}

}  // namespace patina::render
