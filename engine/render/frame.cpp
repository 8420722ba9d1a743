// SPDX-License-Identifier: MIT
#include "render/frame.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "render/light_uniforms.h"

namespace patina::render {
namespace {

bool shows_blended(const RendererState& state, const View& view) {
    return view.channel == ChannelView::Final &&
           std::any_of(state.scene->items.begin(), state.scene->items.end(),
                       [&](const DrawItem& item) {
                           return state.materials.at(item.source_material).surface.alpha_mode ==
                                  AlphaMode::Blend;
                       });
}

/// In a channel view blended surfaces are drawn as the nearest surface.
SurfaceSet surfaces_of(const View& view) {
    return view.channel == ChannelView::Final ? SurfaceSet::Opaque : SurfaceSet::All;
}

/// Lights the opaque surfaces, on either path, draws the blended ones over them, and finishes the
/// picture.
Status draw_side_in_steps(RendererState& state, const SideView& side, const FrameCamera& camera,
                          const LightingInputs& inputs, const PictureTarget& target) {
    Result<gl::Framebuffer*> radiance = state.radiance.at(camera.size);
    if (!radiance) return passed_on(radiance);
    View bare = side.view;
    bare.background.kind = Background::Kind::Transparent;
    const SideView bare_side{bare, side.shading, side.side};
    const PictureTarget local{
        .framebuffer = *radiance,
        .area = {target.area.offset - target.picture_offset, target.area.size},
        .output = OutputMode::Radiance,
        .still = target.still,
        .draw_index = target.draw_index};
    if (is_forward(side.view, side.shading)) {
        if (Status done = draw_forward(state, bare_side, camera, SurfaceSet::Opaque, local); !done)
            return done;
    } else if (Status done = draw_deferred(state, bare_side, camera, inputs, local); !done) {
        return done;
    }
    if (shows_blended(state, side.view))
        if (Status done = draw_forward(state, bare_side, camera, SurfaceSet::Blended, local); !done)
            return done;
    return draw_post(state, side, camera, {*radiance}, target);
}

Status draw_side(RendererState& state, const SideView& side, const FrameCamera& camera,
                 const LightingInputs& inputs, const PictureTarget& target) {
    if (shows_blended(state, side.view) || is_forward(side.view, side.shading))
        return draw_side_in_steps(state, side, camera, inputs, target);
    return draw_deferred(state, side, camera, inputs, target);
}

Result<LightingInputs> draw_inputs(RendererState& state, const View& view,
                                   const FrameCamera& camera, GBufferTargets& targets) {
    if (const std::optional<Inspected> inspected = inspected_for(view.channel)) {
        const Result<gl::Framebuffer*> target = draw_inspection(state, view, camera, *inspected);
        if (!target) return passed_on(target);
        return LightingInputs{.inspection = *target};
    }
    if (!gbuffer_readers(view)) return LightingInputs{};
    const Result<gl::Framebuffer*> gbuffer =
        draw_gbuffer(state, targets, view, camera, surfaces_of(view));
    if (!gbuffer) return passed_on(gbuffer);
    return LightingInputs{.gbuffer = *gbuffer};
}

/// Columns of the picture at the left of the divider.
int divider_column(const View& view, int width) {
    return std::clamp(static_cast<int>(std::lround(view.divider * static_cast<float>(width))), 0,
                      width);
}

/// The radiance of both sides.
/// @param whole  how each is drawn; into which framebuffer say `sides`
Status draw_radiance(RendererState& state, const View& view, const FrameCamera& camera,
                     const LightingInputs& inputs, const SidePictures& sides,
                     const PictureTarget& whole) {
    PictureTarget side = whole;
    side.area = {{0, 0}, camera.size};
    side.output = OutputMode::Radiance;
    side.framebuffer = sides.left;
    if (Status done = draw_side(state, {view, view.left, FrameSide::Left}, camera, inputs, side);
        !done)
        return done;
    side.framebuffer = sides.right;
    return draw_side(state, {view, view.right, FrameSide::Right}, camera, inputs, side);
}

/// The radiance of both sides in pictures of their own.
Result<SidePictures> drawn_sides(RendererState& state, const View& view, const FrameCamera& camera,
                                 const LightingInputs& inputs) {
    const Result<gl::Framebuffer*> left = state.left.at(camera.size);
    if (!left) return passed_on(left);
    const Result<gl::Framebuffer*> right = state.right.at(camera.size);
    if (!right) return passed_on(right);
    const SidePictures sides{*left, *right};
    if (Status done = draw_radiance(state, view, camera, inputs, sides, {}); !done)
        return passed_on(done);
    return sides;
}

Status draw_difference_frame(RendererState& state, const View& view, const FrameCamera& camera,
                             const LightingInputs& inputs, const PictureTarget& target) {
    const Result<SidePictures> sides = drawn_sides(state, view, camera, inputs);
    if (!sides) return passed_on(sides);
    return draw_difference(state, view, *sides, target);
}

/// Both sides, each into its own columns.
Status draw_sides(RendererState& state, const View& view, const FrameCamera& camera,
                  const LightingInputs& inputs, const PictureTarget& whole) {
    const int width = whole.area.size.x;
    const int height = whole.area.size.y;
    const bool split = view.compare == CompareMode::Split;
    const int boundary = split ? divider_column(view, width)
                               : side_area(view, whole.area.size, FrameSide::Right).offset.x;
    PictureTarget left = whole;
    left.area = {{0, 0}, {boundary, height}};
    PictureTarget right = whole;
    right.area = {{boundary, 0}, {width - boundary, height}};
    if (!split) right.picture_offset = {boundary, 0};
    if (boundary > 0)
        if (Status done =
                draw_side(state, {view, view.left, FrameSide::Left}, camera, inputs, left);
            !done)
            return done;
    if (boundary == width) return {};
    if (!shows_difference_beside(view))
        return draw_side(state, {view, view.right, FrameSide::Right}, camera, inputs, right);
    right.area.size.x = camera.size.x;
    if (Status done = draw_side(state, {view, view.right, FrameSide::Right}, camera, inputs, right);
        !done)
        return done;
    PictureTarget difference = whole;
    difference.area = {{width - camera.size.x, 0}, camera.size};
    difference.picture_offset = difference.area.offset;
    return draw_difference_frame(state, view, camera, inputs, difference);
}

double total_ms(const std::vector<PassCost>& passes) {
    return std::accumulate(passes.begin(), passes.end(), 0.0,
                           [](double sum, const PassCost& pass) { return sum + pass.gpu_ms; });
}

std::size_t tables_bytes(RendererState& state, const PbrTerms& terms) {
    const Result<const EnvironmentTables*> tables = environment_tables(state, terms);
    return tables ? (*tables)->bytes() : 0;
}

SideCost side_cost(RendererState& state, const Shading& shading, FrameSide side) {
    SideCost cost;
    cost.passes = state.timers.costs(side);
    cost.frame_ms = total_ms(cost.passes);
    // Of frames, or where none was drawn, of stills.
    const std::size_t of_frames = state.gbuffer.bytes();
    if (!is_forward(state.drawn_view, shading))
        cost.gbuffer_bytes = of_frames > 0 ? of_frames : state.still_gbuffer.bytes();
    if (shading.model == ShadingModel::Pbr && state.environment)
        cost.environment_bytes = state.environment->bytes() + tables_bytes(state, shading.terms);
    return cost;
}

}  // namespace

SideArea side_area(const View& view, glm::ivec2 size, FrameSide side) {
    if (view.compare != CompareMode::TwoViews) return {size, {0, 0}};
    // What the width is not a multiple of goes to the last view; the others are drawn as wide and
    // covered by their neighbours.
    const int step = size.x / (shows_difference_beside(view) ? 3 : 2);
    const int last = shows_difference_beside(view) ? 2 * step : step;
    return {{std::max(1, size.x - last), size.y}, {side == FrameSide::Right ? step : 0, 0}};
}

std::vector<gl::Viewport> surface_areas(const RendererState& state, const View& view,
                                        glm::ivec2 size) {
    const SideArea right = side_area(view, size, FrameSide::Right);
    const FrameCamera camera =
        frame_camera(view, state.scene->bounds_world, right.gbuffer_size, glm::vec2(0.0f));
    const gl::Viewport seen = area_seen(state.scene->bounds_world, camera);
    std::vector<gl::Viewport> areas = {seen};
    if (view.compare != CompareMode::TwoViews) return areas;
    areas.push_back({seen.offset + right.offset, seen.size});
    if (shows_difference_beside(view))
        areas.push_back({seen.offset + glm::ivec2(size.x - right.gbuffer_size.x, 0), seen.size});
    return areas;
}

Result<SidePictures> draw_both_sides(RendererState& state, const View& view, glm::ivec2 size) {
    state.timers.begin_frame();
    if (Status lit = ready_lights(state, view); !lit) return passed_on(lit);
    const FrameCamera camera = frame_camera(view, state.scene->bounds_world, size, glm::vec2(0.0f));
    const Result<LightingInputs> inputs = draw_inputs(state, view, camera, state.gbuffer);
    if (!inputs) return passed_on(inputs);
    return drawn_sides(state, view, camera, *inputs);
}

Status draw_frame(RendererState& state, const View& view, glm::ivec2 size,
                  const FrameTarget& target) {
    state.timers.begin_frame();
    state.drawn_view = view;
    std::optional<LampPoint> point;
    if (target.still) point = lamp_point(target.still->index);
    if (Status lit = ready_lights(state, view, point); !lit) return lit;
    const glm::ivec2 gbuffer_size = side_area(view, size, FrameSide::Left).gbuffer_size;
    FrameCamera camera =
        frame_camera(view, state.scene->bounds_world, gbuffer_size, target.jitter_pixels);
    View drawn = view;
    if (target.still) {
        // Many draws see the normal map itself.
        drawn.filter_normals = false;
        camera.level_bias = -0.5f * std::log2(static_cast<float>(target.still->count));
    }
    const Result<LightingInputs> inputs =
        draw_inputs(state, drawn, camera, target.add ? state.still_gbuffer : state.gbuffer);
    if (!inputs) return passed_on(inputs);
    const PictureTarget whole{.framebuffer = target.framebuffer,
                              .area = {{0, 0}, size},
                              .output = target.output,
                              .add = target.add,
                              .still = target.still,
                              .draw_index = target.draw_index};
    switch (view.compare) {
        case CompareMode::Single:
            return draw_side(state, {drawn, drawn.left, FrameSide::Left}, camera, *inputs, whole);
        case CompareMode::Split:
        case CompareMode::TwoViews:
            return draw_sides(state, drawn, camera, *inputs, whole);
        case CompareMode::Difference:
            if (target.right_sum != nullptr)
                return draw_radiance(state, drawn, camera, *inputs,
                                     {target.framebuffer, target.right_sum}, whole);
            return draw_difference_frame(state, drawn, camera, *inputs, whole);
    }
    return {};
}

Status draw_averaged(RendererState& state, const View& view, glm::ivec2 size,
                     const gl::Framebuffer& sum, int draws, const FrameTarget& target) {
    // The floor's shadows are those of whole lamps.
    if (shades_floor(view))
        if (Status lit = ready_lights(state, view); !lit) return lit;
    const glm::ivec2 side_size = side_area(view, size, FrameSide::Left).gbuffer_size;
    const FrameCamera camera =
        frame_camera(view, state.scene->bounds_world, side_size, glm::vec2(0.0f));
    const auto post = [&](FrameSide side, const gl::Viewport& area) {
        return draw_post(state, {view, view.left, side}, camera, {&sum, area.offset, draws},
                         {.framebuffer = target.framebuffer,
                          .area = area,
                          .picture_offset = area.offset,
                          .output = target.output});
    };
    if (view.compare != CompareMode::TwoViews) return post(FrameSide::Left, {{0, 0}, size});
    const glm::ivec2 offset = side_area(view, size, FrameSide::Right).offset;
    if (offset.x > 0)
        if (Status done = post(FrameSide::Left, {{0, 0}, {offset.x, size.y}}); !done) return done;
    return post(FrameSide::Right, {offset, {size.x - offset.x, size.y}});
}

Status draw_strip_frame(RendererState& state, const View& view, glm::ivec2 thumbnail,
                        const gl::Framebuffer& target) {
    View shown = view;
    shown.compare = CompareMode::Single;
    shown.filter_normals = false;  // the G-buffer serves the channels too
    if (Status lit = ready_lights(state, shown); !lit) return lit;
    const FrameCamera camera =
        frame_camera(shown, state.scene->bounds_world, thumbnail, glm::vec2(0.0f));
    // The finished picture wants blended surfaces apart, the channels want them in the G-buffer.
    SurfaceSet drawn = SurfaceSet::Opaque;
    LightingInputs inputs;
    for (int i = 0; i < kStripChannelCount; ++i) {
        shown.channel = kChannelViews[static_cast<std::size_t>(i)].view;
        if (inputs.gbuffer == nullptr ||
            (surfaces_of(shown) != drawn && shows_blended(state, view))) {
            const Result<gl::Framebuffer*> gbuffer =
                draw_gbuffer(state, state.strip_gbuffer, shown, camera, surfaces_of(shown));
            if (!gbuffer) return passed_on(gbuffer);
            inputs.gbuffer = *gbuffer;
            drawn = surfaces_of(shown);
        }
        const glm::ivec2 offset(i * thumbnail.x, 0);
        const PictureTarget place{
            .framebuffer = &target, .area = {offset, thumbnail}, .picture_offset = offset};
        const SideView side{shown, view.left, FrameSide::Left};
        if (Status done = draw_side(state, side, camera, inputs, place); !done) return done;
    }
    return {};
}

FrameStats frame_stats(RendererState& state) {
    const View& view = state.drawn_view;
    FrameStats stats;
    stats.left = side_cost(state, view.left, FrameSide::Left);
    if (view.compare != CompareMode::Single)
        stats.right = side_cost(state, view.right, FrameSide::Right);
    stats.material_texture_bytes = state.materials.texture_bytes();
    stats.triangles = state.scene ? state.scene->triangles : 0;
    return stats;
}

}  // namespace patina::render
