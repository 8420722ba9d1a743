// SPDX-License-Identifier: MIT
// What casts a shadow: all but what an alpha mask cuts out. Depth is all that is written.

#include "passes/material.glsl"

void main() {
    if (is_cut_out(slot_value(SLOT_BASE_COLOR, base_color_map).a * vertex_color.a)) discard;
}
