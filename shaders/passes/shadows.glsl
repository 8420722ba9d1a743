// SPDX-License-Identifier: MIT
// Shadows, with edges as soft as the light is wide. Maps of depth as seen from the lights, beside
// each other in one texture. Laid out in engine/render/shadow_maps.cpp.
// Constant: SHADOWS, 0 where there are none. R. Fernando, "Percentage-closer soft shadows", 2005.

const int MOST_SHADOWS = 6;
const int BLOCKER_TAPS = 4;
const int EDGE_TAPS = 8;
const int NEAR_TAPS = 3;  // of an edge that is no wider than a texel

// Taps are points of the unit disc, from the middle outwards, a golden angle apart: H. Vogel's
// spiral, 1979. The search for what blocks takes every other one. They are turned on from tap to tap
// and not looked up: a table of known length lets compilers unroll loops that are better left early.
const mat2 GOLDEN_TURN = mat2(-0.7373688, 0.6754903, -0.6754903, -0.7373688);

uniform sampler2D shadow_maps;                   // 0 nearest to the light, 1 behind everything
uniform vec4 shadow_from_world[4 * MOST_SHADOWS];  // rows: across, up (0 to 1 of the map), depth, w
// Metres across (of a lamp at a place: at 1 m from it); its radius (of a far light the tangent, of a
// lamp metres); texels across; 1: a lamp at a place.
uniform vec4 shadow_shape[MOST_SHADOWS];
uniform vec4 shadow_range[MOST_SHADOWS];  // metres at depth 0 and 1
uniform int shadow_count;                 // of the maps
uniform float shadow_lamp[MOST_SHADOWS];  // the lamp of a map; -1: none
uniform int sun_shadow_count;             // suns 0 to this less 1 have the maps of their numbers
uniform int key_shadow;                   // the map of the strongest key light of Phong; -1: none
uniform float shadow_turn;                // of the taps, in turns: another in each draw of many

/// The four texels around a place of a map, which stands between them as much as it is near to each:
/// a rounding of the place is then one of the light, and not one step of it more or less.
struct ShadowTexels {
    vec4 depths;
    vec4 shares;  // 1 in all
};
ShadowTexels shadow_texels(int map, vec2 texel) {
    float side = shadow_shape[map].z;
    vec2 between = clamp(texel - 0.5, vec2(0.0), vec2(side - 1.0));
    vec2 low = min(floor(between), vec2(side - 2.0));
    vec2 high_share = between - low;
    vec2 corner = low + vec2(float(map) * side + 1.0, 1.0);
    vec4 depths = textureGather(shadow_maps, corner / vec2(textureSize(shadow_maps, 0)));
    // As it gathers them: upper left, upper right, lower right, lower left.
    vec4 across = vec4(1.0 - high_share.x, high_share.x, high_share.x, 1.0 - high_share.x);
    vec4 up = vec4(high_share.y, high_share.y, 1.0 - high_share.y, 1.0 - high_share.y);
    return ShadowTexels(depths, across * up);
}

/// The depth in a map of what is so many metres away along its axis, and back.
float shadow_depth_of(int map, float metres) {
    vec2 range = shadow_range[map].xy;
    if (shadow_shape[map].w < 0.5) return metres / range.y;
    float m = max(metres, range.x);
    return range.y * (m - range.x) / (m * (range.y - range.x));
}
float shadow_metres_of(int map, float depth) {
    vec2 range = shadow_range[map].xy;
    if (shadow_shape[map].w < 0.5) return depth * range.y;
    return range.x * range.y / (range.y - depth * (range.y - range.x));
}

/// How wide the edge is, as a share of the map, of what is in the shadow of a blocker; both in
/// metres along the axis.
float shadow_edge(int map, float metres, float blocker_metres) {
    vec4 shape = shadow_shape[map];
    float gap = max(metres - blocker_metres, 0.0);
    if (shape.w < 0.5) return gap * shape.y / shape.x;
    return gap * shape.y / (max(blocker_metres, 1e-6) * metres * shape.x);
}

/// How much deeper a surface is a step aside; those on edge get little light anyway.
float shadow_slope(int map, vec3 normal, vec3 towards) {
    bool at_place = shadow_shape[map].w > 0.5;
    vec3 axis = at_place ? shadow_from_world[4 * map + 3].xyz : -towards;
    float along = dot(normal, axis);
    float n_dot_l = clamp(dot(normal, towards), 0.0, 1.0);
    return min(sqrt(max(1.0 - along * along, 0.0)) * abs(dot(axis, towards)) / max(n_dot_l, 1e-3),
               4.0);
}

