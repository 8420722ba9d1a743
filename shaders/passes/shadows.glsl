// SPDX-License-Identifier: MIT
// Shadows of lights that are far away, with edges as soft as the light is wide. Maps of depth as
// seen from the lights, beside each other in one texture. Laid out in engine/render/shadow_maps.cpp.
// Constant: SHADOW_COUNT, of the maps. R. Fernando, "Percentage-closer soft shadows", 2005.

const int MOST_SHADOWS = 4;
const int BLOCKER_TAPS = 4;
const int EDGE_TAPS = 8;

/// Points of the unit disc, from the middle outwards: H. Vogel's spiral, 1979. The search for what
/// blocks takes every other one.
const vec2 DISC[EDGE_TAPS] = vec2[EDGE_TAPS](
    vec2(0.25000, 0.00000), vec2(-0.31929, -0.29250), vec2(0.04887, 0.55688),
    vec2(0.40244, -0.52492), vec2(-0.73854, 0.13064), vec2(0.69960, 0.44503),
    vec2(-0.23400, -0.87048), vec2(-0.44627, 0.85927));

uniform sampler2D shadow_maps;                   // 0 nearest to the light, 1 behind everything
uniform vec4 shadow_from_world[3 * MOST_SHADOWS];  // rows: across, up (0 to 1 of the map), depth
uniform vec4 shadow_shape[MOST_SHADOWS];  // metres across, tangent of the radius, texels across
uniform float shadow_lamp[MOST_SHADOWS];  // the lamp of a map; -1: none
uniform int sun_shadow_count;             // suns 0 to this less 1 have the maps of their numbers
uniform int key_shadow;                   // the map of ambient_key_direction; -1: none
uniform float shadow_turn;                // of the taps, in turns: another in each draw of many

float shadow_depth(int map, vec2 texel) {
    float side = shadow_shape[map].z;
    vec2 inside = clamp(texel, vec2(0.0), vec2(side - 0.5));
    return texelFetch(shadow_maps, ivec2(inside) + ivec2(map * int(side), 0), 0).r;
}

/// How much of a light reaches a point, 0 to 1. `normal` and `towards` are unit, in the world. A
/// map is as deep as it is wide: shares of depth and of its width are the same length.
float light_reaching(int map, vec3 point, vec3 normal, vec3 towards, vec2 pixel) {
    if (SHADOW_COUNT == 0) return 1.0;
    float texel = 1.0 / shadow_shape[map].z;
    float n_dot_l = clamp(dot(normal, towards), 0.0, 1.0);
    // How much deeper a surface is a step aside; those on edge get little light anyway.
    float slope = min(sqrt(1.0 - n_dot_l * n_dot_l) / max(n_dot_l, 1e-3), 4.0);
    // Off the surface by what one texel hides.
    vec4 moved = vec4(point + normal * (1.5 * texel * shadow_shape[map].x), 1.0);
    vec3 at = vec3(dot(shadow_from_world[3 * map], moved),
                   dot(shadow_from_world[3 * map + 1], moved),
                   dot(shadow_from_world[3 * map + 2], moved));
    float turn = 6.2831853 * (fract(52.9829189 * fract(dot(floor(pixel),
                                                           vec2(0.06711056, 0.00583715)))) +
                              shadow_turn);
    mat2 turned = mat2(cos(turn), sin(turn), -sin(turn), cos(turn)) * shadow_shape[map].z;
    vec2 middle = at.xy * shadow_shape[map].z;

    float widest = max(at.z * shadow_shape[map].y, texel);
    float deepest = at.z - slope * widest;
    float blockers = 0.0;
    float blocker_depths = 0.0;
    for (int k = 0; k < BLOCKER_TAPS; ++k) {
        float depth = shadow_depth(map, middle + turned * (widest * DISC[2 * k + 1]));
        float blocks = step(depth, deepest);
        blockers += blocks;
        blocker_depths += blocks * depth;
    }
    // What blocks from nearby is too near for the wide search and has a hard edge.
    float gap = blockers > 0.0 ? at.z - blocker_depths / blockers : 0.0;
    float edge = clamp(gap * shadow_shape[map].y, texel, widest);
    deepest = at.z - slope * edge;
    float reaching = 0.0;
    for (int k = 0; k < EDGE_TAPS; ++k)
        reaching += step(deepest, shadow_depth(map, middle + turned * (edge * DISC[k])));
    return reaching / float(EDGE_TAPS);
}
