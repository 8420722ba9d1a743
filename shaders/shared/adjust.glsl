// SPDX-License-Identifier: MIT
#ifndef SHARED_ADJUST_GLSL
#define SHARED_ADJUST_GLSL

#include "shared/blend_color.glsl"
#include "shared/mask.glsl"
#include "shared/ramp.glsl"

// Adjustments: what an adjustment layer makes of what lies below it. Colours and scalars of 0..1, in
// the layer's blend space; every result is in 0..1. Levels are those of mask.glsl. What names no
// source is Patina's own; tests/unit/composite/published_adjustments.cpp writes each definition apart.

/// A point of a curve and the slope there.
struct CurvePoint {
    float x, y;
    float slope;
};

/// A curve through two to eight points, x ascending; flat beyond the first and the last.
struct Curve {
    int count;
    CurvePoint points[8];
};

/// The curve at x: cubic Hermite pieces. With the slopes of engine/composite/curve_slopes.h, those of
/// Fritsch and Butland, 1984, it never overshoots.
Real curve_value(Curve curve, Real x) {
    Real value = Real(curve.points[0].y);
    for (int i = 1; i < curve.count; ++i) {
        float from = curve.points[i - 1].x;
        float width = max(curve.points[i].x - from, 1e-6f);
        Real t = clamp((x - from) * (1.0f / width), 0.0f, 1.0f);
        Real s = 1.0f - t;
        Real piece = s * s * ((1.0f + 2.0f * t) * curve.points[i - 1].y +
                              t * (width * curve.points[i - 1].slope)) +
                     t * t * ((1.0f + 2.0f * s) * curve.points[i].y -
                              s * (width * curve.points[i].slope));
        value = select(x >= from, piece, value);
    }
    return clamp(value, 0.0f, 1.0f);
}

/// Brightness is added, then contrast is stretched about the middle. Both -1 to 1; 0, 0 changes
/// nothing. Patina's own.
Real brightened(Real x, float brightness, float contrast) {
    Real moved = clamp(x + brightness, 0.0f, 1.0f);
    if (contrast == 0.0f) return moved;
    return contrasted(moved, contrast, 0.5f);
}

/// As many equal steps from 0 to 1: 2 is black and white. SVG 1.1, feComponentTransfer of type
/// "discrete" with a table of equal steps.
Real posterised(Real x, float steps) {
    return min(floor(x * steps), steps - 1.0f) * (1.0f / (steps - 1.0f));
}

/// The hue turned by that many sixths of a turn, 0 to 6: the components go round as the corners of
/// the colour cube do, which is the hue of Smith's hexcone (1978).
Real3 hue_turned(Real3 pure, float sixths) {
    Real3 turned = pure;
    float whole = floor(sixths);
    // A third of a turn renames the components; what is left is less than two sixths.
    if (whole >= 4.0f)
        turned = Real3(pure.y, pure.z, pure.x);
    else if (whole >= 2.0f)
        turned = Real3(pure.z, pure.x, pure.y);
    float rest = sixths - 2.0f * floor(sixths * 0.5f);
    // Where a pure hue is, 0 to 6.
    Real r = turned.x;
    Real g = turned.y;
    Real b = turned.z;
    Real most = greatest_component(turned);
    Real place = select(r >= most, select(b > 0.0f, 6.0f - b, g),
                        select(g >= most, select(r > 0.0f, 2.0f - r, 2.0f + b),
                               select(g > 0.0f, 4.0f - g, 4.0f + r)));
    place = place + rest;
    place = select(place >= 6.0f, place - 6.0f, place);
    return Real3(clamp(abs(place - 3.0f) - 1.0f, 0.0f, 1.0f),
                 clamp(2.0f - abs(place - 2.0f), 0.0f, 1.0f),
                 clamp(2.0f - abs(place - 4.0f), 0.0f, 1.0f));
}

/// Hue, saturation and lightness. sixths: the hue's turn, 0 to 6; saturation -1 (grey) to 1 (twice
/// as much); lightness -1 (black) to 1 (white). 0, 0, 0 changes nothing. The hue and saturation of
/// Smith's HSV; that the middle of HSL stays is Patina's own.
Real3 hue_saturation(Real3 color, float sixths, float saturation, float lightness) {
    Real value = greatest_component(color);
    Real amount = clamp(saturation_hsv(color) * (1.0f + saturation), 0.0f, 1.0f);
    Real3 pure = pure_hue(color);
    if (sixths != 0.0f) {
        // Grey has no hue to turn, and its saturation is 0 whatever the pure hue is.
        pure = hue_turned(pure, sixths);
    }
    Real3 changed = color_from_hsv(pure, amount, value);
    // Less saturation goes to the grey of the same middle, as in the HSL model.
    Real middle = 0.5f * (value + least_component(color));
    Real now = 0.5f * (greatest_component(changed) + least_component(changed));
    changed = clamp(changed + Real3(middle - now), 0.0f, 1.0f);
    float light = max(lightness, 0.0f);
    float dark = 1.0f + min(lightness, 0.0f);
    return changed * (dark * (1.0f - light)) + Real3(Real(light));
}

#endif