/// A point of a surface as a map sees it.
struct ShadowPlace {
    vec2 texel;         // from the corner of the map
    float metres;       // along the axis
    float slope;        // metres that the surface is deeper by, a map's width aside
    float soft_metres;  // nearer than the surface by less than this it is the surface that blocks
    bool inside;        // the map
};
ShadowPlace shadow_place(int map, vec3 point, vec3 normal, vec3 towards) {
    vec4 shape = shadow_shape[map];
    // Off the surface by what one texel hides. w is 1 for a far light.
    float w = dot(shadow_from_world[4 * map + 3], vec4(point, 1.0));
    float metres_across = shape.x * max(w, 0.0);
    vec4 moved = vec4(point + normal * (1.5 * metres_across / shape.z), 1.0);
    w = dot(shadow_from_world[4 * map + 3], moved);
    vec3 at = vec3(dot(shadow_from_world[4 * map], moved),
                   dot(shadow_from_world[4 * map + 1], moved),
                   dot(shadow_from_world[4 * map + 2], moved)) / max(w, 1e-6);
    ShadowPlace place;
    place.texel = at.xy * shape.z;
    place.metres = shape.w > 0.5 ? w : shadow_metres_of(map, at.z);
    place.slope = shadow_slope(map, normal, towards) * metres_across;
    place.soft_metres = 0.5 * metres_across / shape.z;
    vec2 beside = abs(at.xy - 0.5);
    place.inside = w > 0.0 && max(beside.x, beside.y) <= 0.5;
    return place;
}

/// What gets by near a place: all of it where a map is `deepest` or deeper, nothing where it is nearer
/// by `soft`.
struct ShadowDepths {
    float deepest;
    float soft;
};
/// `reach`: how far aside is looked, as a share of the map.
ShadowDepths shadow_depths(int map, ShadowPlace place, float reach) {
    float metres = place.metres - place.slope * (reach + 1.0 / shadow_shape[map].z);
    // Nothing is deeper than a map goes, but the floor beside the scene may be.
    float deepest = min(shadow_depth_of(map, metres), 1.0);
    float soft = deepest - shadow_depth_of(map, metres - place.soft_metres);
    return ShadowDepths(deepest, max(soft, 1e-7));
}
vec4 shadow_passing(vec4 depths, ShadowDepths passes) {
    return clamp((depths - passes.deepest) / passes.soft + 1.0, 0.0, 1.0);
}

/// Whether a light shines on any of the side that a surface shows, by how wide the light is.
bool shadow_matters(int map, ShadowPlace place, vec3 normal, vec3 towards) {
    float radius = shadow_shape[map].y;
    if (shadow_shape[map].w > 0.5) radius /= max(place.metres, 1e-6);
    return place.inside && dot(normal, towards) > -radius;
}

/// How wide the edge is there, as a share of the map: by the mean of what blocks nearby. 0: nothing
/// does. `way`: where the taps begin.
float shadow_edge_at(int map, ShadowPlace place, int taps, vec2 way, float widest) {
    ShadowDepths passes = shadow_depths(map, place, widest);
    float blockers = 0.0;
    float blocker_depths = 0.0;
    way = GOLDEN_TURN * way;
    for (int k = 0; k < taps; ++k) {
        float out_share = sqrt((float(2 * k) + 1.5) / float(EDGE_TAPS));
        ShadowTexels tap = shadow_texels(map, place.texel + widest * out_share * way);
        vec4 blocks = tap.shares * (1.0 - shadow_passing(tap.depths, passes));
        blockers += dot(blocks, vec4(1.0));
        blocker_depths += dot(blocks, tap.depths);
        way = GOLDEN_TURN * (GOLDEN_TURN * way);
    }
    if (blockers == 0.0) return 0.0;
    float blocker_metres = shadow_metres_of(map, blocker_depths / blockers);
    return clamp(shadow_edge(map, place.metres, blocker_metres), 1.0 / shadow_shape[map].z, widest);
}

/// How much of a light reaches a point, 0 to 1. `normal` and `towards` are unit, in the world.
/// Beside a map, and where the light is behind the surface, all of it does.
float light_reaching(int map, vec3 point, vec3 normal, vec3 towards, vec2 pixel) {
    if (SHADOWS == 0) return 1.0;
    ShadowPlace place = shadow_place(map, point, normal, towards);
    float noise = fract(52.9829189 * fract(dot(floor(pixel), vec2(0.06711056, 0.00583715))));
    float turn = 6.2831853 * (noise + shadow_turn);
    vec2 way = vec2(cos(turn), sin(turn)) * shadow_shape[map].z;
    // Counts that are not constant keep loops what they are: lanes that agree leave them at once.
    bool matters = shadow_matters(map, place, normal, towards);
    float texel = 1.0 / shadow_shape[map].z;
    // A lamp amid the scene may have blockers close by, whose edges would be wider than the map.
    float widest = clamp(shadow_edge(map, place.metres, shadow_range[map].x), texel, 0.125);
    float edge = shadow_edge_at(map, place, matters ? BLOCKER_TAPS : 0, way, widest);
    // What blocks from nearby is too near for the wide search and has a hard edge.
    int taps = !matters ? 0 : edge > 0.0 ? EDGE_TAPS : NEAR_TAPS;
    edge = max(edge, texel);
    ShadowDepths passes = shadow_depths(map, place, edge);
    float reaching = 0.0;
    for (int k = 0; k < taps; ++k) {
        float out_share = sqrt((float(k) + 0.5) / float(EDGE_TAPS));
        ShadowTexels tap = shadow_texels(map, place.texel + edge * out_share * way);
        reaching += dot(tap.shares, shadow_passing(tap.depths, passes));
        way = GOLDEN_TURN * way;
    }
    return matters ? reaching / float(taps) : 1.0;
}
