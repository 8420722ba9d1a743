// SPDX-License-Identifier: MIT
// Lamps, as KHR_lights_punctual defines them. Laid out in engine/render/light_uniforms.cpp.

const int MAX_LIGHTS = 16;
const float DIRECTIONAL = 0.0;
const float SPOT = 2.0;

uniform int light_count;
uniform vec4 light_position[MAX_LIGHTS];   // world; w: kind
uniform vec4 light_color[MAX_LIGHTS];      // linear colour x intensity; w: range, 0 everywhere
uniform vec4 light_direction[MAX_LIGHTS];  // the way it travels, unit; w: scale of the cone
uniform float light_cone_offset[MAX_LIGHTS];

/// The light of one lamp at a point.
struct Incident {
    vec3 direction;   // towards the lamp, unit
    vec3 irradiance;  // on a surface that faces it
};

/// Inverse square, brought to 0 at the range (KHR_lights_punctual, "Range Property").
float distance_attenuation(float distance_to_light, float range) {
    float window = 1.0;
    if (range > 0.0) window = clamp(1.0 - pow(distance_to_light / range, 4.0), 0.0, 1.0);
    return window / max(distance_to_light * distance_to_light, 1e-8);
}

Incident incident_light(int i, vec3 point) {
    vec3 color = light_color[i].rgb;
    vec3 travel = light_direction[i].xyz;
    if (light_position[i].w == DIRECTIONAL) return Incident(-travel, color);
    vec3 to_light = light_position[i].xyz - point;
    float distance_to_light = max(length(to_light), 1e-6);
    vec3 direction = to_light / distance_to_light;
    float attenuation = distance_attenuation(distance_to_light, light_color[i].w);
    if (light_position[i].w == SPOT) {
        float cone = clamp(dot(-direction, travel) * light_direction[i].w + light_cone_offset[i],
                           0.0, 1.0);
        attenuation *= cone * cone;
    }
    return Incident(direction, color * attenuation);
}
