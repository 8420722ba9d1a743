// SPDX-License-Identifier: MIT
// Writes all that the lighting needs to know of a surface. Targets as in
// gbuffer_description of engine/render/geometry_passes.cpp.

#include "passes/material.glsl"
#include "passes/stored_normal.glsl"
#include "shared/color.glsl"

layout(location = 0) out vec4 albedo;              // base colour, metalness
layout(location = 1) out vec4 normal_roughness;    // world, as long as stored_length() says; roughness
layout(location = 2) out vec4 specular_ior;        // F0, IOR
layout(location = 3) out vec4 emissive_occlusion;  // emissive, ambient occlusion
#ifdef SURFACE_TARGET
layout(location = 4) out vec4 surface;  // F90 weight, -, alpha, 1 when unlit
#endif

uniform vec4 eye_world;  // w 1: where the eye is; w 0: the way to it, unit

void main() {
    Material m = sampled_material();
    if (is_cut_out(m.alpha)) discard;
    albedo = vec4(m.base_color, m.metalness);
    vec3 v = normalize(eye_world.xyz - eye_world.w * position_world);
    float horizon = horizon_of(m.normal, m.surface_normal, v);
    normal_roughness = vec4(m.normal * stored_length(horizon), m.roughness);
    specular_ior = vec4(m.f0, m.ior);
    emissive_occlusion = vec4(min(m.emissive, vec3(LARGEST_HALF)), m.occlusion);
#ifdef SURFACE_TARGET
    surface = vec4(m.f90, 0.0, m.alpha, material.alpha.w);
#endif
}
