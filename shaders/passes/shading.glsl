// SPDX-License-Identifier: MIT
// Light on a surface: the same text for the deferred pass and for blended surfaces.
// Constants: SHADING_MODEL, DISTRIBUTION, GEOMETRY, FRESNEL, DIFFUSE, MULTIPLE_SCATTERING; they are
// the enumerators of engine/render/shading.h.

#include "passes/environment.glsl"
#include "passes/lights.glsl"
#include "shared/brdf.glsl"
#include "shared/phong.glsl"

const int SHADING_PBR = 0;
const int SHADING_PHONG = 1;
const int SHADING_BLINN_PHONG = 2;

const BrdfTerms TERMS = BrdfTerms(DISTRIBUTION, GEOMETRY, FRESNEL, DIFFUSE);

/// The lecture's diffuse term is for lamps, whose light it does not divide by pi.
const BrdfTerms AMBIENT_TERMS = BrdfTerms(
    DISTRIBUTION, GEOMETRY, FRESNEL, DIFFUSE == DIFFUSE_LECTURE ? DIFFUSE_LAMBERT : DIFFUSE);

uniform vec3 key_direction;     // towards the light whose terms D, F and G can be shown, unit
uniform vec3 ambient_radiance;  // Phong: the mean of the environment
uniform vec3 ambient_key_irradiance;  // Phong: its strongest directional light ...
uniform vec3 ambient_key_direction;   // ... and where that is, unit
uniform float phong_exponent_override;        // below 0: from roughness
uniform vec3 phong_specular_color_override;  // below 0: from F0

struct Surface {
    vec3 base_color;
    float metalness;
    vec3 normal;  // world, unit
    float roughness;
    vec3 f0;
    float f90;
    vec3 emissive;
    float occlusion;
    vec3 position;  // world
    bool unlit;
};

/// Radiance towards the eye, in parts.
struct Lit {
    vec3 diffuse_direct;
    vec3 specular_direct;
    vec3 diffuse_ambient;
    vec3 specular_ambient;
};

/// F0 of what is not metal in a mixture: material_f0 solved for it.
vec3 dielectric_part_f0(Surface s) {
    vec3 rest = s.f0 - s.metalness * s.base_color;
    return clamp(rest / max(1.0 - s.metalness, 1e-3), 0.0, 1.0);
}

/// Adds the suns of the environment to its filtered light.
void add_suns(inout Lit lit, Surface s, vec3 v, vec3 diffuse, vec3 dielectric, vec3 boost,
              float level_share) {
    float missing = suns_missing(level_share);
    for (int i = 0; i < sun_count; ++i) {
        vec3 towards = transpose(environment_from_world) * sun_towards[i].xyz;
        ReflectionAngles angles = reflection_angles(s.normal, v, towards);
        vec3 received = s.occlusion * environment_intensity * sun_irradiance[i].rgb * angles.n_dot_l;
        float roughness = roughness_under_disc(s.roughness, sun_towards[i].w);
        lit.diffuse_ambient +=
            received * brdf_diffuse(AMBIENT_TERMS, angles, diffuse, dielectric, s.f90, s.roughness);
        lit.specular_ambient +=
            missing * received * boost * brdf_specular(TERMS, angles, s.f0, s.f90, roughness);
    }
}

Lit lit_pbr(Surface s, vec3 v) {
    Lit lit = Lit(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0));
    vec3 diffuse = diffuse_color(s.base_color, s.metalness);
    vec3 dielectric = dielectric_part_f0(s);
    float n_dot_v = clamp(dot(s.normal, v), LEAST_N_DOT_V, 1.0);
    EnvironmentBrdf environment = environment_brdf_of(n_dot_v, s.roughness);
    vec3 boost = MULTIPLE_SCATTERING == 1
                     ? multiple_scattering_scale(s.f0, environment.scale + environment.bias)
                     : vec3(1.0);

    for (int i = 0; i < light_count; ++i) {
        Incident light = incident_light(i, s.position);
        ReflectionAngles angles = reflection_angles(s.normal, v, light.direction);
        vec3 received = light.irradiance * angles.n_dot_l;
        lit.diffuse_direct +=
            received * brdf_diffuse(TERMS, angles, diffuse, dielectric, s.f90, s.roughness);
        lit.specular_direct +=
            received * boost * brdf_specular(TERMS, angles, s.f0, s.f90, s.roughness);
    }

    // The split sum: what is mirrored of a uniform environment, times the filtered one.
    vec3 mirrored = (s.f0 * environment.scale + s.f90 * environment.bias) * boost;
    lit.specular_ambient = s.occlusion * mirrored * environment_mirrored(environment, s.normal, v);
    vec3 entering = 1.0 - mix(dielectric, vec3(s.f90), schlick_mean(n_dot_v));
    lit.diffuse_ambient = s.occlusion * diffuse * entering * environment_diffuse(s.normal);
    add_suns(lit, s, v, diffuse, dielectric, boost, environment.level_share);
    return lit;
}

PhongMaterial traditional_material(Surface s) {
    PhongMaterial m =
        SHADING_MODEL == SHADING_PHONG
            ? phong_material(s.base_color, s.metalness, s.roughness, s.f0)
            : blinn_phong_material(s.base_color, s.metalness, s.roughness, s.f0);
    if (phong_exponent_override >= 0.0) m.exponent = phong_exponent_override;
    if (phong_specular_color_override.x >= 0.0) m.specular = phong_specular_color_override;
    return m;
}

/// Adds one light; `received` is irradiance on a surface that faces it.
void add_traditional_light(inout Lit lit, PhongMaterial m, vec3 n, vec3 v, vec3 l, vec3 received) {
    float n_dot_l = dot(n, l);
    float lobe = SHADING_MODEL == SHADING_PHONG
                     ? phong_lobe(clamp(dot(reflect(-l, n), v), 0.0, 1.0), n_dot_l, m.exponent)
                     : blinn_phong_lobe(clamp(dot(n, normalize(l + v)), 0.0, 1.0), n_dot_l,
                                        m.exponent);
    vec3 light = received / PI;
    lit.diffuse_direct += light * m.diffuse * max(n_dot_l, 0.0);
    lit.specular_direct += light * m.specular * lobe;
}

/// The environment is what a fixed-function artist had: an ambient colour and one strong light.
Lit lit_traditional(Surface s, vec3 v) {
    Lit lit = Lit(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0));
    PhongMaterial m = traditional_material(s);
    lit.diffuse_ambient = ambient_radiance * m.diffuse * s.occlusion;
    add_traditional_light(lit, m, s.normal, v, ambient_key_direction, ambient_key_irradiance);
    for (int i = 0; i < light_count; ++i) {
        Incident light = incident_light(i, s.position);
        add_traditional_light(lit, m, s.normal, v, light.direction, light.irradiance);
    }
    return lit;
}

Lit lit_surface(Surface s, vec3 v) {
    if (SHADING_MODEL == SHADING_PBR) return lit_pbr(s, v);
    return lit_traditional(s, v);
}

vec3 radiance_of(Surface s, Lit lit) {
    if (s.unlit) return s.base_color;
    return lit.diffuse_direct + lit.specular_direct + lit.diffuse_ambient + lit.specular_ambient +
           s.emissive;
}
