// SPDX-License-Identifier: MIT

/// What is at one pixel: the passes are drawn again for that pixel alone.

#include <cmath>

#include "core/formulae/formulae.h"
#include "render/frame.h"
#include "render/light_uniforms.h"
#include "render/renderer.h"

namespace patina::render {
namespace {

/// A pixel of the last picture in the G-buffer of the side that shows it.
struct Place {
    glm::ivec2 gbuffer_size;
    glm::ivec2 pixel;  ///< from the lower left corner
    FrameSide side;
};

std::optional<Place> place_of(const RendererState& state, Pixel pixel) {
    const PictureSize size = state.last_size;
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= size.width || pixel.y >= size.height)
        return std::nullopt;
    const glm::ivec2 whole(size.width, size.height);
    const View& view = state.last_view;
    const SideArea right = side_area(view, whole, FrameSide::Right);
    bool is_right = view.compare == CompareMode::TwoViews && pixel.x >= right.offset.x;
    int x = is_right ? pixel.x - right.offset.x : pixel.x;
    if (const int third = size.width - right.gbuffer_size.x;
        shows_difference_beside(view) && pixel.x >= third) {
        is_right = false;
        x = pixel.x - third;
    }
    if (view.compare == CompareMode::Split)
        is_right = static_cast<float>(pixel.x) >= view.divider * static_cast<float>(size.width);
    return Place{right.gbuffer_size,
                 {x, size.height - 1 - pixel.y},
                 is_right ? FrameSide::Right : FrameSide::Left};
}

gl::Viewport one_pixel(const Place& place) {
    return {place.pixel, {1, 1}};
}

glm::vec4 read_texel(const gl::Framebuffer& framebuffer, glm::ivec2 pixel) {
    const std::vector<float> texel = framebuffer.read_color(0, pixel, {1, 1});
    return {texel[0], texel[1], texel[2], texel[3]};
}

/// What the channels of one pixel are read from, and the row that they are drawn into.
struct ProbeTargets {
    FrameCamera camera;
    const gl::Framebuffer* gbuffer;
    const gl::Framebuffer* values;
};

/// Draws the G-buffer of the last view at that pixel.
Result<ProbeTargets> probe_targets(RendererState& state, const Place& place) {
    if (Status lit = ready_lights(state, state.last_view); !lit) return passed_on(lit);
    const FrameCamera camera = frame_camera(state.last_view, state.scene->bounds_world,
                                            place.gbuffer_size, glm::vec2(0.0f));
    View unfiltered = state.last_view;
    unfiltered.filter_normals = false;
    const Result<gl::Framebuffer*> gbuffer = draw_gbuffer(
        state, state.still_gbuffer, unfiltered, camera, SurfaceSet::All, one_pixel(place));
    if (!gbuffer) return passed_on(gbuffer);
    const Result<gl::Framebuffer*> values = state.probe_values.at({kChannelViewCount, 1});
    if (!values) return passed_on(values);
    return ProbeTargets{camera, *gbuffer, *values};
}

/// Draws what a channel holds at the pixel into texel `channel` of the probe's row.
Status draw_probe_channel(RendererState& state, const View& view, const Place& place,
                          const ProbeTargets& targets) {
    LightingInputs inputs{.gbuffer = targets.gbuffer};
    if (const std::optional<Inspected> inspected = inspected_for(view.channel)) {
        const Result<gl::Framebuffer*> drawn =
            draw_inspection(state, view, targets.camera, *inspected, one_pixel(place));
        if (!drawn) return passed_on(drawn);
        inputs = {.inspection = *drawn};
    }
    const Shading& shading = place.side == FrameSide::Right ? view.right : view.left;
    const PictureTarget texel{.framebuffer = targets.values,
                              .area = {{static_cast<int>(view.channel), 0}, {1, 1}},
                              .output = OutputMode::Radiance};
    return draw_lit_pixel(state, {view, shading, place.side}, targets.camera, inputs, texel,
                          place.pixel);
}

}  // namespace

