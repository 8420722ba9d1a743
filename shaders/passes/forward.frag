// SPDX-License-Identifier: MIT
// Surfaces lit one by one as they are drawn: opaque ones on the forward path, and blended ones from
// the farthest on either path. Premultiplied. Constants: those of shading.glsl.

#include "passes/camera.glsl"
#include "passes/material.glsl"
#include "passes/shading.glsl"

layout(location = 0) out vec4 color;

void main() {
    Material m = sampled_material();
    if (is_cut_out(m.alpha)) discard;
    if (material.alpha.x < 1.5) m.alpha = 1.0;
    vec3 v = -ray_through(picture_pixel()).direction;
    Surface s = Surface(m.base_color, m.metalness, m.normal, m.roughness, m.f0, m.f90, m.emissive,
                        m.occlusion, horizon_of(m.normal, m.surface_normal, v), position_world,
                        material.alpha.w > 0.5);
    color = vec4(radiance_of(s, lit_surface(s, v)) * m.alpha, m.alpha);
}
