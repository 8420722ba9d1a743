// SPDX-License-Identifier: MIT
#include "shaders/probes.glsl"

uniform int which;
uniform sampler2D inputs_a;
uniform sampler2D inputs_b;

layout(location = 0) out vec4 result;
layout(location = 1) out vec4 canary;

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    result = probe(which, texelFetch(inputs_a, texel, 0), texelFetch(inputs_b, texel, 0));
    canary = vec4(float(which), gl_FragCoord.xy, 1234.5);
}
