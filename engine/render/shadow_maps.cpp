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

/// The sun's, as it is seen from the Earth: lamps that are infinitely far away have no size.
constexpr float kLampRadius = 0.00465f;
/// The key light stands for a bright region of the map: as wide as a soft box some steps away.
constexpr float kKeyRadius = 0.03f;
/// A sun nearer to the key light than this is what the key light stands for.
constexpr float kSameLightCosine = 0.966f;  // 15 degrees

void plan_key_light(const View& view, const GpuEnvironment& environment, ShadowPlan& plan) {
    const glm::vec3 towards = -turned_key_direction(view, environment);
    for (int i = 0; i < plan.suns; ++i)
        if (glm::dot(plan.lights[static_cast<std::size_t>(i)].towards_world, towards) >
            kSameLightCosine)
            plan.key = i;
    if (plan.key >= 0 || plan.lights.size() >= kMostShadows) return;
    plan.key = static_cast<int>(plan.lights.size());
    plan.lights.push_back({towards, kKeyRadius});
}

glm::vec3 any_across(const glm::vec3& direction) {
    const glm::vec3 up =
        std::abs(direction.y) < 0.9f ? glm::vec3(0.0f, 1.0f, 0.0f) : glm::vec3(1.0f, 0.0f, 0.0f);
    return glm::normalize(glm::cross(up, direction));
}

gl::Viewport place_of(std::size_t map) {
    return {{static_cast<int>(map) * kMapSide, 0}, {kMapSide, kMapSide}};
}

void draw_map(RendererState& state, std::size_t map, gl::Program& program) {
    const ShadowView seen =
        shadow_view(state.scene->bounds_world, state.shadow_maps.plan.lights[map].towards_world);
    gl::Pass pass({.label = "shadow map",
                   .target = &*state.shadow_maps.maps,
                   .viewport = place_of(map),
                   .clear_depth = 1.0f});
    program.set("clip_from_world", seen.clip_from_world);
    std::vector<std::size_t> order(state.scene->items.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    draw_surfaces(state, pass, program, {}, order, SurfaceSet::Opaque);
}

}  // namespace

ShadowPlan shadow_plan(const View& view, const GpuEnvironment& environment) {
    ShadowPlan plan;
    if (!view.shadows) return plan;
    if (shows_pbr(view)) {
        const glm::mat3 world_from_environment =
            glm::transpose(environment_from_world(view.environment_rotation_degrees));
        for (const EnvironmentSun& sun : environment.suns) {
            if (plan.lights.size() == kMostShadows) break;
            plan.lights.push_back({world_from_environment * sun.towards_world, sun.radius_radians});
        }
        plan.suns = static_cast<int>(plan.lights.size());
    }
    if (shows_traditional(view)) plan_key_light(view, environment, plan);
    for (std::size_t i = 0; i < view.lights.size() && plan.lights.size() < kMostShadows; ++i) {
        const Light& light = view.lights[i];
        if (light.kind != Light::Kind::Directional) continue;
        plan.lamps[plan.lights.size()] = static_cast<int>(i);
        plan.lights.push_back({-glm::normalize(light.direction_world), kLampRadius});
    }
    return plan;
}

ShadowView shadow_view(const Bounds& bounds, const glm::vec3& towards_world) {
    const glm::vec3 center = bounds.center();
    // A little more than the ball around the scene, so that taps at its rim find nothing.
    const float radius = std::max(1.05f * bounds.radius(), 1e-6f);
    const glm::vec3 across = any_across(towards_world);
    const glm::mat4 light_from_world =
        glm::lookAt(center + radius * towards_world, center, glm::cross(towards_world, across));
    return {.clip_from_world = glm::ortho(-radius, radius, -radius, radius, 0.0f, 2.0f * radius) *
                               light_from_world,
            .side_m = 2.0f * radius};
}

Status draw_shadow_maps(RendererState& state, const View& view) {
    ShadowMaps& shadows = state.shadow_maps;
    shadows.plan = shadow_plan(view, *state.environment);
    const std::vector<ShadowLight>& lights = shadows.plan.lights;
    if (lights.empty() || (!shadows.stale && shadows.drawn == lights)) return {};
    const glm::ivec2 size(kMapSide * static_cast<int>(lights.size()), kMapSide);
    if (!shadows.maps || shadows.maps->size() != size) {
        Result<gl::Framebuffer> made = gl::Framebuffer::make(
            {.label = "shadow maps", .size = size, .depth = gl::Format::Depth32F});
        if (!made) return passed_on(made);
        shadows.maps = std::move(*made);
    }
    const Result<gl::Program*> program =
        state.shaders.program({kSurfaceVertexFile, "passes/shadow.frag", {}});
    if (!program) return passed_on(program);
    const PassTimers::Scope timed = state.timers.measure(FrameSide::Shared, "Shadows");
    for (std::size_t map = 0; map < lights.size(); ++map) draw_map(state, map, **program);
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
    program.set("sun_shadow_count", shadows.plan.suns);
    program.set("key_shadow", shadows.plan.key);
    if (shadows.plan.lights.empty()) return;
    pass.bind_texture(program, "shadow_maps", kShadowUnit, shadows.maps->depth());
    std::array<glm::vec4, 3 * kMostShadows> rows = {};
    std::array<glm::vec4, kMostShadows> shapes = {};
    for (std::size_t i = 0; i < shadows.plan.lights.size(); ++i) {
        const ShadowLight& light = shadows.plan.lights[i];
        const ShadowView seen = shadow_view(state.scene->bounds_world, light.towards_world);
        const glm::mat4 map_from_world = glm::transpose(
            glm::scale(glm::translate(glm::mat4(1.0f), glm::vec3(0.5f)), glm::vec3(0.5f)) *
            seen.clip_from_world);
        for (int row = 0; row < 3; ++row)
            rows[3 * i + static_cast<std::size_t>(row)] = map_from_world[row];
        shapes[i] = {seen.side_m, std::tan(light.radius_radians), static_cast<float>(kMapSide),
                     0.0f};
    }
    program.set("shadow_from_world[0]", std::span<const glm::vec4>(rows));
    program.set("shadow_shape[0]", std::span<const glm::vec4>(shapes));
    constexpr double kGoldenTurn = 0.6180339887498949;
    const double turn = kGoldenTurn * draw_index;
    program.set("shadow_turn", static_cast<float>(turn - std::floor(turn)));
}

}  // namespace patina::render
