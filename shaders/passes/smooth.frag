// SPDX-License-Identifier: MIT
// Fast anti-aliasing of a finished picture: where luma shows an edge, a pixel is mixed with its
// neighbours along it. After Timothy Lottes, "FXAA", NVIDIA 2009, in its first and shortest form.

#include "shared/color.glsl"

uniform sampler2D picture;  // sRGB-encoded, read linearly between texels
uniform vec2 texel_size;    // 1 / size of the picture

layout(location = 0) out vec4 color;

const float LEAST_CONTRAST = 0.0312;     // absolute: below it noise is left alone
const float RELATIVE_CONTRAST = 0.125;   // of the brightest neighbour
const float LONGEST_BLUR = 8.0;          // texels

float luma_at(vec2 uv) {
    return luma_bt601(textureLod(picture, uv, 0.0).rgb);
}

void main() {
    vec2 uv = gl_FragCoord.xy * texel_size;
    vec4 middle = textureLod(picture, uv, 0.0);
    float m = luma_bt601(middle.rgb);
    float nw = luma_at(uv + vec2(-0.5, 0.5) * texel_size);
    float ne = luma_at(uv + vec2(0.5, 0.5) * texel_size);
    float sw = luma_at(uv + vec2(-0.5, -0.5) * texel_size);
    float se = luma_at(uv + vec2(0.5, -0.5) * texel_size);
    float low = min(m, min(min(nw, ne), min(sw, se)));
    float high = max(m, max(max(nw, ne), max(sw, se)));
    if (high - low < max(LEAST_CONTRAST, high * RELATIVE_CONTRAST)) {
        color = middle;
        return;
    }
    // Along the edge: across the gradient, longer where the edge is flatter.
    vec2 along = vec2(-((nw + ne) - (sw + se)), (nw + sw) - (ne + se));
    float shortest = min(abs(along.x), abs(along.y)) + (nw + ne + sw + se) * 0.03125 + 1e-3;
    along = clamp(along / shortest, -LONGEST_BLUR, LONGEST_BLUR) * texel_size;
    vec4 near = 0.5 * (textureLod(picture, uv - along / 6.0, 0.0) +
                       textureLod(picture, uv + along / 6.0, 0.0));
    vec4 wide = 0.5 * near + 0.25 * (textureLod(picture, uv - along * 0.5, 0.0) +
                                     textureLod(picture, uv + along * 0.5, 0.0));
    float wide_luma = luma_bt601(wide.rgb);
    color = wide_luma < low || wide_luma > high ? near : wide;
}
