// SPDX-License-Identifier: MIT
// The vertices of a mesh, for every pass that draws surfaces.

layout(location = 0) in vec3 position_local;
layout(location = 1) in vec3 normal_local;
layout(location = 2) in vec4 tangent_local;  // w: sign of the bitangent; 0 where there is no tangent
layout(location = 3) in vec4 uvs_local;      // TEXCOORD_0, TEXCOORD_1
layout(location = 4) in vec4 color_local;

uniform mat4 world_from_local;
uniform mat3 normal_world_from_local;  // the inverse transpose
uniform float handedness;              // -1 where world_from_local mirrors
uniform mat4 clip_from_world;

out vec3 position_world;
out vec3 normal_world;
out vec4 tangent_world;
out vec4 uvs;
out vec4 vertex_color;

void main() {
    vec4 world = world_from_local * vec4(position_local, 1.0);
    position_world = world.xyz;
    // Unit here and not after interpolation: that is how MikkTSpace bakes normal maps.
    normal_world = normalize(normal_world_from_local * normal_local);
    vec3 tangent = mat3(world_from_local) * tangent_local.xyz;
    tangent_world = vec4(tangent * inversesqrt(max(dot(tangent, tangent), 1e-30)),
                         tangent_local.w * handedness);
    uvs = uvs_local;
    vertex_color = color_local;
    gl_Position = clip_from_world * world;
}
