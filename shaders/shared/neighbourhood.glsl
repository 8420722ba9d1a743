// SPDX-License-Identifier: MIT
#ifndef SHARED_NEIGHBOURHOOD_GLSL
#define SHARED_NEIGHBOURHOOD_GLSL

#include "shared/noise.glsl"
#include "shared/transcendental.glsl"

// What the adjustments that look at neighbours are made of. They are sums over texels, which the
// compositor takes; here is what each texel counts for.

/// What a texel `distance` texels away counts in a blur that reaches `radius` texels, before the
/// weights are made to sum up to 1: a Gaussian whose standard deviation is a third of the radius,
/// lowered so that it ends at 0 there and no texel comes in at once as the radius grows.
/// distance: 0 or more; radius: more than 0. The Gaussian filter of W3C Filter Effects 1,
/// #feGaussianBlurElement.
Real blur_weight(Real distance, float radius) {
    Real t = distance * (3.0f / radius);
    // exp(-t^2 / 2) as a power of two, and what it is at the radius.
    return max(exp2_poly(t * t * -0.72134752f) - 0.011108997f, 0.0f);
}

/// Unsharp mask: what a blur takes away is added `amount` times. 0 changes nothing.
/// GIMP, "Sharpen (Unsharp Mask)"; J. A. C. Yule, "Unsharp masking", Photographic Journal 84, 1944.
Real sharpened(Real value, Real blurred, float amount) {
    return value + (value - blurred) * amount;
}

/// How far a warp moves a place, -1..1 in both directions: two noises that know nothing of each
/// other. position: in cells, which tile every `period`; footprint: the width of a texel in cells.
/// Ken Perlin, "An image synthesizer", SIGGRAPH 1985, displaces by a noise of vectors.
Real2 warp_direction(Real2 position, int period, uint seed, int octaves, float footprint) {
    Real x = fbm(NOISE_PERLIN, position, period, derived_seed(seed, 16), octaves, 0.5f, footprint);
    Real y = fbm(NOISE_PERLIN, position, period, derived_seed(seed, 17), octaves, 0.5f, footprint);
    return Real2(x * 2.0f - 1.0f, y * 2.0f - 1.0f);
}

#endif
