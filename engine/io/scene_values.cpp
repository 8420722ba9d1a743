// SPDX-License-Identifier: MIT
#include "io/scene_values.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <span>

namespace patina::io {
namespace {

constexpr float kPi = 3.14159265f;

/// Leaves `to` alone where the file has no such numbers.
void copy_numbers(const std::vector<double>& from, std::span<float> to) {
    for (std::size_t i = 0; i < std::min(from.size(), to.size()); ++i)
        to[i] = static_cast<float>(from[i]);
}

float at_least_0(double value) {
    return std::max(0.0f, static_cast<float>(value));
}

}  // namespace

glm::mat4 parent_from_local(const tinygltf::Node& node) {
    if (!node.matrix.empty()) {
        glm::mat4 matrix(1.0f);
        copy_numbers(node.matrix, std::span(&matrix[0][0], 16));
        return matrix;
    }
    glm::vec3 translation(0.0f);
    glm::vec3 scale(1.0f);
    glm::vec4 rotation(0.0f, 0.0f, 0.0f, 1.0f);
    copy_numbers(node.translation, std::span(&translation.x, 3));
    copy_numbers(node.rotation, std::span(&rotation.x, 4));
    copy_numbers(node.scale, std::span(&scale.x, 3));
    const float length = glm::length(rotation);
    // A quaternion of zeros turns nothing.
    rotation = length > 0.0f && std::isfinite(length) ? rotation / length : glm::vec4(0, 0, 0, 1);
    const glm::quat turn(rotation.w, rotation.x, rotation.y, rotation.z);
    return glm::scale(glm::translate(glm::mat4(1.0f), translation) * glm::mat4_cast(turn), scale);
}

SceneCamera camera_of(const tinygltf::Camera& camera) {
    SceneCamera view;
    view.name = camera.name;
    if (camera.type == "orthographic") {
        const auto half_height = static_cast<float>(std::abs(camera.orthographic.ymag));
        view.orthographic_height = half_height == 0.0f ? 2.0f : 2.0f * half_height;
    } else {
        const auto fov_y = static_cast<float>(camera.perspective.yfov);
        if (fov_y > 0.0f && fov_y < kPi) view.fov_y_radians = fov_y;
    }
    return view;
}

Light light_of(const tinygltf::Light& source) {
    Light light;
    light.name = source.name;
    if (source.type == "point") light.kind = Light::Kind::Point;
    if (source.type == "spot") light.kind = Light::Kind::Spot;
    copy_numbers(source.color, std::span(&light.color_linear.x, 3));
    light.color_linear = glm::clamp(light.color_linear, 0.0f, 1.0f);
    light.intensity = at_least_0(source.intensity);
    light.range = at_least_0(source.range);
    light.outer_cone_radians =
        std::clamp(static_cast<float>(source.spot.outerConeAngle), 1e-3f, kPi / 2.0f);
    light.inner_cone_radians =
        std::clamp(static_cast<float>(source.spot.innerConeAngle), 0.0f, light.outer_cone_radians);
    return light;
}

std::vector<float> as_floats(const std::vector<double>& numbers) {
    std::vector<float> floats(numbers.size());
    copy_numbers(numbers, floats);
    return floats;
}

}  // namespace patina::io
