// SPDX-License-Identifier: MIT
// A surface, and the light that it sends to the eye. Constants: DISTRIBUTION, GEOMETRY, FRESNEL,
// DIFFUSE, the enumerators of engine/render/shading.h.
#include "passes/environment.glsl"
#include "shared/brdf.glsl"

const BrdfTerms TERMS = BrdfTerms(DISTRIBUTION, GEOMETRY, FRESNEL, DIFFUSE);

struct Surface {
    vec3 base_color;
    float metalness;
    vec3 normal;  // world, unit
    float roughness;
    vec3 f0;
    float f90;
    vec3 emissive;
    float occlusion;
    float horizon;  // what of the mirrored environment lies above it, 0 to 1
    vec3 position;  // world
    bool unlit;
};

/// What of uniform light comes back diffusely from a white surface with that F0 and F90.
float environment_entering(vec3 f0_of_colors, float f90, float n_dot_v, float roughness) {
    float f0 = reflected_share(f0_of_colors);
    if (ambient_terms(TERMS).diffuse == DIFFUSE_LAMBERT)
        return 1.0 - mix(f0, f90, schlick_mean(n_dot_v));
    vec2 table = textureLod(diffuse_brdf, vec2(n_dot_v, roughness), 0.0).xy;
    return table.x * (1.0 - f0) - table.y * (f90 - f0);
}

/// Radiance towards the eye, in parts.
struct Lit {
    vec3 diffuse_direct;
    vec3 specular_direct;
    vec3 diffuse_ambient;
    vec3 specular_ambient;
};

/// What physically based shading works with.
struct PbrSurface {
    vec3 diffuse;     // colour of the diffuse part
    vec3 dielectric;  // F0 of what is not metal
    vec3 boost;       // of the specular part, for light that is scattered several times
    float n_dot_v;
    float mirrored_share;  // what of the environment that it mirrors reaches it
    EnvironmentBrdf environment;
};

/// Adds light of a lamp from one direction; `received` is irradiance on a surface that faces it.
void add_direct_light(inout Lit lit, Surface s, PbrSurface p, vec3 v, vec3 l, vec3 received) {
    ReflectionAngles angles = reflection_angles(s.normal, v, l);
    vec3 light = received * angles.n_dot_l;
    lit.diffuse_direct +=
        light * brdf_diffuse(TERMS, angles, p.diffuse, p.dielectric, s.f90, s.roughness);
    lit.specular_direct += light * p.boost * brdf_specular(TERMS, angles, s.f0, s.f90, s.roughness);
}
