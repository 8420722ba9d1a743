// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>

#include "core/parallel.h"
#include "render/bearing.h"
#include "render/clear_sky.h"
#include "render/environment.h"
#include "render/radiance_map.h"

namespace patina::render {
namespace {

/// A rectangular light that faces the middle. Extents are tangents of half angles.
struct SoftBox {
    glm::vec3 direction;
    glm::vec2 half_extent;
    float corner;   ///< radius of the corners, as an extent
    float feather;  ///< how soft the edge is, as an extent
    glm::vec3 radiance;
    float edge_share;  ///< radiance at the edge as a share of that in the middle
};

float rounded_box_distance(const glm::vec2& point, const glm::vec2& half_extent, float corner) {
    const glm::vec2 beyond = glm::abs(point) - half_extent + corner;
    return glm::length(glm::max(beyond, 0.0f)) + std::min(std::max(beyond.x, beyond.y), 0.0f) -
           corner;
}

glm::vec3 radiance_of(const SoftBox& box, const glm::vec3& direction) {
    const float along = glm::dot(direction, box.direction);
    if (along <= 0.05f) return glm::vec3(0.0f);
    const glm::vec3 right = glm::normalize(glm::cross(glm::vec3(0.0f, 1.0f, 0.0f), box.direction));
    const glm::vec3 up = glm::cross(box.direction, right);
    const glm::vec2 point(glm::dot(direction, right) / along, glm::dot(direction, up) / along);
    const float distance = rounded_box_distance(point, box.half_extent, box.corner);
    const float cover = 1.0f - glm::smoothstep(-box.feather, box.feather, distance);
    const glm::vec2 relative = point / box.half_extent;
    const float share =
        glm::mix(1.0f, box.edge_share, std::min(1.0f, 0.5f * glm::dot(relative, relative)));
    return box.radiance * (cover * share);
}

/// Seen from the three-quarter camera (yaw 30): a large key light above its left shoulder, a tall
/// cool strip for the rim at the far right, a wide weak fill at the right, and a light overhead.
const std::array<SoftBox, 5>& studio_boxes() {
    static const std::array<SoftBox, 5> boxes = {{
        {bearing(-22.0f, 44.0f), {0.55f, 0.46f}, 0.06f, 0.025f, {5.0f, 4.8f, 4.5f}, 0.62f},
        {bearing(112.0f, 16.0f), {0.2f, 0.85f}, 0.05f, 0.03f, {2.6f, 2.8f, 3.1f}, 0.7f},
        {bearing(-112.0f, 22.0f), {0.16f, 0.75f}, 0.05f, 0.03f, {3.2f, 3.3f, 3.5f}, 0.7f},
        {bearing(64.0f, 12.0f), {0.5f, 0.4f}, 0.2f, 0.25f, {0.34f, 0.36f, 0.4f}, 0.5f},
        {bearing(190.0f, 62.0f), {0.8f, 0.3f}, 0.08f, 0.04f, {1.9f, 1.9f, 1.95f}, 0.7f},
    }};
    return boxes;
}

glm::vec3 studio_radiance(const glm::vec3& direction) {
    // The room: a dark ceiling, walls a little lighter towards a grey floor lit by the boxes.
    const float height = direction.y;
    const glm::vec3 ceiling(0.03f, 0.031f, 0.034f);
    const glm::vec3 wall(0.075f, 0.076f, 0.08f);
    const glm::vec3 floor(0.105f, 0.104f, 0.102f);
    glm::vec3 radiance = height > 0.0f
                             ? glm::mix(wall, ceiling, glm::smoothstep(0.0f, 0.8f, height))
                             : glm::mix(wall, floor, glm::smoothstep(0.0f, 0.5f, -height));
    for (const SoftBox& box : studio_boxes()) radiance += radiance_of(box, direction);
    return radiance;
}

glm::vec3 white_radiance(const glm::vec3& direction) {
    (void)direction;
    return glm::vec3(1.0f);
}

using RadianceFunction = std::function<glm::vec3(const glm::vec3& direction)>;

/// Empty for an unknown name.
RadianceFunction radiance_function(std::string_view id, float sun_elevation_degrees) {
    if (id == "studio") return studio_radiance;
    if (id == kSkyEnvironment) {
        const ClearSky sky(sun_elevation_degrees);
        return [sky](const glm::vec3& direction) { return sky.radiance(direction); };
    }
    if (id == "white") return white_radiance;
    return nullptr;
}

/// The mean of a texel over points x points directions.
glm::vec3 texel_mean(const RadianceFunction& radiance, int x, int y, int width, int height) {
    constexpr int kPoints = 3;
    glm::vec3 sum(0.0f);
    for (int j = 0; j < kPoints; ++j)
        for (int i = 0; i < kPoints; ++i) {
            const float u = (float(x) + (float(i) + 0.5f) / kPoints) / float(width);
            const float v = (float(y) + (float(j) + 0.5f) / kPoints) / float(height);
            sum += radiance(direction_at(u, v));
        }
    return sum / float(kPoints * kPoints);
}

}  // namespace

bool is_builtin_environment(std::string_view name) {
    return std::any_of(kBuiltinEnvironments.begin(), kBuiltinEnvironments.end(),
                       [&](const BuiltinEnvironment& entry) { return entry.id == name; });
}

Result<Image> builtin_environment(std::string_view id, int height, float sun_elevation_degrees) {
    const RadianceFunction radiance = radiance_function(id, sun_elevation_degrees);
    if (!radiance) {
        std::array<std::string_view, kBuiltinEnvironments.size()> ids;
        std::transform(kBuiltinEnvironments.begin(), kBuiltinEnvironments.end(), ids.begin(),
                       [](const BuiltinEnvironment& entry) { return entry.id; });
        return failure(
            "no built-in environment is called \"{}\": give one of {}, or a .hdr or .exr",
            quoted_for_message(id), fmt::join(ids, ", "));
    }
    Image image{
        .width = 2 * height, .height = height, .channels = 3, .type = SampleType::F32, .data = {}};
    image.data.resize(image.row_bytes() * std::size_t(height));
    parallel_for(0, height, 4, [&](std::int64_t first, std::int64_t last) {
        for (int y = int(first); y < int(last); ++y)
            for (int x = 0; x < image.width; ++x) {
                const glm::vec3 mean = texel_mean(radiance, x, y, image.width, height);
                const std::size_t texel =
                    std::size_t(y) * std::size_t(image.width) + std::size_t(x);
                std::memcpy(image.data.data() + texel * sizeof mean, &mean, sizeof mean);
            }
    });
    return image;
}

}  // namespace patina::render
