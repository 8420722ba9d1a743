// SPDX-License-Identifier: MIT
// Light from all around, as engine/render/environment.h filters it.
#include "shared/environment.glsl"

uniform samplerCube specular_environment;  // radiance convolved with GGX, rougher with each level
uniform samplerCube diffuse_environment;   // irradiance / pi
uniform sampler2D environment_brdf;        // by n.v and roughness, see environment_brdf_of
uniform sampler2D diffuse_brdf;            // likewise, of the diffuse terms but Lambert's
uniform float environment_levels;          // of specular_environment
uniform mat3 environment_from_world;       // the rotation of the map
uniform float environment_intensity;

// What is small and bright in the map is not in the filtered levels but the first.
const int MOST_SUNS = 4;
uniform int sun_count;
uniform vec4 sun_towards[MOST_SUNS];     // unit, of the map; w: radius in radians
uniform vec4 sun_irradiance[MOST_SUNS];  // on a surface that faces it; w: cosine of its reach

/// Radiance from a direction, seen by a surface of that roughness.
vec3 environment_radiance(vec3 direction_world, float roughness) {
    float level = prefiltered_level_share(roughness) * (environment_levels - 1.0);
    return environment_intensity *
           textureLod(specular_environment, environment_from_world * direction_world, level).rgb;
}

/// What a white Lambert surface sends out.
vec3 environment_diffuse(vec3 normal_world) {
    return environment_intensity *
           textureLod(diffuse_environment, environment_from_world * normal_world, 0.0).rgb;
}

/// How a surface mirrors the environment: see engine/render/environment_brdf.h.
struct EnvironmentBrdf {
    float scale;
    float bias;
    float tangent_scale;
    float level_share;
};

EnvironmentBrdf environment_brdf_of(float n_dot_v, float roughness) {
    vec4 texel = textureLod(environment_brdf, vec2(n_dot_v, roughness), 0.0);
    return EnvironmentBrdf(texel.x, texel.y, texel.z, texel.w);
}

/// How much of the suns is missing in a level, 0 to 1.
float suns_missing(float level_share) {
    return clamp(level_share * (environment_levels - 1.0), 0.0, 1.0);
}

/// Radiance from a direction and around it, as the filtered levels would show it with their suns.
vec3 environment_blurred(vec3 direction_world, float roughness) {
    vec3 direction = environment_from_world * direction_world;
    vec3 suns = vec3(0.0);
    for (int i = 0; i < sun_count; ++i)
        suns += sun_irradiance[i].rgb *
                disc_in_level(dot(direction, sun_towards[i].xyz), roughness, sun_towards[i].w);
    return environment_radiance(direction_world, roughness) +
           environment_intensity * suns_missing(prefiltered_level_share(roughness)) * suns;
}

/// The filtered radiance, without suns, that a surface with unit normal n mirrors towards v.
vec3 environment_mirrored(EnvironmentBrdf brdf, vec3 n, vec3 v) {
    vec3 r = reflect(-v, n);
    vec3 tangential = brdf.tangent_scale * (r - dot(n, r) * n);
    vec3 direction = tangential + sqrt(max(1.0 - dot(tangential, tangential), 0.0)) * n;
    float level = brdf.level_share * (environment_levels - 1.0);
    return environment_intensity *
           textureLod(specular_environment, environment_from_world * direction, level).rgb;
}
