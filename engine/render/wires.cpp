// SPDX-License-Identifier: MIT
#include "render/wires.h"

#include "render/frame.h"
#include "render/picture_passes.h"

namespace patina::render {
namespace {

/// Light enough for dark surfaces, and coloured so that white ones show it too.
constexpr glm::vec4 kLineColor(0.27f, 0.75f, 0.66f, 0.7f);

/// The wires of what is nearest, alone: a triangle behind another is hidden by it.
Status draw_lines(RendererState& state, const View& view, const gl::Framebuffer& lines) {
    const Result<gl::Program*> found =
        state.shaders.program({kSurfaceVertexFile, "passes/wires.frag", {}, "passes/wires.geom"});
    if (!found) return passed_on(found);
    gl::Program& program = **found;
    const FrameCamera camera =
        frame_camera(view, state.scene->bounds_world, lines.size(), glm::vec2(0.0f));
    program.set("clip_from_world", camera.clip_from_world);
    program.set("picture_size", glm::vec2(lines.size()));
    program.set("line_color", kLineColor);
    gl::Pass pass({.label = "wires",
                   .target = &lines,
                   .clear_colors = {glm::vec4(0.0f)},
                   .clear_depth = 1.0f});
    draw_surfaces(state, pass, program, {}, front_to_back(state.scene->items, view.camera),
                  SurfaceSet::All);
    return {};
}

Status lay_over(RendererState& state, const gl::Framebuffer& lines, glm::ivec2 offset,
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

}  // namespace

Status draw_wires(RendererState& state, const View& view, const gl::Framebuffer& picture) {
    const glm::ivec2 size = picture.size();
    const SideArea left = side_area(view, size, FrameSide::Left);
    const Result<gl::Framebuffer*> lines = state.wires.at(left.gbuffer_size);
    if (!lines) return passed_on(lines);
    if (Status drawn = draw_lines(state, view, **lines); !drawn) return drawn;
    std::vector<glm::ivec2> offsets = {left.offset};
    if (view.compare == CompareMode::TwoViews) {
        offsets.push_back(side_area(view, size, FrameSide::Right).offset);
        if (shows_difference_beside(view)) offsets.push_back({size.x - left.gbuffer_size.x, 0});
    }
    for (const glm::ivec2 offset : offsets)
        if (Status done = lay_over(state, **lines, offset, picture); !done) return done;
    return {};
}

}  // namespace patina::render
