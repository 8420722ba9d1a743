// SPDX-License-Identifier: MIT
#include "render/camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "render/bearing.h"

namespace patina::render {
namespace {

constexpr float kFramingMargin = 1.1f;
constexpr float kPoleDegrees = 89.0f;

/// Where the camera stands as seen from its target: yaw about +Y from +Z towards +X, and pitch up.
struct Angles {
    float yaw_degrees;
    float pitch_degrees;
};

Angles angles_of(ViewDirection direction) {
    switch (direction) {
        case ViewDirection::ThreeQuarter:
            return {30.0f, 14.0f};
        case ViewDirection::Front:
            return {0.0f, 0.0f};
        case ViewDirection::Back:
            return {180.0f, 0.0f};
        case ViewDirection::Left:
            return {-90.0f, 0.0f};
        case ViewDirection::Right:
            return {90.0f, 0.0f};
        case ViewDirection::Top:
            return {0.0f, kPoleDegrees};
        case ViewDirection::Bottom:
            return {0.0f, -kPoleDegrees};
    }
    return {};
}

glm::vec3 direction_from(const Angles& angles) {
    return bearing(angles.yaw_degrees, angles.pitch_degrees);
}

std::array<glm::vec3, 8> corners(const Bounds& bounds) {
    std::array<glm::vec3, 8> result;
    for (unsigned i = 0; i < 8; ++i)
        result[i] = {(i & 1u) != 0 ? bounds.high.x : bounds.low.x,
                     (i & 2u) != 0 ? bounds.high.y : bounds.low.y,
                     (i & 4u) != 0 ? bounds.high.z : bounds.low.z};
    return result;
}

Bounds or_unit_ball(const Bounds& bounds) {
    if (!bounds.empty() && bounds.radius() > 0.0f) return bounds;
    const glm::vec3 center = bounds.empty() ? glm::vec3(0.0f) : bounds.center();
    return {.low = center - 1.0f, .high = center + 1.0f};
}

float tangent_of_half_fov(const Camera& camera) {
    return std::tan(0.5f * glm::radians(std::clamp(camera.fov_y_degrees, 1.0f, 160.0f)));
}

/// Metres from bottom to top of the picture in the plane of the target.
float height_at_target(const Camera& camera) {
    if (camera.orthographic_height > 0.0f) return camera.orthographic_height;
    return 2.0f * glm::distance(camera.position, camera.target) * tangent_of_half_fov(camera);
}

/// The direction of an axis; a node that a file scales by nothing has none.
glm::vec3 unit_or(const glm::vec4& axis, const glm::vec3& otherwise) {
    const float length = glm::length(glm::vec3(axis));
    return length > 0.0f && std::isfinite(length) ? glm::vec3(axis) / length : otherwise;
}

}  // namespace

Camera framed_from(const Camera& camera, const Bounds& bounds, float aspect) {
    Camera result = camera;
    result.target = or_unit_ball(bounds).center();
    result.position += result.target - camera.target;
    return framed_around(result, bounds, aspect);
}

Camera framed_around(const Camera& camera, const Bounds& bounds, float aspect) {
    const Bounds shown = or_unit_ball(bounds);
    Camera result = camera;
    const glm::vec3 offset = camera.position - camera.target;
    const glm::vec3 back = glm::dot(offset, offset) > 0.0f
                               ? glm::normalize(offset)
                               : direction_from(angles_of(ViewDirection::ThreeQuarter));
    result.position = result.target + back;

    // The least distance at which each corner is inside the pyramid of the view.
    const glm::mat3 rotation(view_from_world(result));
    const float tangent = tangent_of_half_fov(camera) / kFramingMargin;
    float distance = 0.0f;
    float half_height = 0.0f;
    for (const glm::vec3& corner : corners(shown)) {
        const glm::vec3 seen = rotation * (corner - result.target);
        const float reach = std::max(std::abs(seen.y), std::abs(seen.x) / aspect);
        distance = std::max(distance, reach / tangent + seen.z);
        half_height = std::max(half_height, reach);
    }
    result.position = result.target + back * distance;
    if (camera.orthographic_height > 0.0f)
        result.orthographic_height = 2.0f * half_height * kFramingMargin;
    return result;
}

Camera framed(const Bounds& bounds, float aspect, ViewDirection direction, float fov_y_degrees) {
    Camera camera;
    camera.target = glm::vec3(0.0f);
    camera.position = direction_from(angles_of(direction));
    camera.fov_y_degrees = fov_y_degrees;
    return framed_from(camera, bounds, aspect);
}

Camera framed_from_direction(const Camera& camera, const Bounds& bounds, float aspect,
                             ViewDirection direction) {
    Camera turned = framed(bounds, aspect, direction, camera.fov_y_degrees);
    turned.orthographic_height = camera.orthographic_height;
    return framed_from(turned, bounds, aspect);
}

Camera with_fov(const Camera& camera, float fov_y_degrees) {
    Camera result = camera;
    result.fov_y_degrees = fov_y_degrees;
    const float nearer = tangent_of_half_fov(camera) / tangent_of_half_fov(result);
    result.position = camera.target + (camera.position - camera.target) * nearer;
    return result;
}

Camera with_other_projection(const Camera& camera) {
    Camera result = camera;
    if (camera.orthographic_height == 0.0f) {
        result.orthographic_height = height_at_target(camera);
        return result;
    }
    result.orthographic_height = 0.0f;
    const float farther = camera.orthographic_height / height_at_target(result);
    result.position = camera.target + (camera.position - camera.target) * farther;
    return result;
}

Camera camera_of(const SceneCamera& camera, const Bounds& bounds) {
    Camera result;
    result.position = glm::vec3(camera.world_from_camera[3]);
    const glm::vec3 forward = -unit_or(camera.world_from_camera[2], {0.0f, 0.0f, 1.0f});
    const glm::vec3 middle = or_unit_ball(bounds).center();
    const float along = glm::dot(middle - result.position, forward);
    result.target = result.position + forward * (along > 0.0f ? along : 1.0f);
    result.up = unit_or(camera.world_from_camera[1], {0.0f, 1.0f, 0.0f});
    result.fov_y_degrees = std::clamp(glm::degrees(camera.fov_y_radians), 1.0f, 160.0f);
    result.orthographic_height = camera.orthographic_height;
    return result;
}

Camera orbited(const Camera& camera, float yaw_degrees, float pitch_degrees) {
    const glm::vec3 offset = camera.position - camera.target;
    const float distance = glm::length(offset);
    if (distance == 0.0f) return camera;
    const float pitch = glm::degrees(std::asin(std::clamp(offset.y / distance, -1.0f, 1.0f)));
    const float yaw = glm::degrees(std::atan2(offset.x, offset.z));
    Camera result = camera;
    result.up = glm::vec3(0.0f, 1.0f, 0.0f);
    result.position =
        camera.target +
        distance * direction_from({yaw + yaw_degrees,
                                   std::clamp(pitch + pitch_degrees, -kPoleDegrees, kPoleDegrees)});
    return result;
}

Camera turned(const Camera& camera, float degrees) {
    const glm::mat3 turn(
        glm::rotate(glm::mat4(1.0f), glm::radians(degrees), glm::vec3(0.0f, 1.0f, 0.0f)));
    Camera result = camera;
    result.position = camera.target + turn * (camera.position - camera.target);
    result.up = turn * camera.up;
    return result;
}

Camera panned(const Camera& camera, float right, float up) {
    const glm::mat3 world_from_view = glm::transpose(glm::mat3(view_from_world(camera)));
    const glm::vec3 shift =
        -height_at_target(camera) * (right * world_from_view[0] + up * world_from_view[1]);
    Camera result = camera;
    result.position += shift;
    result.target += shift;
    return result;
}

Camera dollied(const Camera& camera, float steps) {
    const float factor = std::exp2(-steps);
    Camera result = camera;
    result.position = camera.target + (camera.position - camera.target) * factor;
    result.orthographic_height = camera.orthographic_height * factor;
    return result;
}

glm::mat4 view_from_world(const Camera& camera) {
    const glm::vec3 forward = camera.target - camera.position;
    // A camera that looks along `up` has no sideways: any other axis will do.
    const bool degenerate = glm::length(glm::cross(forward, camera.up)) <=
                            1e-6f * glm::length(forward) * glm::length(camera.up);
    return glm::lookAt(camera.position, camera.target,
                       degenerate ? glm::vec3(0.0f, 0.0f, -1.0f) : camera.up);
}

DepthRange depth_range(const Camera& camera, const Bounds& bounds) {
    const glm::mat4 view = view_from_world(camera);
    float nearest = 1e30f;
    float farthest = -1e30f;
    for (const glm::vec3& corner : corners(or_unit_ball(bounds))) {
        const float depth = -(view * glm::vec4(corner, 1.0f)).z;
        nearest = std::min(nearest, depth);
        farthest = std::max(farthest, depth);
    }
    // A flat scene that faces the camera has no depth of its own, but must not lie on the planes.
    const float slack = std::max(0.01f * (farthest - nearest), 1e-3f * std::abs(farthest));
    const float far_m = std::max(farthest + slack, 1e-4f);
    // From inside the scene, a ten-thousandth of its size is as near as a 32-bit depth keeps.
    return {.near_m = std::max(nearest - slack, 1e-4f * far_m), .far_m = far_m};
}

float pixels_per_metre(const Camera& camera, int picture_height, float distance_m) {
    const float height_m = camera.orthographic_height > 0.0f
                               ? camera.orthographic_height
                               : 2.0f * tangent_of_half_fov(camera) * std::max(distance_m, 1e-6f);
    return static_cast<float>(picture_height) / height_m;
}

glm::mat4 clip_from_view(const Camera& camera, float aspect, const DepthRange& range) {
    if (camera.orthographic_height > 0.0f) {
        const float half_height = 0.5f * camera.orthographic_height;
        const float half_width = half_height * aspect;
        return glm::ortho(-half_width, half_width, -half_height, half_height, range.near_m,
                          range.far_m);
    }
    return glm::perspective(2.0f * std::atan(tangent_of_half_fov(camera)), aspect, range.near_m,
                            range.far_m);
}

}  // namespace patina::render
