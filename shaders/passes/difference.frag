// SPDX-License-Identifier: MIT
// |luminance left - luminance right| of two pictures, as a heat map. Constants: those of
// output.glsl.

#include "passes/camera.glsl"
#include "passes/output.glsl"
#include "shared/heat_map.glsl"

uniform sampler2D left;   // radiance before exposure, the sum of some draws
uniform sampler2D right;
uniform float radiance_share;    // of one draw
uniform float difference_range;  // of exposed luminance: the top of the map

layout(location = 0) out vec4 color;

void main() {
    ivec2 texel = ivec2(picture_pixel());
    vec4 a = texelFetch(left, texel, 0);
    vec4 b = texelFetch(right, texel, 0);
    float difference = exposure * radiance_share * abs(luminance(a.rgb) - luminance(b.rgb));
    if (OUTPUT_MODE == OUTPUT_RADIANCE) {
        color = vec4(vec3(difference), 1.0);
        return;
    }
    vec3 encoded = heat_map_inferno(clamp(difference / difference_range, 0.0, 1.0));
    color = vec4(OUTPUT_MODE == OUTPUT_SRGB ? encoded : linear_from_srgb(encoded), 1.0);
}
