// SPDX-License-Identifier: MIT
// The deferred pass: reads the G-buffer, lights it, and writes the picture or one channel of it.
// Only where there is a surface: background.frag draws the rest.
// Constants: those of shading.glsl and output.glsl; CHANNEL, a render::ChannelView; SURFACE_TARGET,
// 1 where the G-buffer has that target.

#include "passes/channels.glsl"
#include "passes/shading.glsl"
#include "passes/stored_normal.glsl"

uniform sampler2D albedo;
uniform sampler2D normal_roughness;
uniform sampler2D specular_ior;
uniform sampler2D emissive_occlusion;
uniform sampler2D surface_target;
uniform sampler2D depth;
uniform sampler2D inspection;

uniform vec3 camera_forward;
uniform ivec2 gbuffer_pixel_override;  // >= 0: every pixel shows that one, as a probe wants

layout(location = 0) out vec4 color;

vec2 shown_pixel() {
    return gbuffer_pixel_override.x >= 0 ? vec2(gbuffer_pixel_override) + 0.5 : picture_pixel();
}

Surface read_surface(ivec2 texel, vec3 position) {
    vec4 base_metal = texelFetch(albedo, texel, 0);
    vec4 normal_rough = texelFetch(normal_roughness, texel, 0);
    vec4 emissive_ao = texelFetch(emissive_occlusion, texel, 0);
    Surface s;
    s.base_color = base_metal.rgb;
    s.metalness = base_metal.a;
    float stored = length(normal_rough.xyz);
    s.normal = normal_rough.xyz / stored;
    s.horizon = stored_horizon(stored);
    s.roughness = normal_rough.w;
    s.f0 = texelFetch(specular_ior, texel, 0).rgb;
    s.emissive = emissive_ao.rgb;
    s.occlusion = emissive_ao.a;
    s.position = position;
    vec4 flags = SURFACE_TARGET == 1 ? texelFetch(surface_target, texel, 0) : vec4(1.0, 0.0, 1.0, 0.0);
    s.f90 = flags.x;
    s.unlit = flags.w > 0.5;
    return s;
}

/// What the channel CHANNEL holds.
vec3 channel_value(ivec2 texel, Surface s, Ray ray) {
    vec3 v = -ray.direction;
    if (CHANNEL == CHANNEL_BASE_COLOR) return s.base_color;
    if (CHANNEL == CHANNEL_METALNESS) return vec3(s.metalness);
    if (CHANNEL == CHANNEL_ROUGHNESS) return vec3(s.roughness);
    if (CHANNEL == CHANNEL_NORMAL_WORLD) return s.normal;
    if (CHANNEL == CHANNEL_F0) return s.f0;
    if (CHANNEL == CHANNEL_POSITION) return s.position;
    if (CHANNEL == CHANNEL_DEPTH)
        return vec3(dot(s.position - camera_position, camera_forward));
    if (CHANNEL == CHANNEL_OCCLUSION) return vec3(s.occlusion);
    if (CHANNEL == CHANNEL_EMISSIVE) return s.emissive;
    if (CHANNEL == CHANNEL_NORMAL_VIEW) return mat3(view_from_world) * s.normal;
    if (CHANNEL == CHANNEL_IOR) return vec3(texelFetch(specular_ior, texel, 0).a);

    if (CHANNEL == CHANNEL_TERM_D || CHANNEL == CHANNEL_TERM_F || CHANNEL == CHANNEL_TERM_G) {
        ReflectionAngles angles = reflection_angles(s.normal, v, key_direction);
        float alpha = alpha_from_roughness(s.roughness);
        if (CHANNEL == CHANNEL_TERM_D)
            return vec3(distribution(DISTRIBUTION, angles.n_dot_h, alpha));
        if (CHANNEL == CHANNEL_TERM_F) return fresnel(FRESNEL, angles.v_dot_h, s.f0, s.f90);
        return vec3(4.0 * angles.n_dot_l * angles.n_dot_v *
                    visibility(GEOMETRY, angles.n_dot_l, angles.n_dot_v, alpha));
    }

    Lit lit = lit_surface(s, v);
    if (CHANNEL == CHANNEL_DIFFUSE_DIRECT) return lit.diffuse_direct;
    if (CHANNEL == CHANNEL_SPECULAR_DIRECT) return lit.specular_direct;
    if (CHANNEL == CHANNEL_DIFFUSE_AMBIENT) return lit.diffuse_ambient;
    if (CHANNEL == CHANNEL_SPECULAR_AMBIENT) return lit.specular_ambient;
    return radiance_of(s, lit);
}

void main() {
    vec2 pixel = shown_pixel();
    ivec2 texel = ivec2(pixel);
    if (CHANNEL_IS_INSPECTION == 1) {
        color = channel_output(texelFetch(inspection, texel, 0).rgb, 1.0, pixel);
        return;
    }
    float depth_ndc = texelFetch(depth, texel, 0).r * 2.0 - 1.0;
    vec3 position = world_at(pixel, depth_ndc);
    vec3 value = channel_value(texel, read_surface(texel, position), ray_through(pixel));
    color = channel_output(value, 1.0, pixel);
}
