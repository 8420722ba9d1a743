// SPDX-License-Identifier: MIT
#ifndef SHARED_BLEND_GLSL
#define SHARED_BLEND_GLSL

// Separable blend modes: B(backdrop, source) for one scalar, one function per mode, all of one
// shape. How much of it is laid over the backdrop is decided afterwards, in compositing.glsl.
//
// backdrop, source: 0..1, in the channel's blend space (sRGB-encoded or linear colour, plain
// scalars). Every mode maps 0..1 x 0..1 into 0..1: what a sum, a difference or a quotient has
// beyond is held there, as W3C asks for and as every editor with 8 or 16 bits does. So what lies
// below a layer is always what is seen there, whichever space the layer blends in.
//
// "W3C" is W3C Compositing and Blending Level 1, https://www.w3.org/TR/compositing-1/#blending,
// which gives the definitions of ISO 32000 (PDF). "PEGTOP" is "Photoshop blend modes" (Jens
// Gruschel, 2006), which states those of Adobe Photoshop that the standards leave out.

/// Normal: the source. W3C #blendingnormal. Independent of the backdrop.
Real blend_normal(Real backdrop, Real source) {
    return source;
}

/// Darken. W3C #blendingdarken. Commutative; 1 is neutral; equal arguments return themselves.
Real blend_darken(Real backdrop, Real source) {
    return min(backdrop, source);
}

/// Multiply. W3C #blendingmultiply. Commutative; 1 is neutral; never brighter than either.
Real blend_multiply(Real backdrop, Real source) {
    return backdrop * source;
}

/// Colour burn. W3C #blendingcolorburn. Source 1 and backdrop 1 return the backdrop.
Real blend_color_burn(Real backdrop, Real source) {
    Real burnt = 1.0f - min((1.0f - backdrop) / max(source, 1e-30f), 1.0f);
    return select(backdrop >= 1.0f, 1.0f, burnt);
}

/// Linear burn: the sum less 1, at least 0. PEGTOP "inverse color burn, linear burn" (subtractive).
/// Commutative; 1 is neutral.
Real blend_linear_burn(Real backdrop, Real source) {
    return max(backdrop + source - 1.0f, 0.0f);
}

/// Lighten. W3C #blendinglighten. Commutative; 0 is neutral; equal arguments return themselves.
Real blend_lighten(Real backdrop, Real source) {
    return max(backdrop, source);
}

/// Screen: multiply of the complements. W3C #blendingscreen. Commutative; 0 is neutral, 1 gives 1.
Real blend_screen(Real backdrop, Real source) {
    return backdrop + source - backdrop * source;
}

/// Colour dodge. W3C #blendingcolordodge. Source 0 and backdrop 0 return the backdrop.
Real blend_color_dodge(Real backdrop, Real source) {
    Real dodged = min(backdrop / max(1.0f - source, 1e-30f), 1.0f);
    return select(backdrop <= 0.0f, 0.0f, dodged);
}

/// Add, also called linear dodge: the sum, at most 1. PEGTOP "additive". Commutative; 0 is neutral.
Real blend_add(Real backdrop, Real source) {
    return min(backdrop + source, 1.0f);
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

/// Soft light, W3C form. Source 0.5 returns the backdrop; backdrops 0 and 1 stay.
/// W3C #blendingsoftlight.
Real blend_soft_light_w3c(Real backdrop, Real source) {
    Real ramp = ((16.0f * backdrop - 12.0f) * backdrop + 4.0f) * backdrop;
    Real curve = select(backdrop <= 0.25f, ramp, sqrt(backdrop));
    Real towards = select(source <= 0.5f, backdrop - backdrop * backdrop, curve - backdrop);
    return backdrop + (source + source - 1.0f) * towards;
}

/// Soft light, PEGTOP's form, (1 - 2s) b^2 + 2 s b, which has no break. Source 0.5 returns the
/// backdrop; backdrops 0 and 1 stay. PEGTOP "soft light".
Real blend_soft_light_pegtop(Real backdrop, Real source) {
    return backdrop + (source + source - 1.0f) * (backdrop - backdrop * backdrop);
}

/// Vivid light: burns by dark sources, dodges by light ones. PEGTOP "vivid light".
/// Source 0.5 returns the backdrop.
Real blend_vivid_light(Real backdrop, Real source) {
    Real twice = source + source;
    return select(source <= 0.5f, blend_color_burn(backdrop, twice),
                  blend_color_dodge(backdrop, twice - 1.0f));
}

/// Linear light: linear burn by dark sources, add of light ones. PEGTOP "linear light".
/// Source 0.5 returns the backdrop.
Real blend_linear_light(Real backdrop, Real source) {
    return clamp(backdrop + (source + source - 1.0f), 0.0f, 1.0f);
}

/// Pin light: darkens with dark sources, lightens with light ones. PEGTOP "pin light".
/// Source 0.5 returns the backdrop.
Real blend_pin_light(Real backdrop, Real source) {
    Real twice = source + source;
    return select(source <= 0.5f, min(backdrop, twice), max(backdrop, twice - 1.0f));
}

/// Hard mix: 1 where the sum reaches 1, else 0. Adobe Photoshop, "Blending mode descriptions".
/// Commutative.
Real blend_hard_mix(Real backdrop, Real source) {
    return select(backdrop + source >= 1.0f, Real(1.0f), Real(0.0f));
}

/// Difference. W3C #blendingdifference. Commutative; 0 is neutral; equal arguments give 0.
Real blend_difference(Real backdrop, Real source) {
    return abs(backdrop - source);
}

/// Exclusion. W3C #blendingexclusion. Commutative; 0 is neutral, 1 inverts.
Real blend_exclusion(Real backdrop, Real source) {
    return backdrop + source - 2.0f * (backdrop * source);
}

/// Subtract: the backdrop less the source, at least 0. Adobe Photoshop "subtract". 0 is neutral.
Real blend_subtract(Real backdrop, Real source) {
    return max(backdrop - source, 0.0f);
}

/// Inverse subtract: the source less the backdrop, at least 0. Krita "inverse subtract" has the
/// complement of the source there; Substance 3D Painter has this. Backdrop 0 returns the source.
Real blend_inverse_subtract(Real backdrop, Real source) {
    return max(source - backdrop, 0.0f);
}

/// Divide: the backdrop over the source, at most 1; black stays black. Adobe Photoshop "divide".
/// 1 is neutral.
Real blend_divide(Real backdrop, Real source) {
    return min(backdrop / max(source, 1e-30f), 1.0f);
}

/// Inverse divide: the source over the backdrop, at most 1. Divide with the roles exchanged.
Real blend_inverse_divide(Real backdrop, Real source) {
    return blend_divide(source, backdrop);
}

/// Signed add: the source's distance from 0.5 is added. OpenGL, ARB_texture_env_combine,
/// "ADD_SIGNED". Commutative; 0.5 is neutral.
Real blend_signed_add(Real backdrop, Real source) {
    return clamp(backdrop + (source - 0.5f), 0.0f, 1.0f);
}

/// Average. PEGTOP "average". Commutative; equal arguments return themselves.
Real blend_average(Real backdrop, Real source) {
    return 0.5f * (backdrop + source);
}

#endif
