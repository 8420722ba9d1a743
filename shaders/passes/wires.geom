// SPDX-License-Identifier: MIT
// Gives each corner of a triangle its distance, in pixels, from the opposite edge; in between the
// fragment shader has the distances from all three. After Baerentzen et al., "Single-pass wireframe
// rendering", SIGGRAPH 2006 sketches.

layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;

uniform vec2 picture_size;  // pixels

noperspective out vec3 edge_distances;  // pixels

void main() {
    vec2 corners[3];
    bool behind = false;
    for (int i = 0; i < 3; ++i) {
        vec4 clip = gl_in[i].gl_Position;
        behind = behind || clip.w <= 0.0;
        corners[i] = 0.5 * picture_size * clip.xy / clip.w;
    }
    vec2 a = corners[2] - corners[1];
    vec2 b = corners[0] - corners[2];
    vec2 c = corners[1] - corners[0];
    float twice_area = abs(a.x * b.y - a.y * b.x);
    vec3 heights = twice_area / max(vec3(length(a), length(b), length(c)), 1e-6);
    // A triangle that reaches behind the eye has no distances on the screen: no wires either.
    if (behind) heights = vec3(1e6);
    for (int i = 0; i < 3; ++i) {
        edge_distances = behind ? heights : vec3(0.0);
        edge_distances[i] = heights[i];
        gl_Position = gl_in[i].gl_Position;
        EmitVertex();
    }
    EndPrimitive();
}
