// SPDX-License-Identifier: MIT
// Light from all around for stills that converge: some directions of the map, the same for every
// pixel of a draw, and some of each pixel's own lobe, each weighted by how likely the other would
// have drawn it (the balance heuristic of E. Veach, "Robust Monte Carlo methods for light transport
// simulation", 1997). Laid out in engine/render/environment_samples.cpp.

#include "passes/lit.glsl"
#include "shared/color.glsl"
#include "shared/environment.glsl"
#include "shared/noise.glsl"
#include "shared/sequence.glsl"

const int LIGHT_SAMPLES = 8;  // of a draw
const int LOBE_SAMPLES = 2;   // of a pixel in a draw

uniform sampler2D environment_map;     // radiance x map_scale, with the means of its texels as mips
uniform float map_scale;               // keeps it within half floats
uniform float map_texel_angle;         // steradians of a texel at the horizon
uniform float density_per_luminance;   // of drawing a direction of the map: 1 / its integral
uniform int light_sample_count;        // 0 for a black map
uniform vec4 light_sample_towards[LIGHT_SAMPLES];   // of the map, unit; w: density of the drawing
uniform vec4 light_sample_radiance[LIGHT_SAMPLES];
uniform int draw_index;
uniform int draw_count;

/// The level of detail rises with what one sample of the lobe stands for: little noise in few
/// draws, and the map itself in many.
float level_for_density(float density) {
    return filtered_level(1.0 / (density * float(draw_count * LOBE_SAMPLES)), map_texel_angle);
}

vec3 map_radiance(vec3 direction_map, float level) {
    return textureLod(environment_map, equirect_uv(direction_map), level).rgb / map_scale;
}

/// How densely the directions of a draw are spread by the light, near one of that radiance.
float light_density(vec3 radiance) {
    return float(light_sample_count) * density_per_luminance * luminance(radiance);
}

/// Point `i` of this pixel's sequence in the unit square: Roberts's R2 from a random start. In whole
/// numbers, 2^32 to a side: the place of a late point is as fine as that of the first.
vec2 lobe_point(vec2 pixel, int i) {
    uvec2 cell = uvec2(pixel);
    uvec2 start = uvec2(lattice_hash(int(cell.x), int(cell.y), 1u),
                        lattice_hash(int(cell.x), int(cell.y), 2u));
    uvec2 at = start + uint(i) * uvec2(3242174889u, 2447445414u);
    return vec2(unit_from_bits(at.x), unit_from_bits(at.y));
}

/// A direction of a surface's own lobe; density 0: it lies below the horizon.
struct LobeSample {
    vec3 direction;
    float density;
};

LobeSample[LOBE_SAMPLES] lobe_samples(Surface s, PbrSurface p, vec3 v) {
    float alpha = alpha_from_roughness(s.roughness);
    vec3 across = v - dot(v, s.normal) * s.normal;
    vec3 tangent =
        dot(across, across) > 1e-10 ? normalize(across) : across_of(s.normal).x_axis;
    mat3 world_from_tangent = mat3(tangent, cross(s.normal, tangent), s.normal);
    vec3 v_tangent = vec3(sqrt(max(1.0 - p.n_dot_v * p.n_dot_v, 0.0)), 0.0, p.n_dot_v);
    LobeSample samples[LOBE_SAMPLES];
    for (int i = 0; i < LOBE_SAMPLES; ++i) {
        vec2 u = lobe_point(gl_FragCoord.xy, draw_index * LOBE_SAMPLES + i);
        vec3 h = sample_ggx_visible_half_vector(u, v_tangent, alpha);
        vec3 l = world_from_tangent * reflect(-v_tangent, h);
        bool below = dot(l, s.normal) <= 0.0;
        samples[i] =
            LobeSample(l, below ? 0.0 : ggx_visible_density(h.z, p.n_dot_v, alpha));
    }
    return samples;
}
