// SPDX-License-Identifier: MIT
// Lays one picture over another, texel on texel.

uniform sampler2D picture;  // premultiplied
uniform ivec2 offset;       // of its first texel in the target

layout(location = 0) out vec4 color;

void main() {
    color = texelFetch(picture, ivec2(gl_FragCoord.xy) - offset, 0);
}
