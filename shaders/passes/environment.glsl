// SPDX-License-Identifier: MIT
// Light from all around, as engine/render/environment.h filters it.

#include "shared/environment.glsl"

uniform samplerCube specular_environment;  // radiance convolved with GGX, rougher with each level
uniform samplerCube diffuse_environment;   // irradiance / pi
uniform sampler2D environment_brdf;        // scale and bias of F0 by n.v and roughness
uniform float environment_levels;          // of specular_environment
uniform mat3 environment_from_world;       // the rotation of the map
uniform float environment_intensity;

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

/// Scale (x) and bias (y) of F0 in the light that a surface mirrors of a white environment.
vec2 environment_albedo(float n_dot_v, float roughness) {
    return textureLod(environment_brdf, vec2(n_dot_v, roughness), 0.0).rg;
}
