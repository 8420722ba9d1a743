// SPDX-License-Identifier: MIT
#ifndef SHARED_BLEND_COLOR_GLSL
#define SHARED_BLEND_COLOR_GLSL

#include "shared/color.glsl"

// Blend modes that look at all three components of a colour: B(backdrop, source). Two families,
// which mean different things by the same words and so carry the family in their names.
//
// backdrop, source: colours of 0..1 in the layer's blend space; so is every result.

// The luminosity family: W3C Compositing and Blending Level 1, #blendingnonseparable, which is that
// of ISO 32000 (PDF) and of Adobe Photoshop.

/// The luminosity Lum(C) of W3C: weights 0.3, 0.59, 0.11 on the components as they are.
Real luminosity_w3c(Real3 color) {
    return 0.3f * color.x + 0.59f * color.y + 0.11f * color.z;
}

/// ClipColor(C) of W3C: towards the grey of the same luminosity until no component is outside 0..1.
Real3 clipped_color_w3c(Real3 color) {
    Real grey = luminosity_w3c(color);
    Real low = least_component(color);
    Real high = greatest_component(color);
    Real scale_low = select(low < 0.0f, grey / max(grey - low, 1e-20f), 1.0f);
    Real scale_high = select(high > 1.0f, (1.0f - grey) / max(high - grey, 1e-20f), 1.0f);
    return Real3(grey) + (color - Real3(grey)) * min(scale_low, scale_high);
}

/// SetLum(C, l) of W3C: the colour moved to that luminosity.
Real3 with_luminosity_w3c(Real3 color, Real luminosity) {
    return clipped_color_w3c(color + Real3(luminosity - luminosity_w3c(color)));
}

/// Sat(C) of W3C: the greatest component less the least.
Real saturation_w3c(Real3 color) {
    return greatest_component(color) - least_component(color);
}

/// SetSat(C, s) of W3C: the components stretched to 0..s; grey, which has none, gives black.
Real3 with_saturation_w3c(Real3 color, Real saturation) {
    Real range = saturation_w3c(color);
    Real scale = select(range > 0.0f, saturation / max(range, 1e-20f), 0.0f);
    return (color - Real3(least_component(color))) * scale;
}

/// Hue: the source's hue with the backdrop's saturation and luminosity. W3C #blendinghue.
Real3 blend_hue_w3c(Real3 backdrop, Real3 source) {
    return with_luminosity_w3c(with_saturation_w3c(source, saturation_w3c(backdrop)),
                               luminosity_w3c(backdrop));
}

/// Saturation: the source's saturation with the backdrop's hue and luminosity.
/// W3C #blendingsaturation. A grey backdrop stays.
Real3 blend_saturation_w3c(Real3 backdrop, Real3 source) {
    return with_luminosity_w3c(with_saturation_w3c(backdrop, saturation_w3c(source)),
                               luminosity_w3c(backdrop));
}

/// Colour: the source's hue and saturation with the backdrop's luminosity. W3C #blendingcolor.
Real3 blend_color_w3c(Real3 backdrop, Real3 source) {
    return with_luminosity_w3c(source, luminosity_w3c(backdrop));
}

/// Luminosity: the source's luminosity with the backdrop's hue and saturation.
/// W3C #blendingluminosity. Colour with the roles exchanged.
Real3 blend_luminosity_w3c(Real3 backdrop, Real3 source) {
    return with_luminosity_w3c(backdrop, luminosity_w3c(source));
}

// The HSV family: hue, saturation (1 - least / greatest) and value (the greatest component) of
// Alvy Ray Smith, "Color gamut transform pairs", SIGGRAPH 1978, as 3D painting programs have it.

/// The pure hue of a colour: the components stretched to 0..1; white for grey, which has none.
Real3 pure_hue(Real3 color) {
    Real range = greatest_component(color) - least_component(color);
    Real3 stretched = (color - Real3(least_component(color))) * (1.0f / max(range, 1e-20f));
    return select(range > 0.0f, stretched, Real3(1.0f, 1.0f, 1.0f));
}

/// Saturation of the HSV model, 0..1; 0 for black.
Real saturation_hsv(Real3 color) {
    Real value = greatest_component(color);
    return select(value > 0.0f, (value - least_component(color)) / max(value, 1e-20f), 0.0f);
}

/// The colour of a pure hue at this saturation and value.
Real3 color_from_hsv(Real3 hue, Real saturation, Real value) {
    return (Real3(1.0f - saturation) + hue * saturation) * value;
}

/// Tint: the source's hue with the backdrop's saturation and value. A grey source gives grey.
Real3 blend_tint_hsv(Real3 backdrop, Real3 source) {
    return color_from_hsv(pure_hue(source), saturation_hsv(backdrop), greatest_component(backdrop));
}

/// Saturation, HSV: the source's saturation with the backdrop's hue and value. Grey backdrops stay.
Real3 blend_saturation_hsv(Real3 backdrop, Real3 source) {
    return color_from_hsv(pure_hue(backdrop), saturation_hsv(source), greatest_component(backdrop));
}

/// Colour, HSV: the source's hue and saturation with the backdrop's value.
Real3 blend_color_hsv(Real3 backdrop, Real3 source) {
    return color_from_hsv(pure_hue(source), saturation_hsv(source), greatest_component(backdrop));
}

/// Value: the source's value with the backdrop's hue and saturation. Black backdrops become grey.
Real3 blend_value_hsv(Real3 backdrop, Real3 source) {
    return color_from_hsv(pure_hue(backdrop), saturation_hsv(backdrop), greatest_component(source));
}

#endif
