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

vec3 inspected_value(float alpha) {
    if (inspected == INSPECT_ALPHA) return vec3(alpha);
    if (inspected == INSPECT_TANGENT)
        return tangent_world.w == 0.0 ? vec3(0.0) : normalize(tangent_world.xyz);
    if (inspected == INSPECT_GEOMETRIC_NORMAL)
        return normalize(cross(dFdx(position_world), dFdy(position_world)));
    if (inspected == INSPECT_UV0) return vec3(uvs.xy, 0.0);
    if (inspected == INSPECT_UV1) return vec3(uvs.zw, 0.0);
    return ids;
}

void main() {
    float alpha = slot_value(SLOT_BASE_COLOR, base_color_map).a * vertex_color.a;
    alpha = material.alpha.x < 0.5 ? 1.0 : clamp(alpha, 0.0, 1.0);
    if (is_cut_out(alpha)) discard;
    value = vec4(inspected_value(alpha), 1.0);
}
