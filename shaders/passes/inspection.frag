// SPDX-License-Identifier: MIT
// What the lighting does not need but a person may want to see. Drawn only when it is looked at.

#include "passes/material.glsl"

layout(location = 0) out vec4 value;  // alpha is coverage

uniform int inspected;  // INSPECT_...
uniform vec3 ids;       // instance, primitive, material

const int INSPECT_ALPHA = 0;
const int INSPECT_TANGENT = 1;
const int INSPECT_GEOMETRIC_NORMAL = 2;
const int INSPECT_UV0 = 3;
const int INSPECT_UV1 = 4;
const int INSPECT_IDS = 5;
const int INSPECT_UV_CHECKER = 6;

const float CHECKER_SQUARES = 8.0;  // along u and along v

/// The mean over a pixel of a wave that is -1 and 1 by turns, each for 1 of x.
float filtered_square_wave(float x, float pixel_width) {
    // Its integral is a triangle wave.
    vec2 ends = x + vec2(-0.5, 0.5) * pixel_width;
    vec2 integral = abs(fract(0.5 * ends) * 2.0 - 1.0);
    return clamp((integral.x - integral.y) / max(pixel_width, 1e-6), -1.0, 1.0);
}

/// Squares in two tones; warm to cool along u and darker to lighter along v, so that each part of
/// the map is known and a mirrored one stands out. Linear.
vec3 uv_checker(vec2 uv) {
    vec2 squares = uv * CHECKER_SQUARES;
    vec2 width = fwidth(squares);
    float parity = filtered_square_wave(squares.x, width.x) *
                   filtered_square_wave(squares.y, width.y);
    vec2 place = fract(uv);
    vec3 tint = mix(vec3(1.0, 0.62, 0.34), vec3(0.34, 0.62, 1.0), place.x);
    return tint * mix(0.45, 1.0, 1.0 - place.y) * (0.5 + 0.32 * parity);
}

vec3 inspected_value(float alpha) {
    if (inspected == INSPECT_ALPHA) return vec3(alpha);
    if (inspected == INSPECT_TANGENT)
        return tangent_world.w == 0.0 ? vec3(0.0) : normalize(tangent_world.xyz);
    if (inspected == INSPECT_GEOMETRIC_NORMAL)
        return normalize(cross(dFdx(position_world), dFdy(position_world)));
    if (inspected == INSPECT_UV0) return vec3(uvs.xy, 0.0);
    if (inspected == INSPECT_UV1) return vec3(uvs.zw, 0.0);
    if (inspected == INSPECT_UV_CHECKER) return uv_checker(uvs.xy);
    return ids;
}

void main() {
    float alpha = slot_value(SLOT_BASE_COLOR, base_color_map).a * vertex_color.a;
    alpha = material.alpha.x < 0.5 ? 1.0 : clamp(alpha, 0.0, 1.0);
    if (is_cut_out(alpha)) discard;
    value = vec4(inspected_value(alpha), 1.0);
}
