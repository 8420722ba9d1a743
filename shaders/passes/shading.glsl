// SPDX-License-Identifier: MIT
// Light on a surface: the same text for the deferred pass and for blended surfaces.
// Constants: SHADING_MODEL, DISTRIBUTION, GEOMETRY, FRESNEL, DIFFUSE, MULTIPLE_SCATTERING; they are
// the enumerators of engine/render/shading.h. SAMPLED_ENVIRONMENT: 1 in stills that converge.
// AREA_LIGHTS: 0 where no lamp has a size. OCCLUDE_REFLECTIONS: render::View::occlude_reflections.
// Those of shadows.glsl.

#include "passes/area_lighting.glsl"
#include "passes/camera.glsl"
#include "passes/environment.glsl"
#include "passes/environment_samples.glsl"
#include "passes/lights.glsl"
#include "passes/lit.glsl"
#include "passes/shadows.glsl"
#include "shared/brdf.glsl"
#include "shared/phong.glsl"

const int SHADING_PBR = 0;
const int SHADING_PHONG = 1;
const int SHADING_BLINN_PHONG = 2;

uniform vec3 key_direction;     // towards the light whose terms D, F and G can be shown, unit
uniform vec3 ambient_radiance;  // Phong: the mean of the environment
const int MOST_KEYS = 3;
uniform int ambient_key_count;  // Phong: its strongest directional lights, the strongest first
uniform vec4 ambient_key_towards[MOST_KEYS];     // unit
uniform vec4 ambient_key_irradiance[MOST_KEYS];  // on a surface that faces it
uniform float phong_exponent_override;        // below 0: from roughness
uniform vec3 phong_specular_color_override;  // below 0: from F0
uniform float phong_specular_strength;       // times either colour

/// Adds light of the environment from one direction; `received` is irradiance on a surface that
/// faces it.
void add_environment_light(inout Lit lit, Surface s, PbrSurface p, vec3 v, vec3 l, vec3 received,
                           float specular_share, float roughness) {
    ReflectionAngles angles = reflection_angles(s.normal, v, l);
    vec3 light = environment_intensity * received * angles.n_dot_l;
    lit.diffuse_ambient += s.occlusion * light *
                           brdf_diffuse(ambient_terms(TERMS), angles, p.diffuse, p.dielectric,
                                        s.f90, s.roughness);
    lit.specular_ambient +=
        p.mirrored_share * specular_share * light * p.boost * brdf_specular(TERMS, angles, s.f0, s.f90, roughness);
}

/// What of the environment's suns reaches a surface.
float[MOST_SUNS] suns_reaching(Surface s) {
    float reaching[MOST_SUNS] = float[MOST_SUNS](1.0, 1.0, 1.0, 1.0);
    for (int i = 0; i < sun_shadow_count; ++i)
        reaching[i] = light_reaching(i, s.position, s.normal,
                                     sun_towards[i].xyz * environment_from_world, picture_pixel());
    return reaching;
}

/// What of the light from a direction of the map reaches a surface.
float map_reaching(float suns[MOST_SUNS], vec3 direction_map) {
    float reaching = 1.0;
    for (int i = 0; i < sun_shadow_count; ++i)
        if (dot(direction_map, sun_towards[i].xyz) > sun_irradiance[i].w) reaching = suns[i];
    return reaching;
}

/// The filtered environment and its suns.
void add_filtered_environment(inout Lit lit, Surface s, PbrSurface p, vec3 v) {
    // The split sum: what is mirrored of a uniform environment, times the filtered one.
    vec3 mirrored = (s.f0 * p.environment.scale + s.f90 * p.environment.bias) * p.boost;
    lit.specular_ambient =
        p.mirrored_share * mirrored * environment_mirrored(p.environment, s.normal, v);
    float entering = environment_entering(p.dielectric, s.f90, p.n_dot_v, s.roughness);
    lit.diffuse_ambient = s.occlusion * p.diffuse * entering * environment_diffuse(s.normal);
    float missing = suns_missing(p.environment.level_share);
    float reaching[MOST_SUNS] = suns_reaching(s);
    for (int i = 0; i < sun_count; ++i)
        add_environment_light(lit, s, p, v, sun_towards[i].xyz * environment_from_world,
                              reaching[i] * sun_irradiance[i].rgb, missing,
                              roughness_under_disc(s.roughness, sun_towards[i].w));
}

/// Whether a surface is smoother than a lobe is ever made: it mirrors one direction of the
/// environment. A lobe of the least width has tails, which a sun would light beside its image.
bool is_mirror(Surface s) {
    return s.roughness * s.roughness < LEAST_ALPHA;
}

void add_mirrored_direction(inout Lit lit, Surface s, PbrSurface p, vec3 v,
                            float suns[MOST_SUNS]) {
    vec3 direction_map = environment_from_world * reflect(-v, s.normal);
    vec3 mirrored = p.mirrored_share * p.boost * fresnel(FRESNEL, p.n_dot_v, s.f0, s.f90);
    lit.specular_ambient += mirrored * environment_intensity * map_reaching(suns, direction_map) *
                            map_radiance(direction_map, 0.0);
}

