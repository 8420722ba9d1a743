// SPDX-License-Identifier: MIT
// Shadows, with edges as soft as the light is wide. Maps of depth as seen from the lights, beside
// each other in one texture. Laid out in engine/render/shadow_maps.cpp.
// Constant: SHADOWS, 0 where there are none. R. Fernando, "Percentage-closer soft shadows", 2005.

#include "shared/dither.glsl"
#include "shared/transcendental.glsl"

const int MOST_SHADOWS = 6;
const int BLOCKER_TAPS = 4;
const int EDGE_TAPS = 8;
const int NEAR_TAPS = 3;  // of an edge that is no wider than a texel
const float MOST_SLOPE = 4.0;  // metres deeper by a metre aside
// Curved and bumpy surfaces are not their planes: tan 14 degrees. Blockers are missed by it only
// where their edge would be less than a few texels wide.
const float BEND = 0.25;

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

/// The four texels around a place of a map (0 to 1), which stands between them as much as it is near
/// to each: a rounding of the place is then one of the light, and not one step of it more or less.
struct ShadowTexels {
    vec4 depths;
    vec4 shares;  // 1 in all
};
ShadowTexels shadow_texels(int map, vec2 at) {
    float side = shadow_shape[map].z;
    vec2 between = clamp(at * side - 0.5, vec2(0.0), vec2(side - 1.0));
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

/// A point of a surface as a map sees it, and the plane that touches the surface there. Depths are
/// those of the map, steps aside are shares of its width.
struct ShadowPlace {
    vec2 at;        // 0 to 1 of the map
    float metres;   // along the axis
    float deepest;  // what is as deep as this at the place itself gets by
    vec2 slope;     // how much deeper the plane is, by steps across and up
    float bend;     // how much nearer than the plane the surface may be, by a step in any direction
    float hard;     // 1 / by how much less than `deepest` a depth has to be to block wholly
    bool inside;    // the map
};

/// A map's depth by a step across and by one up along a plane: depths are linear on a plane in maps
/// of either kind. At most `steepest`; what is seen more on edge gets little light anyway.
/// `w`, `at`: of a point of the plane, and where the map has it.
vec2 shadow_slope(int map, vec3 normal, float w, vec3 at, float steepest) {
    vec3 w_way = shadow_from_world[4 * map + 3].xyz;
    vec3 across = (shadow_from_world[4 * map].xyz - at.x * w_way) / w;
    vec3 up = (shadow_from_world[4 * map + 1].xyz - at.y * w_way) / w;
    vec3 depth = (shadow_from_world[4 * map + 2].xyz - at.z * w_way) / w;
    // Of the three gradients only what lies along the plane counts.
    vec3 seen = cross(across, up);
    float facing = max(dot(normal, seen), 1e-3 * length(seen));
    vec2 slope = vec2(dot(normal, cross(depth, up)), dot(normal, cross(across, depth))) / facing;
    return slope * min(1.0, steepest / max(length(slope), 1e-20));
}

/// How much a map's depth grows with a metre along its axis.
float shadow_depth_by_metre(int map, float metres) {
    vec2 range = shadow_range[map].xy;
    if (shadow_shape[map].w < 0.5) return 1.0 / range.y;
    float m = max(metres, range.x);
    return range.x * range.y / (m * m * (range.y - range.x));
}

ShadowPlace shadow_place(int map, vec3 point, vec3 normal) {
    vec4 shape = shadow_shape[map];
    // Off the surface by what one texel hides. w is 1 for a far light.
    float w = dot(shadow_from_world[4 * map + 3], vec4(point, 1.0));
    float metres_across = shape.x * max(w, 1e-6);
    vec4 moved = vec4(point + normal * (1.5 * metres_across / shape.z), 1.0);
    w = max(dot(shadow_from_world[4 * map + 3], moved), 1e-6);
    vec3 at = vec3(dot(shadow_from_world[4 * map], moved),
                   dot(shadow_from_world[4 * map + 1], moved),
                   dot(shadow_from_world[4 * map + 2], moved)) / w;
    float texel = 1.0 / shape.z;
    ShadowPlace place;
    place.at = at.xy;
    place.metres = shape.w > 0.5 ? w : shadow_metres_of(map, at.z);
    float by_step = shadow_depth_by_metre(map, place.metres) * metres_across;
    place.slope = shadow_slope(map, normal, w, at, MOST_SLOPE * by_step);
    float slope = length(place.slope);
    place.deepest = shadow_depth_of(map, place.metres) - slope * texel;
    // An angle between plane and surface matters more the more they are seen on edge.
    place.bend = BEND * (by_step + slope * slope / by_step);
    place.hard = 1.0 / max(0.5 * texel * by_step, 1e-7);
    vec2 beside = abs(at.xy - 0.5);
    place.inside = w > 1e-6 && max(beside.x, beside.y) <= 0.5;
    return place;
}

/// What gets by a step aside of a place, `reach` long that `way`, of what has these depths there: all
/// that is as deep as the surface.
vec4 shadow_passing(ShadowPlace place, float reach, vec2 way, vec4 depths) {
    float surface = place.deepest + reach * (dot(place.slope, way) - place.bend);
    // Nothing is deeper than a map goes, but the floor beside the scene may be.
    return clamp((depths - min(surface, 1.0)) * place.hard + 1.0, 0.0, 1.0);
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
    float blockers = 0.0;
    float blocker_depths = 0.0;
    way = GOLDEN_TURN * way;
    for (int k = 0; k < taps; ++k) {
        float reach = widest * sqrt((float(2 * k) + 1.5) / float(EDGE_TAPS));
        ShadowTexels tap = shadow_texels(map, place.at + reach * way);
        vec4 blocks = tap.shares * (1.0 - shadow_passing(place, reach, way, tap.depths));
        blockers += dot(blocks, vec4(1.0));
        blocker_depths += dot(blocks, tap.depths);
        way = GOLDEN_TURN * (GOLDEN_TURN * way);
    }
    if (blockers == 0.0) return 0.0;
    float blocker_metres = shadow_metres_of(map, blocker_depths / blockers);
    return clamp(shadow_edge(map, place.metres, blocker_metres), 1.0 / shadow_shape[map].z, widest);
}

/// How far aside is looked for what blocks: as far as the widest edge. That of what is close to a
/// lamp at a place would be wider than the map, and among so few taps narrower ones would be lost:
/// no edge there is wider than the lamp, as it is of what blocks halfway.
float widest_edge(int map, float metres) {
    float nearest = shadow_range[map].x;
    if (shadow_shape[map].w > 0.5) nearest = max(nearest, 0.5 * metres);
    return clamp(shadow_edge(map, metres, nearest), 1.0 / shadow_shape[map].z, 0.125);
}

/// How much of a light reaches a point, 0 to 1. `normal` and `towards` are unit, in the world.
/// Beside a map, and where the light is behind the surface, all of it does.
float light_reaching(int map, vec3 point, vec3 normal, vec3 towards, vec2 pixel) {
    if (SHADOWS == 0) return 1.0;
    ShadowPlace place = shadow_place(map, point, normal);
    float turn = 2.0 * PI * (interleaved_gradient_noise(floor(pixel)) + shadow_turn);
    vec2 way = vec2(cos(turn), sin(turn));
    // Counts that are not constant keep loops what they are: lanes that agree leave them at once.
    bool matters = shadow_matters(map, place, normal, towards);
    float edge = shadow_edge_at(map, place, matters ? BLOCKER_TAPS : 0, way,
                                widest_edge(map, place.metres));
    // What blocks from nearby is too near for the wide search and has a hard edge.
    int taps = !matters ? 0 : edge > 0.0 ? EDGE_TAPS : NEAR_TAPS;
    edge = max(edge, 1.0 / shadow_shape[map].z);
    float reaching = 0.0;
    for (int k = 0; k < taps; ++k) {
        float reach = edge * sqrt((float(k) + 0.5) / float(EDGE_TAPS));
        ShadowTexels tap = shadow_texels(map, place.at + reach * way);
        reaching += dot(tap.shares, shadow_passing(place, reach, way, tap.depths));
        way = GOLDEN_TURN * way;
    }
    return matters ? reaching / float(taps) : 1.0;
}
