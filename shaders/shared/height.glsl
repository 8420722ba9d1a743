// SPDX-License-Identifier: MIT
#ifndef SHARED_HEIGHT_GLSL
#define SHARED_HEIGHT_GLSL

#include "shared/mask.glsl"

// Heights: signed, 0 is the surface, unclamped; and the normals that they bend.

/// Signed add. Commutative; 0 is neutral.
Real height_add(Real backdrop, Real source) {
    return backdrop + source;
}

/// The higher of the two. Commutative; equal heights return themselves.
Real height_max(Real backdrop, Real source) {
    return max(backdrop, source);
}

/// The lower of the two. Commutative; equal heights return themselves.
Real height_min(Real backdrop, Real source) {
    return min(backdrop, source);
}

/// What lies below less the source. 0 is neutral.
Real height_subtract(Real backdrop, Real source) {
    return backdrop - source;
}

const int RELIEF_HEIGHT = 0;
const int RELIEF_CAVITY = 1;
const int RELIEF_EDGE = 2;
const int RELIEF_CURVATURE = 3;

/// What a height is like among its surroundings, 0..1: of kind RELIEF_HEIGHT how high (0.5 at the
/// surface), else how far below or above their mean (0 where it is level; curvature: 0.5, and lower
/// in cavities). `around`: the mean. A difference from a blur is the curvature at its scale:
/// D. Marr and E. Hildreth, "Theory of edge detection", Proc. R. Soc. Lond. B 207, 1980.
Real relief_value(int kind, Real own, Real around, float strength) {
    if (kind == RELIEF_HEIGHT) return clamp(own * (0.5f * strength) + 0.5f, 0.0f, 1.0f);
    Real lift = (own - around) * strength;
    if (kind == RELIEF_CAVITY) return clamp(-lift, 0.0f, 1.0f);
    if (kind == RELIEF_EDGE) return clamp(lift, 0.0f, 1.0f);
    return clamp(lift * 0.5f + 0.5f, 0.0f, 1.0f);
}

/// Which share of a surface a layer of height `source` has, where it lies among what has height
/// `backdrop`: 0.5 where they are level, 1 (or 0) where the layer is higher (lower) by the radius or
/// more. Rises with the layer; the shares of two layers that change places add up to 1.
/// offset: added to the layer's height; radius, contrast: 0..1, the latter of the share about 0.5.
/// Andrey Mishkinis, "Advanced Terrain Texture Splatting", 2013, its blend of two layers by depth:
/// each counts by how far it reaches above the higher one less the depth, which is the radius here.
Real height_share(Real backdrop, Real source, float offset, float radius, float contrast) {
    float depth = max(radius, 1e-6f);
    Real lead = source + offset - backdrop;
    Real own = clamp(lead + depth, 0.0f, depth);
    Real other = clamp(depth - lead, 0.0f, depth);
    return contrasted(own / (own + other), contrast, 0.5f);
}

/// Slope per texel across three columns of three heights, of which the outer two are given:
/// Sobel's operator, which is exact for planes. Irwin Sobel, 1968.
/// Arguments: the column (or row) before, in order, then the one after.
Real height_slope(Real before_a, Real before_b, Real before_c, Real after_a, Real after_b,
                  Real after_c) {
    Real rise = (after_a - before_a) + 2.0f * (after_b - before_b) + (after_c - before_c);
    return rise * 0.125f;
}

/// The tangent-space normal of a height field with these slopes, height gained per length to the
/// right (+u) and up (-v in glTF's texture coordinates, +Y of the tangent frame).
/// Slopes of 0 give flat; exact for planes.
Real3 height_normal(Real slope_right, Real slope_up) {
    Real scale = inversesqrt(slope_right * slope_right + slope_up * slope_up + 1.0f);
    return Real3(-slope_right * scale, -slope_up * scale, scale);
}

#endif
