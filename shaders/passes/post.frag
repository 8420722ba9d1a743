// SPDX-License-Identifier: MIT
// Radiance with coverage becomes the picture, over the background. Constants: those of output.glsl
// and background.glsl.

#include "passes/background.glsl"

uniform sampler2D radiance;     // premultiplied, the sum of some draws
uniform ivec2 radiance_offset;  // of the picture within it
uniform float radiance_share;   // of one draw

layout(location = 0) out vec4 color;

void main() {
    vec2 pixel = picture_pixel();
    vec4 light = radiance_share * texelFetch(radiance, ivec2(pixel) + radiance_offset, 0);
    float behind = 1.0 - light.a;
    if (background_is_light()) {
        color = radiance_output(light.rgb + behind * environment_backdrop(pixel), 1.0, pixel);
        return;
    }
    vec4 backdrop = background_display(pixel);
    float alpha = light.a + behind * backdrop.a;
    if (OUTPUT_MODE == OUTPUT_RADIANCE) {
        color = vec4(light.rgb + behind * backdrop.rgb, alpha);
        return;
    }
    vec3 surface = displayed(light.rgb / max(light.a, 1e-4)) * light.a;
    color = display_output(surface + behind * backdrop.rgb, alpha, pixel);
}
