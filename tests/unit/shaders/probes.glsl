// SPDX-License-Identifier: MIT
// Calls of the shared formulae, as a text that is GLSL and C++ like they are: lanes_test.cpp runs it
// over SIMD lanes and one value at a time, gpu_test.cpp in a fragment shader, and both compare.
// probes.h names the probes in this order and says how far the GPU may be off.
#ifndef PROBES_GLSL
#define PROBES_GLSL

#include "shared/blend.glsl"
#include "shared/compositing.glsl"

/// Probe number `which` of inputs a and b, each component 0..1.
Real4 probe(int which, Real4 a, Real4 b) {
    if (which == 0)
        return Real4(blend_normal(a.x, b.x), blend_multiply(a.x, b.x), blend_screen(a.x, b.x),
                     blend_add(a.x, b.x));
    if (which == 1)
        return Real4(blend_hard_light(a.x, b.x), blend_overlay(a.x, b.x),
                     blend_soft_light_w3c(a.x, b.x), blend_subtract(a.x, b.x));
    if (which == 2)
        return Real4(blend_darken(a.x, b.x), blend_lighten(a.x, b.x), blend_difference(a.x, b.x),
                     over_coverage(a.x, b.x));
    if (which == 3)
        return Real4(over_premultiplied(a.x, a.y, b.x, b.y, b.z), unpremultiplied(a.x, b.x),
                     over_opaque(a.x, b.x, b.y), 0.0f);
    return Real4(-1.0f);
}

#endif
