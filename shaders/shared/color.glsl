// SPDX-License-Identifier: MIT
#ifndef SHARED_COLOR_GLSL
#define SHARED_COLOR_GLSL

// Transfer between linear light and sRGB-encoded values, and single numbers of a colour. Primaries
// are those of Rec. 709 / sRGB throughout Patina.

/// The greatest number that a half float holds (IEEE 754, binary16): what is stored in such is held
/// to it.
const float LARGEST_HALF = 65504.0f;

/// Linear light 0..1 of an sRGB-encoded value; what is outside is held to 0..1. IEC 61966-2-1.
/// Error below 6e-7 of the encoded value that it stands for (a 16-bit step is 1.5e-5); exactly 0 at
/// 0 and 1 at 1; decoding and encoding each of the 256 bytes returns it.
/// With t = (s + 0.055) / 1.055 and v = sqrt(t) the curve is t^2 v^0.8, and a short polynomial
/// follows v^0.8 where t^2.4 needs twice the degree.
Real linear_from_srgb(Real encoded) {
    Real s = clamp(encoded, 0.0f, 1.0f);
    Real t = s * 0.947867299f + 0.0521327014f;
    Real v = sqrt(t);
    Real w = -0.0934455842f;
    w = w * v + 0.362722188f;
    w = w * v - 0.597119331f;
    w = w * v + 0.565491915f;
    w = w * v - 0.405060083f;
    w = w * v + 0.967347801f;
    Real curve = t * t * (1.0f + (v - 1.0f) * w);
    return select(s <= 0.04045f, s * 0.0773993808f, curve);
}

/// sRGB-encoded value 0..1 of linear light; what is outside is held to 0..1. IEC 61966-2-1.
/// Absolute error below 3e-6, a fifth of a 16-bit step; exactly 0 at 0 and 1 at 1.
/// With u = x^(1/4) the curve is 1.055 u^(5/3) - 0.055, again for a short polynomial.
Real srgb_from_linear(Real linear) {
    Real x = clamp(linear, 0.0f, 1.0f);
    Real u = sqrt(sqrt(x));
    Real q = 0.0648733303f;
    q = q * u - 0.243785337f;
    q = q * u + 0.403202981f;
    q = q * u - 0.44559446f;
    q = q * u + 0.920197129f;
    q = q * u + 1.05949533f;
    Real curve = 1.0f + (u - 1.0f) * q;
    return select(x <= 0.0031308f, x * 12.92f, curve);
}

Real3 linear_from_srgb(Real3 encoded) {
    return Real3(linear_from_srgb(encoded.x), linear_from_srgb(encoded.y),
                 linear_from_srgb(encoded.z));
}

Real3 srgb_from_linear(Real3 linear) {
    return Real3(srgb_from_linear(linear.x), srgb_from_linear(linear.y),
                 srgb_from_linear(linear.z));
}

/// Luminance Y of linear colour, the second row of Rec. 709's RGB-to-XYZ matrix. White gives 1.
Real luminance(Real3 linear) {
    return 0.2126f * linear.x + 0.7152f * linear.y + 0.0722f * linear.z;
}

/// Luma Y' of a colour as it is stored, sRGB-encoded: Recommendation ITU-R BT.601, 2.5.1. White
/// gives 1.
Real luma_bt601(Real3 encoded) {
    return 0.299f * encoded.x + 0.587f * encoded.y + 0.114f * encoded.z;
}

/// The least and the greatest component.
Real least_component(Real3 color) {
    return min(min(color.x, color.y), color.z);
}
Real greatest_component(Real3 color) {
    return max(max(color.x, color.y), color.z);
}

#endif
