// SPDX-License-Identifier: MIT
#ifndef SHARED_BLEND_GLSL
#define SHARED_BLEND_GLSL

// Separable blend modes: B(backdrop, source) for one scalar, one function per mode, all of one
// shape. How much of it is laid over the backdrop is decided afterwards, in compositing.glsl.
//
// backdrop, source: in the channel's blend space (sRGB-encoded or linear colour, plain scalars).
// Every mode maps 0..1 x 0..1 into 0..1, but for add, which may exceed 1, and subtract, which may
// go below 0: a caller whose channel ends there clamps once, at the end of the stack.
//
// "W3C" is W3C Compositing and Blending Level 1, https://www.w3.org/TR/compositing-1/#blending,
// which gives the definitions of ISO 32000 (PDF). The others are those of Adobe Photoshop, as
// PEGTOP, "Photoshop blend modes" (Jens Gruschel, 2006), states them.

/// Normal: the source. W3C #blendingnormal. Independent of the backdrop.
Real blend_normal(Real backdrop, Real source) {
    return source;
}

/// Multiply. W3C #blendingmultiply. Commutative; 1 is neutral; never brighter than either.
Real blend_multiply(Real backdrop, Real source) {
    return backdrop * source;
}

/// Screen: multiply of the complements. W3C #blendingscreen. Commutative; 0 is neutral, 1 gives 1.
Real blend_screen(Real backdrop, Real source) {
    return backdrop + source - backdrop * source;
}

/// Hard light: multiply by dark sources, screen with light ones. W3C #blendinghardlight.
/// Source 0.5 returns the backdrop; continuous there.
Real blend_hard_light(Real backdrop, Real source) {
    Real twice = source + source;
    Real lighter = blend_screen(backdrop, twice - 1.0f);
    return select(source <= 0.5f, backdrop * twice, lighter);
}

/// Overlay: hard light with the roles exchanged. W3C #blendingoverlay.
/// Backdrops 0 and 1 stay; source 0.5 returns the backdrop.
Real blend_overlay(Real backdrop, Real source) {
    return blend_hard_light(source, backdrop);
}

/// Add, also called linear dodge; unclamped. PEGTOP "additive". Commutative; 0 is neutral.
Real blend_add(Real backdrop, Real source) {
    return backdrop + source;
}

/// Subtract: the source taken from the backdrop; unclamped. PEGTOP "subtractive" has the complement
/// of the source here. Source 0 is neutral; adding the source again returns the backdrop.
Real blend_subtract(Real backdrop, Real source) {
    return backdrop - source;
}

/// Soft light, W3C form. Source 0.5 returns the backdrop; backdrops 0 and 1 stay.
/// W3C #blendingsoftlight.
Real blend_soft_light_w3c(Real backdrop, Real source) {
    Real ramp = ((16.0f * backdrop - 12.0f) * backdrop + 4.0f) * backdrop;
    Real curve = select(backdrop <= 0.25f, ramp, sqrt(backdrop));
    Real towards = select(source <= 0.5f, backdrop - backdrop * backdrop, curve - backdrop);
    return backdrop + (source + source - 1.0f) * towards;
}

/// Darken. W3C #blendingdarken. Commutative; 1 is neutral; equal arguments return themselves.
Real blend_darken(Real backdrop, Real source) {
    return min(backdrop, source);
}

/// Lighten. W3C #blendinglighten. Commutative; 0 is neutral; equal arguments return themselves.
Real blend_lighten(Real backdrop, Real source) {
    return max(backdrop, source);
}

/// Difference. W3C #blendingdifference. Commutative; 0 is neutral; equal arguments give 0.
Real blend_difference(Real backdrop, Real source) {
    return abs(backdrop - source);
}

#endif
