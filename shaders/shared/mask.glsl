// SPDX-License-Identifier: MIT
#ifndef SHARED_MASK_GLSL
#define SHARED_MASK_GLSL

#include "shared/transcendental.glsl"

// Masks: 0 hides, 1 shows. Entries are adjusted, joined to what is there by the modes of blend.glsl
// and laid over by opacity.

/// Levels: in_low..in_high is stretched to 0..1 and held there, raised to 1 / gamma and put into
/// out_low..out_high. As in raster editors (GIMP, "Levels"); in_low = in_high is a threshold.
/// The defaults 0, 1, 1, 0, 1 return x of 0..1 unchanged.
Real levels(Real x, float in_low, float in_high, float gamma, float out_low, float out_high) {
    float width = in_high - in_low;
    // A flat input range divides by a tiny number of the same sign: all or nothing.
    float slope = 1.0f / (width < 0.0f ? min(width, -1e-6f) : max(width, 1e-6f));
    Real t = clamp((x - in_low) * slope, 0.0f, 1.0f);
    if (gamma != 1.0f) t = pow_poly(t, 1.0f / gamma);
    return mix(out_low, out_high, t);
}

/// The complement. Twice returns x.
Real inverted(Real x) {
    return 1.0f - x;
}

/// The end of a mask, once all of its entries are joined: held to 0..1, then inverted or not.
Real finished_mask(Real joined, bool invert) {
    Real mask = clamp(joined, 0.0f, 1.0f);
    if (invert) mask = inverted(mask);
    return mask;
}

/// Contrast about a balance that stays: -1 is flat there, 0 changes nothing, 1 is a threshold.
/// x, balance: 0..1; the result is held to 0..1. Patina's own.
Real contrasted(Real x, float contrast, float balance) {
    float slope = contrast < 0.0f ? 1.0f + contrast : 1.0f / max(1.0f - contrast, 1e-4f);
    return clamp((x - balance) * slope + balance, 0.0f, 1.0f);
}

#endif
