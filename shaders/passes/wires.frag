// SPDX-License-Identifier: MIT
// The edges of triangles as smooth lines over the picture, and nothing between them.

noperspective in vec3 edge_distances;  // pixels

uniform vec4 line_color;  // sRGB-encoded as the picture, and how much it covers

layout(location = 0) out vec4 color;

const float HALF_WIDTH = 0.5;  // pixels; both triangles at an edge draw their half of it

void main() {
    float nearest = min(min(edge_distances.x, edge_distances.y), edge_distances.z);
    float coverage = line_color.a * (1.0 - smoothstep(HALF_WIDTH - 0.5, HALF_WIDTH + 0.5, nearest));
    color = vec4(line_color.rgb * coverage, coverage);
}