std::optional<Pick> Renderer::pick(Pixel pixel) {
    if (!require_content(*state_)) return std::nullopt;
    const std::optional<Place> place = place_of(*state_, pixel);
    if (!place) return std::nullopt;
    const FrameCamera camera = frame_camera(state_->last_view, state_->scene->bounds_world,
                                            place->gbuffer_size, glm::vec2(0.0f));
    const Result<gl::Framebuffer*> drawn =
        draw_inspection(*state_, state_->last_view, camera, Inspected::Ids, one_pixel(*place));
    if (!drawn) return std::nullopt;
    const glm::vec4 ids = read_texel(**drawn, place->pixel);
    if (ids.a == 0.0f) return std::nullopt;
    return Pick{static_cast<int>(ids.x), static_cast<int>(ids.y), static_cast<int>(ids.z)};
}

Result<std::optional<Probe>> Renderer::probe(Pixel pixel) {
    if (Status ready = require_content(*state_); !ready) return passed_on(ready);
    const std::optional<Pick> picked = pick(pixel);
    if (!picked) return std::optional<Probe>();
    const Place place = *place_of(*state_, pixel);
    const Result<ProbeTargets> targets = probe_targets(*state_, place);
    if (!targets) return passed_on(targets);
    View view = state_->last_view;
    for (const ChannelViewInfo& channel : kChannelViews) {
        view.channel = channel.view;
        if (Status done = draw_probe_channel(*state_, view, place, *targets); !done)
            return passed_on(done);
    }
    Probe probe{.instance = picked->instance,
                .primitive = picked->primitive,
                .source_material = picked->source_material};
    const std::vector<float> row = targets->values->read_color(0, {0, 0}, {kChannelViewCount, 1});
    for (std::size_t i = 0; i < probe.values.size(); ++i)
        probe.values[i] = {row[4 * i], row[4 * i + 1], row[4 * i + 2]};
    probe.uv = glm::vec2(probe[ChannelView::Uv0]);
    return std::optional<Probe>(probe);
}

Result<std::optional<SideValues>> Renderer::probe_sides(Pixel pixel) {
    if (Status ready = require_content(*state_); !ready) return passed_on(ready);
    if (!pick(pixel)) return std::optional<SideValues>();
    Place place = *place_of(*state_, pixel);
    const Result<ProbeTargets> targets = probe_targets(*state_, place);
    if (!targets) return passed_on(targets);
    View view = state_->last_view;
    view.channel = ChannelView::Final;
    std::array<glm::vec3, 2> found;
    for (const FrameSide side : {FrameSide::Left, FrameSide::Right}) {
        place.side = side;
        if (Status done = draw_probe_channel(*state_, view, place, *targets); !done)
            return passed_on(done);
        found[side == FrameSide::Right ? 1 : 0] =
            glm::vec3(read_texel(*targets->values, {static_cast<int>(ChannelView::Final), 0}));
    }
    return std::optional(SideValues{found[0], found[1]});
}

Result<std::vector<float>> Renderer::differences(const View& view, PictureSize size) {
    if (Status ready = require_content(*state_); !ready) return passed_on(ready);
    View bare = view;
    bare.channel = ChannelView::Final;
    bare.background.kind = Background::Kind::Transparent;
    const glm::ivec2 pixels(size.width, size.height);
    const Result<SidePictures> sides = draw_both_sides(*state_, bare, pixels);
    if (!sides) return passed_on(sides);
    const std::vector<float> left = sides->left->read_color(0, {0, 0}, pixels);
    const std::vector<float> right = sides->right->read_color(0, {0, 0}, pixels);
    const float exposure = std::exp2(view.exposure_ev);
    const auto luminance_at = [](const std::vector<float>& rgba, std::size_t i) {
        return formulae::luminance(formulae::Real3(rgba[i], rgba[i + 1], rgba[i + 2]));
    };
    std::vector<float> result;
    for (std::size_t i = 0; i < left.size(); i += 4)
        if (left[i + 3] > 0.5f)
            result.push_back(exposure * std::abs(luminance_at(left, i) - luminance_at(right, i)));
    return result;
}

}  // namespace patina::render
