// SPDX-License-Identifier: MIT
// What stands behind the surfaces.

#include "passes/camera.glsl"
#include "passes/environment.glsl"
#include "passes/output.glsl"

// Constant: BACKGROUND_KIND, one of render::Background::Kind as below.

uniform vec3 background_color;  // linear, on the screen

uniform vec3 floor_center;   // the middle of the scene, on the floor
uniform float floor_radius;  // of the scene
uniform sampler2D ground_shadow;
uniform float ground_shadow_extent;  // metres from the middle to the edge; 0: none

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

/// A photographer's backdrop: a floor that rises into a wall, lit in the middle, dark at the rim.
/// Linear light on the screen: it stays as it is when exposure changes.
vec3 studio_backdrop(vec2 pixel) {
    Ray ray = ray_through(pixel);
    vec3 wall = mix(vec3(0.036, 0.036, 0.037), vec3(0.0135, 0.0138, 0.0148),
                    smoothstep(-0.12, 0.4, ray.direction.y));
    float height = floor_center.y - ray.origin.y;
    vec3 backdrop = wall;
    // Every ray that goes down from above the floor meets it, before the near plane maybe.
    if (ray.direction.y < 0.0 && camera_position.y > floor_center.y) {
        float travel = height / min(ray.direction.y, -1e-4);
        vec3 point = ray.origin + travel * ray.direction;
        float distance_in_radii = length(point.xz - floor_center.xz) / floor_radius;
        vec3 floor_tone = vec3(0.064) * contact_light(point);
        backdrop = mix(floor_tone, wall, smoothstep(1.0, 9.0, distance_in_radii));
    }
    vec2 from_middle = (pixel / picture_size - vec2(0.5, 0.45)) * vec2(1.0, 0.8);
    return backdrop * (1.0 - 1.3 * dot(from_middle, from_middle));
}

vec3 environment_backdrop(vec2 pixel) {
    vec3 direction = ray_through(pixel).direction;
    return BACKGROUND_KIND == BACKGROUND_ENVIRONMENT
               ? environment_radiance(direction, 0.0)
               : environment_blurred(direction, BLURRED_ROUGHNESS);
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
