// SPDX-License-Identifier: MIT
#include "render/light_uniforms.h"

#include <glm/glm.hpp>

#include "render/renderer_state.h"

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

}  // namespace

Status ready_lights(RendererState& state, const View& view, const std::optional<LampPoint>& point) {
    state.lights.set(view.lights);
    return draw_shadow_maps(state, view, point);
}

glm::vec3 turned_key_direction(const View& view, const GpuEnvironment& environment) {
    return glm::transpose(environment_from_world(view.environment_rotation_degrees)) *
           environment.key_direction_environment;
}

void set_lighting(gl::Program& program, const View& view, const Shading& shading,
                  const GpuEnvironment& environment) {
    const glm::vec3 key = turned_key_direction(view, environment);
    program.set("key_direction", towards_key(view, key));
    program.set("ambient_key_direction", -key);
    program.set("ambient_key_irradiance",
                view.environment_intensity * environment.key_irradiance_linear);
    program.set("ambient_radiance", shading.phong.ambient_linear.value_or(
                                        view.environment_intensity * environment.ambient_linear));
    program.set("phong_exponent_override", shading.phong.exponent.value_or(-1.0f));
    program.set("phong_specular_color_override",
                shading.phong.specular_color_linear.value_or(glm::vec3(-1.0f)));
    program.set("phong_specular_strength", shading.phong.specular_strength);
}

}  // namespace patina::render
