// SPDX-License-Identifier: MIT
// Where a pixel looks. `pixel` counts from the lower left corner of the picture, centres at .5.

uniform mat4 world_from_clip;
uniform mat4 view_from_world;
uniform vec3 camera_position;
uniform vec2 picture_size;
uniform ivec2 picture_offset;  // of the picture within the target

vec2 picture_pixel() {
    return gl_FragCoord.xy - vec2(picture_offset);
}

vec3 world_at(vec2 pixel, float depth_ndc) {
    vec4 world = world_from_clip * vec4(pixel / picture_size * 2.0 - 1.0, depth_ndc, 1.0);
    return world.xyz / world.w;
}

struct Ray {
    vec3 origin;
    vec3 direction;  // unit
};

Ray ray_through(vec2 pixel) {
    vec3 origin = world_at(pixel, -1.0);
    return Ray(origin, normalize(world_at(pixel, 1.0) - origin));
}
