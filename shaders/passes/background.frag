// SPDX-License-Identifier: MIT
// Where there is no surface: the background of the picture, or what stands behind a channel.
// Constants: those of background.glsl; CHANNEL_BACKGROUND, 1 behind a channel.

#include "passes/background.glsl"

layout(location = 0) out vec4 color;

// The editor's dark grey, so that black is seen.
const float CHANNEL_BACKGROUND_SRGB = 0.086;

vec4 channel_background() {
    if (OUTPUT_MODE == OUTPUT_RADIANCE) return vec4(0.0);
    vec3 encoded = vec3(CHANNEL_BACKGROUND_SRGB);
    return vec4(OUTPUT_MODE == OUTPUT_SRGB ? encoded : linear_from_srgb(encoded), 1.0);
}

void main() {
    color = CHANNEL_BACKGROUND == 1 ? channel_background() : background_output(picture_pixel());
}
