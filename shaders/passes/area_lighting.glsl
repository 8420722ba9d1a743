// SPDX-License-Identifier: MIT
// Lamps that have a size. While things move: diffuse part and highlight in closed form. In stills
// that converge: directions towards the lamp and of the surface's own lobe, weighted by the balance
// heuristic as those of environment_samples.glsl are.
// Constant: AREA_LIGHTS; 0 leaves all of it out, which compiles faster.

#include "passes/camera.glsl"
#include "passes/environment_samples.glsl"
#include "passes/lights.glsl"
#include "passes/lit.glsl"
#include "passes/shadows.glsl"

/// The map that holds the shadow of a lamp; -1: none.
int map_of_lamp(int i) {
    if (SHADOWS == 0) return -1;
    for (int map = 0; map < shadow_count; ++map)
        if (int(shadow_lamp[map]) == i) return map;
    return -1;
}

/// What of a lamp reaches a surface.
float lamp_reaching(int i, Surface s, vec3 towards) {
    int map = map_of_lamp(i);
    return map < 0 ? 1.0
                   : light_reaching(map, s.position, s.normal, towards, picture_pixel());
}

#if AREA_LIGHTS == 1
#include "shared/area_light.glsl"

SeenRectangle seen_rectangle(Lamp lamp, vec3 point) {
    vec3 travel = lamp.direction_size.xyz;
    return SeenRectangle(lamp.position_kind.xyz - point, lamp.across_size.xyz,
                         cross(travel, lamp.across_size.xyz), travel, lamp.direction_size.w,
                         lamp.across_size.w);
}

uniform vec2 lamp_point;  // of the unit square: where lamps that cast shadows shine from in this draw

/// A lamp that has a size, as a point sees it.
struct SeenLamp {
    bool is_sphere;
    vec3 radiance;
    SeenRectangle rectangle;  // its middle is that of a sphere too
    float radius;
    float sine2;  // of a sphere: (radius / distance)^2
};

SeenLamp seen_lamp(Lamp lamp, vec3 point) {
    SeenLamp seen;
    seen.is_sphere = lamp.position_kind.w == SPHERE;
    seen.rectangle = seen_rectangle(lamp, point);
    seen.radius = lamp.direction_size.w;
    float distance2 = max(dot(seen.rectangle.middle, seen.rectangle.middle), 1e-12);
    seen.sine2 = min(seen.radius * seen.radius / distance2, 0.9999);
    seen.radiance = range_window(sqrt(distance2), lamp.color_range.w) * lamp.color_range.rgb;
    return seen;
}

/// In closed form.
void add_area_lamp(inout Lit lit, SeenLamp lamp, int i, Surface s, PbrSurface p, vec3 v) {
    SeenRectangle r = lamp.rectangle;
    vec3 towards = normalize(r.middle);
    vec3 vector = lamp.is_sphere ? lamp.sine2 * towards : rectangle_irradiance(r);
    float facing = length(vector);
    if (facing <= 0.0) return;
    vec3 radiance = lamp.radiance * lamp_reaching(i, s, vector / facing);

    ReflectionAngles angles = reflection_angles(s.normal, v, vector / facing);
    lit.diffuse_direct += PI * radiance * share_of_vector(vector, s.normal) *
                          brdf_diffuse(TERMS, angles, p.diffuse, p.dielectric, s.f90, s.roughness);

    float alpha = alpha_from_roughness(s.roughness);
    Highlight highlight = lamp.is_sphere
                              ? sphere_highlight(towards, lamp.sine2, v, s.normal, alpha)
                              : rectangle_highlight(r, v, s.normal, alpha);
    angles = reflection_angles(s.normal, v, highlight_direction(highlight, v, s.normal));
    lit.specular_direct +=
        radiance * p.boost *
        brdf_of_highlight(TERMS, angles, highlight.share, s.f0, s.f90, s.roughness);
}

/// Of drawing a direction that meets the lamp. by_point: points of a rectangle are drawn, and not
/// directions.
float lamp_density(SeenLamp lamp, vec3 direction, bool by_point) {
    if (lamp.is_sphere) return sphere_density(lamp.sine2);
    return by_point ? rectangle_point_density(direction, lamp.rectangle)
                    : rectangle_density(direction, lamp.rectangle);
}

vec3 lamp_direction(SeenLamp lamp, vec2 u, bool by_point) {
    if (lamp.is_sphere) return sphere_direction(u, normalize(lamp.rectangle.middle), lamp.sine2);
    return by_point ? rectangle_point_direction(u, lamp.rectangle)
                    : rectangle_direction(u, lamp.rectangle);
}

/// One draw's share of the light of lamp i. A lamp that casts a shadow shines from one point in each
/// draw, the same for all pixels: the one that its map is drawn from. What a pixel's own lobe finds
/// of it is shadowed as that point is.
void add_sampled_lamp(inout Lit lit, SeenLamp lamp, int i, Surface s, PbrSurface p, vec3 v,
                      LobeSample lobe[LOBE_SAMPLES]) {
    SeenRectangle r = lamp.rectangle;
    if (!lamp.is_sphere && dot(r.middle, r.shines) >= 0.0) return;
    // Another point of the same sequence for each lamp: Roberts's steps in its third dimension.
    vec2 u = fract(lobe_point(gl_FragCoord.xy, draw_index) +
                   float(i + 1) * vec2(0.8191725133961645, 0.6710436067037893));
    bool by_point = map_of_lamp(i) >= 0;
    vec3 l = lamp_direction(lamp, by_point ? lamp_point : u, by_point);
    vec3 radiance = lamp.radiance * lamp_reaching(i, s, l);
    ReflectionAngles angles = reflection_angles(s.normal, v, l);
    float alpha = alpha_from_roughness(s.roughness);
    float by_lobe =
        float(LOBE_SAMPLES) * ggx_visible_density(angles.n_dot_h, angles.n_dot_v, alpha);
    add_direct_light(lit, s, p, v, l, radiance / (lamp_density(lamp, l, by_point) + by_lobe));
    for (int k = 0; k < LOBE_SAMPLES; ++k) {
        if (lobe[k].density == 0.0) continue;
        float met = lamp.is_sphere ? sphere_is_met(lobe[k].direction, r.middle, lamp.radius)
                                   : rectangle_is_met(lobe[k].direction, r);
        if (met == 0.0) continue;
        float by_either = lamp_density(lamp, lobe[k].direction, by_point) +
                          float(LOBE_SAMPLES) * lobe[k].density;
        add_direct_light(lit, s, p, v, lobe[k].direction, radiance / by_either);
    }
}

#endif
