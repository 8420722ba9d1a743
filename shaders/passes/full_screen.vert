// SPDX-License-Identifier: MIT
// One triangle over the whole target, without vertices, at the far plane: a depth test tells pixels
// with a surface from those behind all of them.

void main() {
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    gl_Position = vec4(corner, 1.0, 1.0);
}
