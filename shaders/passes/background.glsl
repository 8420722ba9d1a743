// SPDX-License-Identifier: MIT
// What stands behind the surfaces.

#include "passes/camera.glsl"
#include "passes/environment.glsl"
#include "passes/lights.glsl"
#include "passes/output.glsl"
#include "passes/shadows.glsl"

// Constants: BACKGROUND_KIND, one of render::Background::Kind as below; those of shadows.glsl.

uniform vec3 background_color;         // linear, on the screen
uniform samplerCube environment_sharp;  // the map itself, in its first level

uniform vec3 floor_center;   // the middle of the scene, on the floor
uniform float floor_radius;  // of the scene
uniform vec3 scene_low;      // the box around it
uniform vec3 scene_high;
uniform sampler2D ground_shadow;     // what reaches the floor of the environment without its suns
uniform float ground_shadow_extent;  // metres from the middle to the edge; 0: none
uniform int floor_draws;             // that the shadows of lights on the floor are the mean of

const int BACKGROUND_STUDIO = 0;
const int BACKGROUND_ENVIRONMENT = 1;
const int BACKGROUND_BLURRED = 2;
const int BACKGROUND_COLOR = 3;
const int BACKGROUND_TRANSPARENT = 4;

const float BLURRED_ROUGHNESS = 0.35;

float contact_light(vec3 point) {
    if (ground_shadow_extent <= 0.0) return 1.0;
    vec2 uv = (point.xz - floor_center.xz) / ground_shadow_extent * 0.5 + 0.5;
    return texture(ground_shadow, uv).r;
}

/// The light that a map holds the shadow of, on the floor: irradiance, and the way to it.
struct FloorLight {
    vec3 irradiance;
    vec3 towards;
};
FloorLight floor_light(int map, vec3 point) {
    FloorLight light = FloorLight(vec3(0.0), vec3(0.0, 1.0, 0.0));
    int lamp = int(shadow_lamp[map]);
    if (lamp >= 0) {
        Incident incident = incident_light(lamps[lamp], point);
        light = FloorLight(incident.irradiance, incident.direction);
    } else if (map < sun_shadow_count || (map == key_shadow && sun_count > 0)) {
        // The key light of Phong is the strongest sun, or in the light that ground_shadow weighs.
        int sun = map < sun_shadow_count ? map : 0;
        light = FloorLight(environment_intensity * sun_irradiance[sun].rgb,
                           sun_towards[sun].xyz * environment_from_world);
    }
    light.irradiance *= max(light.towards.y, 0.0);
    return light;
}

/// Whether the scene may stand between a point and the light of a map: whether the way to the light
/// meets the box around the scene, which is grown by what the edge of a shadow is wide.
bool scene_between(int map, vec3 point, vec3 towards) {
    float far = length(point - floor_center) + 2.0 * floor_radius;
    float edge = shadow_shape[map].y * (shadow_shape[map].w > 0.5 ? 1.0 : far);
    vec3 margin = vec3(edge + 0.02 * floor_radius);
    vec3 low = (scene_low - margin - point) / towards;
    vec3 high = (scene_high + margin - point) / towards;
    vec3 enters = min(low, high);
    vec3 leaves = max(low, high);
    return max(max(enters.x, enters.y), enters.z) <= min(min(leaves.x, leaves.y), leaves.z);
}

/// What is left of the light of a point of the floor, of all that would reach it without the model.
/// Lights that cast no shadow are left out of both.
vec3 floor_shadow(vec3 point, vec2 pixel) {
    if (ground_shadow_extent <= 0.0) return vec3(1.0);
    float contact = contact_light(point);
    if (SHADOWS == 0) return vec3(contact);
    vec3 up = vec3(0.0, 1.0, 0.0);
    vec3 whole = PI * environment_diffuse(up);
    vec3 left = whole * contact;
    for (int map = 0; map < shadow_count; ++map) {
        FloorLight light = floor_light(map, point);
        int draws = scene_between(map, point, light.towards) ? floor_draws : 0;
        float reaching = 0.0;
        for (int i = 0; i < draws; ++i)
            reaching += light_reaching(map, point, up, light.towards, pixel + 7.0 * float(i));
        whole += light.irradiance;
        left += light.irradiance * (draws > 0 ? reaching / float(draws) : 1.0);
    }
    // A colour that no light has is shaded as the sky's is.
    vec3 least = vec3(1e-3 * luminance(whole) + 1e-6);
    return (left + least * contact) / (whole + least);
}

/// Where a ray meets the floor, before the near plane maybe; w: 1, or 0 where it does not.
vec4 floor_point(Ray ray) {
    bool meets = ray.direction.y < 0.0 && camera_position.y > floor_center.y;
    float travel = (floor_center.y - ray.origin.y) / min(ray.direction.y, -1e-4);
    return vec4(ray.origin + travel * ray.direction, meets ? 1.0 : 0.0);
}

/// A photographer's backdrop: a floor that rises into a wall, lit in the middle, dark at the rim.
/// Linear light on the screen: it stays as it is when exposure changes.
vec3 studio_backdrop(vec2 pixel) {
    Ray ray = ray_through(pixel);
    vec3 wall = mix(vec3(0.036, 0.036, 0.037), vec3(0.0135, 0.0138, 0.0148),
                    smoothstep(-0.12, 0.4, ray.direction.y));
    vec3 backdrop = wall;
    vec4 point = floor_point(ray);
    if (point.w > 0.0) {
        float distance_in_radii = length(point.xz - floor_center.xz) / floor_radius;
        vec3 floor_tone = vec3(0.064) * floor_shadow(point.xyz, pixel);
        backdrop = mix(floor_tone, wall, smoothstep(1.0, 9.0, distance_in_radii));
    }
    vec2 from_middle = (pixel / picture_size - vec2(0.5, 0.45)) * vec2(1.0, 0.8);
    return backdrop * (1.0 - 1.3 * dot(from_middle, from_middle));
}

/// The ground is what is there of the map, in the shadow of the model.
vec3 environment_backdrop(vec2 pixel) {
    Ray ray = ray_through(pixel);
    vec3 radiance = BACKGROUND_KIND == BACKGROUND_ENVIRONMENT
                        ? environment_intensity *
                              textureLod(environment_sharp, environment_from_world * ray.direction, 0.0)
                                  .rgb
                        : environment_blurred(ray.direction, BLURRED_ROUGHNESS);
    vec4 point = floor_point(ray);
    return point.w > 0.0 ? radiance * floor_shadow(point.xyz, pixel) : radiance;
}

bool background_is_light() {
    return BACKGROUND_KIND == BACKGROUND_ENVIRONMENT || BACKGROUND_KIND == BACKGROUND_BLURRED;
}

/// Backgrounds that are not light of the scene, in linear light on the screen.
vec4 background_display(vec2 pixel) {
    if (BACKGROUND_KIND == BACKGROUND_STUDIO) return vec4(studio_backdrop(pixel), 1.0);
    if (BACKGROUND_KIND == BACKGROUND_COLOR) return vec4(background_color, 1.0);
    return vec4(0.0);
}

vec4 background_output(vec2 pixel) {
    if (background_is_light()) return radiance_output(environment_backdrop(pixel), 1.0, pixel);
    vec4 color = background_display(pixel);
    return display_output(color.rgb, color.a, pixel);
}
