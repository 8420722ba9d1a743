// SPDX-License-Identifier: MIT
// How radiance becomes what a target holds.

#include "shared/color.glsl"
#include "shared/dither.glsl"
#include "shared/tone_map.glsl"

// Constants: OUTPUT_MODE, one of the following; TONE_MAP, one of shared/tone_map.glsl.

uniform float exposure;  // 2^EV

const int OUTPUT_SRGB = 0;      // what a screen shows, in 8 bits
const int OUTPUT_DISPLAY = 1;   // the same in linear light: stills average this
const int OUTPUT_RADIANCE = 2;  // as it is, before exposure; channels as they are stored

/// Radiance as a screen shows it, in linear light, 0 to 1.
vec3 displayed(vec3 radiance) {
    return clamp(tone_map(TONE_MAP, radiance * exposure), 0.0, 1.0);
}

/// Half a byte of noise against banding in smooth gradients; the same in every frame.
float dither(vec2 pixel) {
    return (interleaved_gradient_noise(floor(pixel)) - 0.5) / 255.0;
}

/// Linear light on the screen, as the target holds it. Colours are premultiplied by alpha.
vec4 display_output(vec3 color, float alpha, vec2 pixel) {
    if (OUTPUT_MODE != OUTPUT_SRGB) return vec4(color, alpha);
    return vec4(srgb_from_linear(color) + dither(pixel), alpha);
}

vec4 radiance_output(vec3 radiance, float alpha, vec2 pixel) {
    if (OUTPUT_MODE == OUTPUT_RADIANCE) return vec4(radiance, alpha);
    return display_output(displayed(radiance), alpha, pixel);
}
