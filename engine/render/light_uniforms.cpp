// SPDX-License-Identifier: MIT
#include "render/light_uniforms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace patina::render {
namespace {

constexpr std::size_t kLightSlots = kMaxLights;

struct LightArrays {
    std::array<glm::vec4, kLightSlots> position = {};
    std::array<glm::vec4, kLightSlots> color = {};
    std::array<glm::vec4, kLightSlots> direction = {};
    std::array<float, kLightSlots> cone_offset = {};
};

/// Laid out as passes/lights.glsl says; the cone as KHR_lights_punctual's sample code.
void fill(LightArrays& arrays, std::size_t i, const Light& light) {
    const float inner = std::cos(light.inner_cone_radians);
    const float outer = std::cos(light.outer_cone_radians);
    const float scale = 1.0f / std::max(inner - outer, 0.001f);
    arrays.position[i] = {light.position_world, static_cast<float>(light.kind)};
    arrays.color[i] = {light.color_linear * light.intensity, light.range};
    arrays.direction[i] = {glm::normalize(light.direction_world), scale};
    arrays.cone_offset[i] = -outer * scale;
}

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

glm::vec3 turned_key_direction(const View& view, const GpuEnvironment& environment) {
    return glm::transpose(environment_from_world(view.environment_rotation_degrees)) *
           environment.key_direction_environment;
}

void set_lighting(gl::Program& program, const View& view, const Shading& shading,
                  const GpuEnvironment& environment) {
    LightArrays arrays;
    const std::size_t count = std::min(view.lights.size(), kLightSlots);
    for (std::size_t i = 0; i < count; ++i) fill(arrays, i, view.lights[i]);
    program.set("light_count", static_cast<int>(count));
    program.set("light_position[0]", std::span<const glm::vec4>(arrays.position));
    program.set("light_color[0]", std::span<const glm::vec4>(arrays.color));
    program.set("light_direction[0]", std::span<const glm::vec4>(arrays.direction));
    program.set("light_cone_offset[0]", std::span<const float>(arrays.cone_offset));

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
}

}  // namespace patina::render
