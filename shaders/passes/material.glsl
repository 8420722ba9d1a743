// SPDX-License-Identifier: MIT
// What a fragment of a mesh is made of: textures and factors of its material, as glTF 2.0 states
// them, and the extensions KHR_texture_transform, _materials_ior, _specular, _emissive_strength.
// Laid out in engine/render/gpu_materials.cpp.

// Constants: TEXTURED_SLOTS, a bit for each slot that has a texture; FILTER_NORMALS, 1 where roughness
// takes in what of the normal map is finer than a pixel.

#include "shared/brdf.glsl"
#include "shared/normal_blend.glsl"

#ifndef FILTER_NORMALS
#define FILTER_NORMALS 0
#endif

in vec3 position_world;
in vec3 normal_world;
in vec4 tangent_world;
in vec4 uvs;
in vec4 vertex_color;

struct MaterialSlot {
    vec4 multiply;
    vec4 add;
    vec4 uv_row_u;  // w: the UV set
    vec4 uv_row_v;
};
layout(std140) uniform MaterialBlock {
    MaterialSlot slots[7];
    vec4 alpha;         // mode (0 opaque, 1 mask, 2 blend), cutoff, double-sided, unlit
    vec4 ior_emissive;  // IOR, emissive strength
} material;

uniform sampler2D base_color_map;
uniform sampler2D metallic_roughness_map;
uniform sampler2D normal_map;
uniform sampler2D occlusion_map;
uniform sampler2D emissive_map;
uniform sampler2D specular_map;
uniform sampler2D specular_color_map;
uniform float level_bias;  // of all of them: finer below 0

const int SLOT_BASE_COLOR = 0;
const int SLOT_METALLIC_ROUGHNESS = 1;
const int SLOT_NORMAL = 2;
const int SLOT_OCCLUSION = 3;
const int SLOT_EMISSIVE = 4;
const int SLOT_SPECULAR = 5;        // alpha: the factor
const int SLOT_SPECULAR_COLOR = 6;

struct Material {
    vec3 base_color;
    float alpha;
    float metalness;
    float roughness;
    vec3 normal;          // world, unit, towards the side that is seen
    vec3 surface_normal;  // the same without the normal map
    vec3 f0;
    float f90;
    float ior;
    vec3 emissive;
    float occlusion;
};

bool has_texture(int slot) {
    return (TEXTURED_SLOTS & (1 << slot)) != 0;
}

/// Where a slot reads its texture.
vec2 slot_uv(int slot) {
    vec4 row_u = material.slots[slot].uv_row_u;
    vec3 uv = vec3(row_u.w < 0.5 ? uvs.xy : uvs.zw, 1.0);
    return vec2(dot(row_u.xyz, uv), dot(material.slots[slot].uv_row_v.xyz, uv));
}

vec4 slot_value(int slot, sampler2D map) {
    vec4 texel = has_texture(slot) ? texture(map, slot_uv(slot), level_bias) : vec4(1.0);
    return texel * material.slots[slot].multiply + material.slots[slot].add;
}

struct ShadingNormal {
    vec3 world;      // unit
    vec3 surface;    // unit: without the map
    float variance;  // of the normals that it is the mean of
};

/// The normal map is in tangent space: x along the tangent (+U), y along the bitangent (up in the
/// picture), z out of the surface; alpha is the deviation of what a texel is the mean of. The back of
/// a double-sided surface is seen with all three turned.
ShadingNormal shading_normal() {
    vec3 surface = normalize(normal_world);
    vec3 normal = surface;
    float variance = 0.0;
    if (has_texture(SLOT_NORMAL) && tangent_world.w != 0.0) {
        vec4 stored = texture(normal_map, slot_uv(SLOT_NORMAL), level_bias);
        vec3 scale = material.slots[SLOT_NORMAL].multiply.xyz;
        vec3 mapped =
            signed_from_encoded(stored.xyz) * scale + material.slots[SLOT_NORMAL].add.xyz;
        float deviation = stored.a * scale.x;
        variance = deviation * deviation;
        // Not orthogonalised and not normalised one by one: MikkTSpace bakes are undone exactly so.
        vec3 bitangent = tangent_world.w * cross(normal_world, tangent_world.xyz);
        vec3 turned =
            mapped.x * tangent_world.xyz + mapped.y * bitangent + mapped.z * normal_world;
        normal = dot(turned, turned) > 0.0 ? normalize(turned) : normal;
    }
    float side = gl_FrontFacing ? 1.0 : -1.0;
    return ShadingNormal(side * normal, side * surface, variance);
}

/// What the surface leaves of the light that its normal map mirrors towards v (unit, to the eye).
/// 1 without a map, also where an interpolated normal is turned away from the eye.
float horizon_of(vec3 normal, vec3 surface_normal, vec3 v) {
    if (!has_texture(SLOT_NORMAL)) return 1.0;
    return horizon_share(dot(reflect(-v, normal), surface_normal));
}

Material sampled_material() {
    vec4 base = slot_value(SLOT_BASE_COLOR, base_color_map) * vertex_color;
    vec4 metallic_roughness = slot_value(SLOT_METALLIC_ROUGHNESS, metallic_roughness_map);
    Material m;
    m.base_color = clamp(base.rgb, 0.0, 1.0);
    m.alpha = material.alpha.x < 0.5 ? 1.0 : clamp(base.a, 0.0, 1.0);
    m.metalness = clamp(metallic_roughness.z, 0.0, 1.0);
    m.roughness = clamp(metallic_roughness.y, 0.0, 1.0);
    ShadingNormal normal = shading_normal();
    m.normal = normal.world;
    m.surface_normal = normal.surface;
    if (FILTER_NORMALS == 1 && normal.variance > 0.0)
        m.roughness = roughness_with_variance(m.roughness, normal.variance);
    m.ior = material.ior_emissive.x;
    float specular = slot_value(SLOT_SPECULAR, specular_map).a;
    vec3 specular_color = slot_value(SLOT_SPECULAR_COLOR, specular_color_map).rgb;
    m.f0 = material_f0(dielectric_f0(m.ior, specular, specular_color), m.base_color, m.metalness);
    m.f90 = material_f90(specular, m.metalness);
    m.emissive = slot_value(SLOT_EMISSIVE, emissive_map).rgb * material.ior_emissive.y;
    m.occlusion = clamp(slot_value(SLOT_OCCLUSION, occlusion_map).x, 0.0, 1.0);
    return m;
}

/// glTF's alpha mask: nothing is there where alpha is below the cutoff.
bool is_cut_out(float alpha) {
    return material.alpha.x > 0.5 && material.alpha.x < 1.5 && alpha < material.alpha.y;
}
