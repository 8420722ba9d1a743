// SPDX-License-Identifier: MIT
// How the numbers of a channel are shown. Constants: CHANNEL, a render::ChannelView as below;
// CHANNEL_DISPLAY, its render::ChannelDisplay; CHANNEL_IS_INSPECTION, 1 where an inspection pass
// drew it.

#include "passes/output.glsl"
#include "shared/color.glsl"
#include "shared/normal_blend.glsl"

uniform vec3 range_low;   // ChannelDisplay::Range: what is black
uniform vec3 range_high;  // what is white

const int CHANNEL_FINAL = 0;
const int CHANNEL_BASE_COLOR = 1;
const int CHANNEL_METALNESS = 2;
const int CHANNEL_ROUGHNESS = 3;
const int CHANNEL_NORMAL_WORLD = 4;
const int CHANNEL_F0 = 5;
const int CHANNEL_POSITION = 6;
const int CHANNEL_DEPTH = 7;
const int CHANNEL_OCCLUSION = 8;
const int CHANNEL_EMISSIVE = 9;
const int CHANNEL_NORMAL_VIEW = 11;
const int CHANNEL_IOR = 14;
const int CHANNEL_UV0 = 15;
const int CHANNEL_UV1 = 16;
const int CHANNEL_DIFFUSE_DIRECT = 17;
const int CHANNEL_SPECULAR_DIRECT = 18;
const int CHANNEL_DIFFUSE_AMBIENT = 19;
const int CHANNEL_SPECULAR_AMBIENT = 20;
const int CHANNEL_TERM_D = 21;
const int CHANNEL_TERM_F = 22;
const int CHANNEL_TERM_G = 23;

const int DISPLAY_PICTURE = 0;
const int DISPLAY_COLOR = 1;
const int DISPLAY_SCALAR = 2;
const int DISPLAY_DIRECTION = 3;
const int DISPLAY_RANGE = 4;
const int DISPLAY_LIGHT = 5;

/// The bytes that a screen is sent, 0 to 1.
vec3 encoded_channel(vec3 value) {
    if (CHANNEL_DISPLAY == DISPLAY_COLOR) {
        vec3 shown = CHANNEL == CHANNEL_UV0 || CHANNEL == CHANNEL_UV1 ? fract(value) : value;
        return srgb_from_linear(clamp(shown, 0.0, 1.0));
    }
    if (CHANNEL_DISPLAY == DISPLAY_DIRECTION) return encoded_from_signed(value);
    if (CHANNEL_DISPLAY == DISPLAY_RANGE)
        return clamp((value - range_low) / (range_high - range_low), 0.0, 1.0);
    return clamp(value, 0.0, 1.0);
}

vec4 channel_output(vec3 value, float alpha, vec2 pixel) {
    if (CHANNEL_DISPLAY == DISPLAY_PICTURE || CHANNEL_DISPLAY == DISPLAY_LIGHT)
        return radiance_output(value, alpha, pixel);
    if (OUTPUT_MODE == OUTPUT_RADIANCE) return vec4(value, alpha);
    vec3 encoded = encoded_channel(value);
    return vec4(OUTPUT_MODE == OUTPUT_SRGB ? encoded : linear_from_srgb(encoded), alpha);
}
