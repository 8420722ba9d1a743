// SPDX-License-Identifier: MIT
#include "render/light_uniforms.h"

#include <array>
#include <glm/glm.hpp>
#include <span>

#include "render/geometry_passes.h"

namespace patina::render {
namespace {

/// The way to the light whose terms are shown alone: the first lamp, or the environment's
/// strongest.
glm::vec3 towards_key(const View& view, const glm::vec3& environment_key) {
    if (view.lights.empty()) return -environment_key;
    const Light& key = view.lights.front();
    if (key.kind == Light::Kind::Directional) return -glm::normalize(key.direction_world);
    const glm::vec3 to_light = key.position_world - view.camera.target;
    return glm::length(to_light) > 0.0f ? glm::normalize(to_light) : glm::vec3(0.0f, 1.0f, 0.0f);
}

/// What the floor has of the scene's shadow, where the scene or what of it casts one is another.
Status ready_floor(RendererState& state) {
    const std::vector<DrawItem>& items = state.scene->items;
    std::vector<std::size_t> casting;
    for (std::size_t i = 0; i < items.size(); ++i)
        if (belongs(state.materials.at(items[i].source_material), kShadowCasters))
            casting.push_back(i);
    if (state.shadow.casters == casting) return {};
    std::vector<FloorCaster> casters;
    for (const std::size_t i : casting)
        casters.push_back({&primitive_of(*state.scene, items[i]), items[i].world_from_local});
    Result<GpuGroundShadow> made =
        upload_ground_shadow(ground_shadow(casters, state.scene->bounds_world));
    if (!made) return passed_on(made);
    state.shadow = std::move(*made);
    state.shadow.casters = std::move(casting);
    return {};
}

}  // namespace

Status ready_lights(RendererState& state, const View& view, const std::optional<LampPoint>& point) {
    state.lights.set(view.lights);
    if (Status ready = ready_floor(state); !ready) return ready;
    if (shades_floor(view))
        update_ground_shadow(state.shadow, state.environment->sky,
                             view.environment_rotation_degrees);
    return draw_shadow_maps(state, view, point);
}

void set_lighting(gl::Program& program, const View& view, const Shading& shading,
                  const GpuEnvironment& environment) {
    const glm::mat3 turned = world_from_environment(view.environment_rotation_degrees);
    std::array<glm::vec4, kMostKeys> towards = {};
    std::array<glm::vec4, kMostKeys> irradiance = {};
    for (std::size_t i = 0; i < environment.keys.size(); ++i) {
        const EnvironmentKey& key = environment.keys[i];
        towards[i] = glm::vec4(-(turned * key.direction_map), 0.0f);
        irradiance[i] = glm::vec4(view.environment_intensity * key.irradiance_linear, 0.0f);
    }
    program.set("key_direction", towards_key(view, -glm::vec3(towards[0])));
    program.set("ambient_key_count", static_cast<int>(environment.keys.size()));
    program.set("ambient_key_towards[0]", std::span<const glm::vec4>(towards));
    program.set("ambient_key_irradiance[0]", std::span<const glm::vec4>(irradiance));
    program.set("ambient_radiance", shading.phong.ambient_linear.value_or(
                                        view.environment_intensity * environment.ambient_linear));
    program.set("phong_exponent_override", shading.phong.exponent.value_or(-1.0f));
    program.set("phong_specular_color_override",
                shading.phong.specular_color_linear.value_or(glm::vec3(-1.0f)));
    program.set("phong_specular_strength", shading.phong.specular_strength);
}

}  // namespace patina::render