/// One draw's share of the integral over the environment.
void add_sampled_environment(inout Lit lit, Surface s, PbrSurface p, vec3 v,
                             LobeSample lobe[LOBE_SAMPLES]) {
    float alpha = alpha_from_roughness(s.roughness);
    float suns[MOST_SUNS] = suns_reaching(s);
    bool mirror = is_mirror(s);
    if (mirror) add_mirrored_direction(lit, s, p, v, suns);
    for (int i = 0; i < light_sample_count; ++i) {
        vec3 l = light_sample_towards[i].xyz * environment_from_world;
        ReflectionAngles angles = reflection_angles(s.normal, v, l);
        vec3 radiance = light_sample_radiance[i].rgb;
        float by_light = light_density(radiance);
        float by_lobe = mirror ? 0.0
                               : float(LOBE_SAMPLES) *
                                     ggx_visible_density(angles.n_dot_h, angles.n_dot_v, alpha);
        float drawn = float(light_sample_count) * light_sample_towards[i].w;
        float weight = by_light / (by_light + by_lobe) / drawn;
        add_environment_light(lit, s, p, v, l,
                              map_reaching(suns, light_sample_towards[i].xyz) * weight * radiance,
                              mirror ? 0.0 : 1.0, s.roughness);
    }
    for (int i = 0; i < LOBE_SAMPLES; ++i) {
        if (mirror || lobe[i].density == 0.0) continue;
        vec3 direction_map = environment_from_world * lobe[i].direction;
        vec3 radiance = map_radiance(direction_map, level_for_density(lobe[i].density));
        float by_either = light_density(radiance) + float(LOBE_SAMPLES) * lobe[i].density;
        add_environment_light(lit, s, p, v, lobe[i].direction,
                              map_reaching(suns, direction_map) / by_either * radiance, 1.0,
                              s.roughness);
    }
}

Lit lit_pbr(Surface s, vec3 v) {
    Lit lit = Lit(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0));
    PbrSurface p;
    p.diffuse = diffuse_color(s.base_color, s.metalness);
    p.dielectric = dielectric_part_f0(s.f0, s.base_color, s.metalness);
    p.n_dot_v = held_n_dot_v(s.normal, v);
    p.environment = environment_brdf_of(p.n_dot_v, s.roughness);
    p.mirrored_share =
        OCCLUDE_REFLECTIONS == 1
            ? s.horizon * mirrored_share(p.n_dot_v, s.occlusion, alpha_from_roughness(s.roughness))
            : s.occlusion;
    p.boost = MULTIPLE_SCATTERING == 1
                  ? multiple_scattering_scale(s.f0, p.environment.scale + p.environment.bias)
                  : vec3(1.0);

    LobeSample lobe[LOBE_SAMPLES];
    if (SAMPLED_ENVIRONMENT == 1) lobe = lobe_samples(s, p, v);
    for (int i = 0; i < light_count; ++i) {
#if AREA_LIGHTS == 1
        if (has_size(lamps[i])) {
            SeenLamp lamp = seen_lamp(lamps[i], s.position);
            if (SAMPLED_ENVIRONMENT == 1)
                add_sampled_lamp(lit, lamp, i, s, p, v, lobe);
            else
                add_area_lamp(lit, lamp, i, s, p, v);
            continue;
        }
#endif
        Incident light = incident_light(lamps[i], s.position);
        add_direct_light(lit, s, p, v, light.direction,
                         lamp_reaching(i, s, light.direction) * light.irradiance);
    }
    if (SAMPLED_ENVIRONMENT == 1)
        add_sampled_environment(lit, s, p, v, lobe);
    else
        add_filtered_environment(lit, s, p, v);
    return lit;
}

PhongMaterial traditional_material(Surface s) {
    PhongMaterial m =
        SHADING_MODEL == SHADING_PHONG
            ? phong_material(s.base_color, s.metalness, s.roughness, s.f0)
            : blinn_phong_material(s.base_color, s.metalness, s.roughness, s.f0);
    if (phong_exponent_override >= 0.0) m.exponent = phong_exponent_override;
    if (phong_specular_color_override.x >= 0.0) m.specular = phong_specular_color_override;
    m.specular *= phong_specular_strength;
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

/// The environment is what a fixed-function artist had: an ambient colour and a few lights, the
/// strongest of which casts a shadow.
Lit lit_traditional(Surface s, vec3 v) {
    Lit lit = Lit(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0));
    PhongMaterial m = traditional_material(s);
    lit.diffuse_ambient = ambient_radiance * m.diffuse * s.occlusion;
    float reaching = key_shadow < 0 ? 1.0
                                    : light_reaching(key_shadow, s.position, s.normal,
                                                     ambient_key_towards[0].xyz, picture_pixel());
    for (int i = 0; i < ambient_key_count; ++i)
        add_traditional_light(lit, m, s.normal, v, ambient_key_towards[i].xyz,
                              (i == 0 ? reaching : 1.0) * ambient_key_irradiance[i].rgb);
    for (int i = 0; i < light_count; ++i) {
        Incident light = incident_light(lamps[i], s.position);
        add_traditional_light(lit, m, s.normal, v, light.direction,
                              lamp_reaching(i, s, light.direction) * light.irradiance);
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
