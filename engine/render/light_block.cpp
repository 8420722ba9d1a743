// SPDX-License-Identifier: MIT
#include "render/light_block.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/gtc/constants.hpp>

namespace patina::render {
namespace {

constexpr int kLightBlockSlot = 1;

/// Laid out as `Lamp` in passes/lights.glsl (std140: everything is four floats).
struct Lamp {
    glm::vec4 position_kind;
    glm::vec4 color_range;
    glm::vec4 direction_size;
    glm::vec4 across_size;
};
using Lamps = std::array<Lamp, kMaxLights>;
// What every OpenGL 4.1 takes in one block.
static_assert(sizeof(Lamps) <= 16384);
constexpr Lamps kNoLamps = {};

/// What the last numbers of a lamp are.
glm::vec2 sizes_of(const Light& light) {
    switch (light.kind) {
        case Light::Kind::Directional:
        case Light::Kind::Point:
            return {};
        case Light::Kind::Spot:
            return spot_cone(light);
        case Light::Kind::Sphere:
            return {light.radius_m, 0.0f};
        case Light::Kind::Rectangle:
            return 0.5f * glm::vec2(light.width_m, light.height_m);
    }
    return {};
}

/// Radiance where a lamp has a size, so that from far away its light is that of its intensity.
float brightness_of(const Light& light) {
    if (light.kind == Light::Kind::Sphere)
        return light.intensity / (glm::pi<float>() * light.radius_m * light.radius_m);
    if (light.kind == Light::Kind::Rectangle)
        return light.intensity / (light.width_m * light.height_m);
    return light.intensity;
}

Lamp lamp_of(const Light& light) {
    const glm::vec2 sizes = sizes_of(light);
    return {.position_kind = {light.position_world, static_cast<float>(light.kind)},
            .color_range = {light.color_linear * brightness_of(light), light.range},
            .direction_size = {glm::normalize(light.direction_world), sizes.x},
            .across_size = {rectangle_across(light), sizes.y}};
}

}  // namespace

glm::vec3 rectangle_across(const Light& light) {
    const glm::vec3 direction = glm::normalize(light.direction_world);
    const glm::vec3 sideways = glm::cross(glm::vec3(0.0f, 1.0f, 0.0f), direction);
    // Straight up or down every way lies level: +X then.
    const glm::vec3 level =
        glm::length(sideways) > 1e-4f ? glm::normalize(sideways) : glm::vec3(1.0f, 0.0f, 0.0f);
    return std::cos(light.turn_radians) * level +
           std::sin(light.turn_radians) * glm::cross(direction, level);
}

glm::vec2 spot_cone(const Light& light) {
    const float outer = std::cos(light.outer_cone_radians);
    const float scale = 1.0f / std::max(std::cos(light.inner_cone_radians) - outer, 0.001f);
    return {scale, -outer * scale};
}

LightBlock::LightBlock()
    : buffer_(gl::Buffer::make({.label = "lights",
                                .kind = gl::BufferKind::Uniforms,
                                .use = gl::BufferUse::Dynamic,
                                .content = std::as_bytes(std::span(kNoLamps))})) {}

void LightBlock::set(const std::vector<Light>& lights) {
    if (lights == lights_) return;
    Lamps lamps = {};
    const std::size_t count = std::min(lights.size(), lamps.size());
    std::transform(lights.begin(), lights.begin() + static_cast<std::ptrdiff_t>(count),
                   lamps.begin(), lamp_of);
    buffer_.write(std::as_bytes(std::span(lamps)));
    lights_ = lights;
}

bool LightBlock::any_has_size() const {
    return std::any_of(lights_.begin(), lights_.end(), std::mem_fn(&Light::has_size));
}

void LightBlock::bind(gl::Pass& pass, gl::Program& program) const {
    program.set_block("LightBlock", kLightBlockSlot);
    pass.bind_block(kLightBlockSlot, buffer_);
    program.set("light_count", static_cast<int>(std::min(lights_.size(), std::size_t{kMaxLights})));
}

}  // namespace patina::render
