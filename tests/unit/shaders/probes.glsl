// SPDX-License-Identifier: MIT
// Calls of the shared formulae, as a text that is GLSL and C++ like they are: lanes_test.cpp runs it
// over SIMD lanes and one value at a time, gpu_test.cpp in a fragment shader, and both compare.
// probes.h names the probes in this order and says how far the GPU may be off.
#ifndef PROBES_GLSL
#define PROBES_GLSL

#include "shared/blend.glsl"
#include "shared/color.glsl"
#include "shared/compositing.glsl"
#include "shared/height.glsl"
#include "shared/mask.glsl"
#include "shared/noise.glsl"
#include "shared/normal_blend.glsl"
#include "shared/ramp.glsl"
#include "shared/transcendental.glsl"

/// A unit normal of the upper half-space, at most 70 degrees from flat.
Real3 probe_normal(Real4 a) {
    return unit_normal(Real3(a.x * 2.0f - 1.0f, a.y * 2.0f - 1.0f, a.z + 0.5f));
}

Ramp probe_ramp() {
    Ramp ramp;
    ramp.count = 3;
    for (int i = 0; i < 8; ++i) {
        ramp.stops[i].position = float(i) * 0.5f;
        ramp.stops[i].x = float(i) * 0.25f;
        ramp.stops[i].y = float((i * 3) & 3);
        ramp.stops[i].z = 1.0f - float(i);
    }
    return ramp;
}

Real4 probe_blend(int which, Real4 a, Real4 b) {
    if (which == 0)
        return Real4(blend_normal(a.x, b.x), blend_multiply(a.x, b.x), blend_screen(a.x, b.x),
                     blend_add(a.x, b.x));
    if (which == 1)
        return Real4(blend_hard_light(a.x, b.x), blend_overlay(a.x, b.x),
                     blend_soft_light_w3c(a.x, b.x), blend_subtract(a.x, b.x));
    if (which == 2)
        return Real4(blend_darken(a.x, b.x), blend_lighten(a.x, b.x), blend_difference(a.x, b.x),
                     over_coverage(a.x, b.x));
    return Real4(over_premultiplied(a.x, a.y, b.x, b.y, b.z), unpremultiplied(a.x, b.x),
                 over_opaque(a.x, b.x, b.y), 0.0f);
}

Real4 probe_surface(int which, Real4 a, Real4 b) {
    if (which == 0)
        return Real4(srgb_from_linear(a.x), linear_from_srgb(a.x), luminance(Real3(a.x, a.y, a.z)),
                     linear_from_srgb(Real3(b.x, b.y, b.z)).y);
    if (which == 1)
        return Real4(normal_blend_rnm(probe_normal(a), probe_normal(b)), height_add(a.w, b.w));
    if (which == 2)
        return Real4(normal_blend_udn(probe_normal(a), normal_faded(probe_normal(b), a.w)),
                     height_max(a.w, b.w));
    if (which == 3)
        return Real4(normal_blend_whiteout(probe_normal(a), probe_normal(b)),
                     height_slope(a.x, a.y, a.z, b.x, b.y, b.z));
    if (which == 4)
        return Real4(normal_over(normal_from_encoded(Real3(a.x, a.y, 0.9f)), probe_normal(b), b.w),
                     encoded_from_normal(height_normal(a.z, b.z)).x);
    if (which == 5)
        return Real4(levels(a.x, 0.25f, 0.75f, 1.0f, 0.0f, 1.0f),
                     levels(a.y, 0.1f, 0.8f, 2.2f, 1.0f, 0.2f), contrasted(a.z, 0.5f, 0.25f),
                     contrasted(inverted(a.w), -0.5f, 0.75f));
    if (which == 6)
        return Real4(mask_add(a.x, b.x), mask_subtract(a.x, b.x),
                     mask_lighten(a.y, mask_multiply(a.x, b.x)),
                     mask_darken(a.y, mask_replace(a.x, b.x)));
    return Real4(ramp_color(probe_ramp(), a.x), ramp_scalar(probe_ramp(), b.x));
}

Real4 probe_number(int which, Real4 a, Real4 b) {
    if (which == 0)
        return Real4(exp2_poly(a.x * 40.0f - 20.0f), log2_poly(a.y + 1e-6f),
                     pow_poly(a.z, b.z * 4.0f + 0.1f), acos_poly(a.w * 2.0f - 1.0f));
    return Real4(sin_poly(a.x * 20.0f - 10.0f), cos_poly(a.y * 20.0f - 10.0f),
                 atan2_poly(a.z - 0.5f, b.z - 0.5f), 0.0f);
}

Real4 probe_noise(int which, Real4 a, Real4 b) {
    Real2 position = Real2(a.x * 40.0f - 8.0f, b.x * 40.0f - 8.0f);
    if (which == 0)
        return Real4(value_noise(position, 16, 1u), perlin_noise(position, 16, 2u),
                     worley_noise(position, 16, 3u), 0.0f);
    return Real4(fbm(NOISE_VALUE, position, 7, 4u, 4, 0.5f, 0.0f),
                 fbm(NOISE_PERLIN, position, 16, 5u, 5, 0.6f, 0.05f),
                 fbm(NOISE_WORLEY, position, 3, 6u, 3, 0.5f, 0.1f), 0.0f);
}

/// Probe number `which` of inputs a and b, each component 0..1; -1 past the last one.
Real4 probe(int which, Real4 a, Real4 b) {
    if (which < 4) return probe_blend(which, a, b);
    if (which < 12) return probe_surface(which - 4, a, b);
    if (which < 14) return probe_number(which - 12, a, b);
    if (which < 16) return probe_noise(which - 14, a, b);
    return Real4(-1.0f);
}

#endif
