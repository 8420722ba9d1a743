// SPDX-License-Identifier: MIT
// Lamps: those of KHR_lights_punctual, and spheres and rectangles. Laid out in
// engine/render/light_block.cpp.
#include "shared/lamp.glsl"

const int MAX_LIGHTS = 256;
const float DIRECTIONAL = 0.0;
const float SPOT = 2.0;
const float SPHERE = 3.0;
const float RECTANGLE = 4.0;

struct Lamp {
    vec4 position_kind;   // world; w: kind
    vec4 color_range;     // linear colour x intensity (radiance of those with a size); w: range, 0
                          // everywhere
    vec4 direction_size;  // the way it travels, unit; w: of a spot the scale of the cone, of a sphere
                          // the radius, of a rectangle half of the width
    vec4 across_size;     // of a rectangle, where its width lies; w: of a spot the offset of the cone,
                          // of a rectangle half of the height
};
layout(std140) uniform LightBlock {
    Lamp lamps[MAX_LIGHTS];
};
uniform int light_count;

/// The light of one lamp at a point.
struct Incident {
    vec3 direction;   // towards the lamp, unit
    vec3 irradiance;  // on a surface that faces it
};

bool has_size(Lamp lamp) {
    return lamp.position_kind.w >= SPHERE;
}

/// Of a lamp that has a size, as if all of it came from its middle.
Incident incident_from_middle(Lamp lamp, vec3 direction, float distance2) {
    float area = 4.0 * lamp.direction_size.w * lamp.across_size.w;
    float facing = lamp.position_kind.w == SPHERE
                       ? sphere_from_middle(distance2, lamp.direction_size.w)
                       : rectangle_from_middle(distance2, area,
                                               dot(-direction, lamp.direction_size.xyz));
    return Incident(direction, lamp.color_range.rgb * facing);
}

Incident incident_light(Lamp lamp, vec3 point) {
    vec3 color = lamp.color_range.rgb;
    vec3 travel = lamp.direction_size.xyz;
    if (lamp.position_kind.w == DIRECTIONAL) return Incident(-travel, color);
    vec3 to_light = lamp.position_kind.xyz - point;
    float distance_to_light = max(length(to_light), 1e-6);
    vec3 direction = to_light / distance_to_light;
    float window = range_window(distance_to_light, lamp.color_range.w);
    float distance2 = max(distance_to_light * distance_to_light, 1e-8);
    if (has_size(lamp)) {
        Incident light = incident_from_middle(lamp, direction, distance2);
        return Incident(direction, window * light.irradiance);
    }
    float attenuation = window / distance2;
    if (lamp.position_kind.w == SPOT)
        attenuation *= cone_window(dot(-direction, travel), lamp.direction_size.w,
                                   lamp.across_size.w);
    return Incident(direction, color * attenuation);
}
