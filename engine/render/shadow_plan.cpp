// SPDX-License-Identifier: MIT
#include "render/shadow_plan.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "core/formulae/formulae.h"
#include "core/r2_sequence.h"
#include "render/light_block.h"

namespace patina::render {
namespace {

/// The sun's, as it is seen from the Earth: lamps that are infinitely far away have no size.
constexpr float kFarRadius = 0.00465f;
/// The key light stands for a bright region of the map: as wide as a soft box some steps away.
constexpr float kKeyRadius = 0.03f;
/// A sun nearer to the key light than this is what the key light stands for.
constexpr float kSameLightCosine = 0.966f;  // 15 degrees
/// What a lamp amid the scene sees, to either side.
constexpr float kWidestAngle = 1.309f;  // 75 degrees

void plan_suns(const View& view, const GpuEnvironment& environment, ShadowPlan& plan) {
    const glm::mat3 turned = world_from_environment(view.environment_rotation_degrees);
    for (const EnvironmentSun& sun : environment.suns) {
        if (plan.lights.size() == kMostShadows) break;
        plan.lights.push_back(
            {.towards_world = turned * sun.towards_map, .radius = sun.radius_radians});
    }
    plan.suns = static_cast<int>(plan.lights.size());
}

void plan_key_light(const View& view, const GpuEnvironment& environment, ShadowPlan& plan) {
    const glm::vec3 towards = -(world_from_environment(view.environment_rotation_degrees) *
                                environment.keys.front().direction_map);
    for (int i = 0; i < plan.suns; ++i)
        if (glm::dot(plan.lights[static_cast<std::size_t>(i)].towards_world, towards) >
            kSameLightCosine)
            plan.key = i;
    if (plan.key >= 0 || plan.lights.size() >= kMostShadows) return;
    plan.key = static_cast<int>(plan.lights.size());
    plan.lights.push_back({.towards_world = towards, .radius = kKeyRadius});
}

/// The ball around the scene, which lamps are weighed by.
struct Ball {
    glm::vec3 middle;
    float radius;
};

/// What gets anywhere into a ball of what a lamp sends out ahead, by its range, its cone and the
/// side that it shines to: 0 where none of the ball is lit.
float most_reaching(const Light& light, const Ball& ball) {
    const glm::vec3 way = ball.middle - light.position_world;
    const float distance = glm::length(way);
    const float window =
        formulae::range_window(std::max(distance - ball.radius, 0.0f), light.range);
    const bool all_sides = light.kind != Light::Kind::Spot && light.kind != Light::Kind::Rectangle;
    if (all_sides || distance <= ball.radius) return window;
    const float aside =
        std::acos(std::clamp(glm::dot(way / distance, glm::normalize(light.direction_world)), -1.0f,
                             1.0f)) -
        std::asin(ball.radius / distance);
    const float cosine = std::cos(std::max(aside, 0.0f));
    if (light.kind == Light::Kind::Rectangle) return window * std::max(cosine, 0.0f);
    const glm::vec2 cone = spot_cone(light);
    return window * formulae::cone_window(cosine, cone.x, cone.y);
}

/// How brightly a lamp lights the scene, about its middle.
float strength_of(const Light& light, const Ball& ball) {
    const formulae::Real3 color(light.color_linear.x, light.color_linear.y, light.color_linear.z);
    const float power = light.intensity * formulae::luminance(color);
    if (light.kind == Light::Kind::Directional) return power;
    const glm::vec3 off = light.position_world - ball.middle;
    return power * most_reaching(light, ball) / std::max(glm::dot(off, off), 1e-6f);
}

formulae::Real3 real3(const glm::vec3& v) {
    return {v.x, v.y, v.z};
}
glm::vec3 vector_of(const formulae::Real3& v) {
    return {v.x, v.y, v.z};
}

/// The point of a lamp that has a size from which all of its light comes in a draw: of a rectangle
/// the one that passes/area_lighting.glsl draws directions to, of a sphere where the direction that
/// it draws from the middle of the scene meets the disc across.
glm::vec3 point_of(const Light& light, const LampPoint& point, const glm::vec3& middle) {
    const formulae::Real2 u(point.u.x, point.u.y);
    if (light.kind == Light::Kind::Rectangle) {
        const glm::vec3 across = rectangle_across(light);
        const glm::vec3 ahead = glm::normalize(light.direction_world);
        formulae::SeenRectangle rectangle;
        rectangle.middle = real3(light.position_world);
        rectangle.across = real3(across);
        rectangle.up = real3(glm::cross(ahead, across));
        rectangle.shines = real3(ahead);
        rectangle.half_width = 0.5f * light.width_m;
        rectangle.half_height = 0.5f * light.height_m;
        return vector_of(formulae::rectangle_point(u, rectangle));
    }
    const glm::vec3 to_light = light.position_world - middle;
    const float distance = glm::length(to_light);
    if (distance <= light.radius_m) return light.position_world;
    const glm::vec3 towards = to_light / distance;
    const float sine = light.radius_m / distance;
    const glm::vec3 direction =
        vector_of(formulae::sphere_direction(u, real3(towards), sine * sine));
    return middle + direction * (distance / glm::dot(direction, towards));
}

ShadowLight shadow_light(const Light& light, const glm::vec3& middle,
                         const std::optional<LampPoint>& point) {
    using Kind = Light::Kind;
    const glm::vec3 ahead = glm::normalize(light.direction_world);
    if (light.kind == Kind::Directional) return {.towards_world = -ahead, .radius = kFarRadius};
    ShadowLight result{.is_far = false, .place_world = light.position_world};
    if (light.kind == Kind::Spot || light.kind == Kind::Rectangle) result.ahead_world = ahead;
    if (light.has_size() && point)
        result.place_world = point_of(light, *point, middle);
    else if (light.kind == Kind::Sphere)
        result.radius = light.radius_m;
    else if (light.kind == Kind::Rectangle)
        // Of a disc that is as large.
        result.radius = std::sqrt(light.width_m * light.height_m / glm::pi<float>());
    return result;
}

/// The strongest lamps, in the order of View::lights where they are equal.
void plan_lamps(const View& view, const Ball& ball, const std::optional<LampPoint>& point,
                ShadowPlan& plan) {
    std::vector<std::pair<float, std::size_t>> order;
    for (std::size_t i = 0; i < view.lights.size(); ++i)
        if (const float strength = strength_of(view.lights[i], ball); strength > 0.0f)
            order.emplace_back(strength, i);
    std::stable_sort(order.begin(), order.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    for (const auto& [strength, i] : order) {
        if (plan.lights.size() == kMostShadows) return;
        plan.lamps[plan.lights.size()] = static_cast<int>(i);
        plan.lights.push_back(shadow_light(view.lights[i], ball.middle, point));
    }
}

glm::vec3 any_across(const glm::vec3& direction) {
    const glm::vec3 up =
        std::abs(direction.y) < 0.9f ? glm::vec3(0.0f, 1.0f, 0.0f) : glm::vec3(1.0f, 0.0f, 0.0f);
    return glm::normalize(glm::cross(up, direction));
}

glm::mat4 light_from_world(const glm::vec3& place, const glm::vec3& towards_light) {
    return glm::lookAt(place, place - towards_light,
                       glm::cross(towards_light, any_across(towards_light)));
}

ShadowView view_from_place(const ShadowLight& light, const glm::vec3& middle, float radius) {
    const glm::vec3 off = light.place_world - middle;
    const float distance = glm::length(off);
    const bool amid = distance < radius / std::sin(kWidestAngle);
    glm::vec3 towards_light = distance > 1e-4f * radius ? off / distance : glm::vec3(0, 1, 0);
    if (amid && light.ahead_world != glm::vec3(0.0f)) towards_light = -light.ahead_world;
    const float angle = amid ? kWidestAngle : std::asin(radius / distance);
    const float near_m = std::max(distance - radius, 0.01f * radius);
    const float far_m = distance + radius;
    return {.clip_from_world = glm::perspective(2.0f * angle, 1.0f, near_m, far_m) *
                               light_from_world(light.place_world, towards_light),
            .across = 2.0f * std::tan(angle),
            .near_m = near_m,
            .far_m = far_m};
}

}  // namespace

LampPoint lamp_point(int index) {
    const R2Point point = r2_point(index);
    return {glm::vec2(point.u, point.v)};
}

ShadowPlan shadow_plan(const View& view, const GpuEnvironment& environment, const Bounds& bounds,
                       const std::optional<LampPoint>& point) {
    ShadowPlan plan;
    if (!view.shadows) return plan;
    if (shows_pbr(view)) plan_suns(view, environment, plan);
    if (shows_traditional(view)) plan_key_light(view, environment, plan);
    plan_lamps(view, {bounds.center(), bounds.radius()}, point, plan);
    return plan;
}

ShadowView shadow_view(const Bounds& bounds, const ShadowLight& light) {
    const glm::vec3 middle = bounds.center();
    // A little more than the ball around the scene, so that taps at its rim find nothing.
    const float radius = std::max(1.05f * bounds.radius(), 1e-6f);
    if (!light.is_far) return view_from_place(light, middle, radius);
    return {.clip_from_world =
                glm::ortho(-radius, radius, -radius, radius, 0.0f, 2.0f * radius) *
                light_from_world(middle + radius * light.towards_world, light.towards_world),
            .across = 2.0f * radius,
            .near_m = 0.0f,
            .far_m = 2.0f * radius};
}

}  // namespace patina::render
