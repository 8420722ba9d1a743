// SPDX-License-Identifier: MIT
#include "render/shadow_maps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numeric>
#include <span>

#include "render/geometry_passes.h"
#include "render/light_uniforms.h"

namespace patina::render {
namespace {

constexpr int kMapSide = 2048;
constexpr int kShadowUnit = 12;

gl::Viewport place_of(std::size_t map) {
    return {{static_cast<int>(map) * kMapSide, 0}, {kMapSide, kMapSide}};
}

Status draw_map(RendererState& state, std::size_t map) {
    const ShadowView seen =
        shadow_view(state.scene->bounds_world, state.shadow_maps.plan.lights[map]);
    gl::Pass pass({.label = "shadow map",
                   .target = &*state.shadow_maps.maps,
                   .viewport = place_of(map),
                   .scissor = place_of(map),
                   .clear_depth = 1.0f});
    SurfacePrograms programs(
        state.shaders, {kSurfaceVertexFile, "passes/shadow.frag", {}}, kBaseColorSlot,
        [&](gl::Program& program) { program.set("clip_from_world", seen.clip_from_world); });
    std::vector<std::size_t> order(state.scene->items.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    return draw_surfaces(state, pass, programs, {}, order, kShadowCasters);
}

/// A texture for so many maps. What it held is gone where it has to be another.
Status make_room(ShadowMaps& shadows, std::size_t count) {
    const glm::ivec2 size(kMapSide * static_cast<int>(count), kMapSide);
    if (shadows.maps && shadows.maps->size() == size) return {};
    Result<gl::Framebuffer> made = gl::Framebuffer::make(
        {.label = "shadow maps", .size = size, .depth = gl::Format::Depth32F});
    if (!made) return passed_on(made);
    shadows.maps = std::move(*made);
    shadows.stale = true;
    return {};
}

/// Laid out as passes/shadows.glsl says.
void set_shadow_views(gl::Program& program, const ShadowPlan& plan, const Bounds& bounds) {
    std::array<glm::vec4, 4 * kMostShadows> rows = {};
    std::array<glm::vec4, kMostShadows> shapes = {};
    std::array<glm::vec4, kMostShadows> ranges = {};
    const glm::mat4 map_from_clip =
        glm::scale(glm::translate(glm::mat4(1.0f), glm::vec3(0.5f)), glm::vec3(0.5f));
    for (std::size_t i = 0; i < plan.lights.size(); ++i) {
        const ShadowLight& light = plan.lights[i];
        const ShadowView seen = shadow_view(bounds, light);
        const glm::mat4 map_from_world = glm::transpose(map_from_clip * seen.clip_from_world);
        for (int row = 0; row < 4; ++row)
            rows[4 * i + static_cast<std::size_t>(row)] = map_from_world[row];
        shapes[i] = {seen.across, light.is_far ? std::tan(light.radius) : light.radius,
                     static_cast<float>(kMapSide), light.is_far ? 0.0f : 1.0f};
        ranges[i] = {seen.near_m, seen.far_m, 0.0f, 0.0f};
    }
    program.set("shadow_from_world[0]", std::span<const glm::vec4>(rows));
    program.set("shadow_shape[0]", std::span<const glm::vec4>(shapes));
    program.set("shadow_range[0]", std::span<const glm::vec4>(ranges));
}

}  // namespace

Status draw_shadow_maps(RendererState& state, const View& view,
                        const std::optional<LampPoint>& point) {
    ShadowMaps& shadows = state.shadow_maps;
    shadows.plan = shadow_plan(view, *state.environment, state.scene->bounds_world, point);
    shadows.point = point.value_or(LampPoint{});
    const std::vector<ShadowLight>& lights = shadows.plan.lights;
    if (lights.empty() || (!shadows.stale && shadows.drawn == lights)) return {};
    if (Status room = make_room(shadows, lights.size()); !room) return room;
    const PassTimers::Scope timed = state.timers.measure(FrameSide::Shared, "Shadows");
    shadows.drawn.resize(shadows.stale ? 0 : std::min(shadows.drawn.size(), lights.size()));
    for (std::size_t map = 0; map < lights.size(); ++map)
        if (map >= shadows.drawn.size() || !(shadows.drawn[map] == lights[map]))
            if (Status drawn = draw_map(state, map); !drawn) return drawn;
    shadows.drawn = lights;
    shadows.stale = false;
    return {};
}

void bind_shadows(gl::Pass& pass, gl::Program& program, const RendererState& state,
                  int draw_index) {
    const ShadowMaps& shadows = state.shadow_maps;
    std::array<float, kMostShadows> lamps = {};
    for (std::size_t i = 0; i < lamps.size(); ++i)
        lamps[i] = static_cast<float>(shadows.plan.lamps[i]);
    program.set("shadow_lamp[0]", std::span<const float>(lamps));
    program.set("shadow_count", static_cast<int>(shadows.plan.lights.size()));
    program.set("sun_shadow_count", shadows.plan.suns);
    program.set("key_shadow", shadows.plan.key);
    program.set("lamp_point", shadows.point.u);
    if (shadows.plan.lights.empty()) return;
    pass.bind_texture(program, "shadow_maps", kShadowUnit, shadows.maps->depth());
    set_shadow_views(program, shadows.plan, state.scene->bounds_world);
    constexpr double kGoldenTurn = 0.6180339887498949;
    const double turn = kGoldenTurn * draw_index;
    program.set("shadow_turn", static_cast<float>(turn - std::floor(turn)));
}

}  // namespace patina::render
