// SPDX-License-Identifier: MIT
#ifndef SHARED_TRANSCENDENTAL_GLSL
#define SHARED_TRANSCENDENTAL_GLSL

// Powers and angles by Patina's own polynomials, so that no library, driver or compiler version
// changes a texel. The coefficients are minimax fits (Remez exchange); each error is stated for
// correctly rounded float arithmetic, and tests/unit/shaders sweeps it.

const float PI = 3.14159265f;

/// 2^x. Relative error below 2e-7; exact for whole x. 0 below -126; x is held to 127.49 above.
Real exp2_poly(Real x) {
    Real held = clamp(x, -126.0f, 127.49f);
    Real whole = floor(held + 0.5f);
    Real f = held - whole;  // -0.5..0.5
    Real q = 0.00132647273f;
    q = q * f + 0.00967151299f;
    q = q * f + 0.0555073358f;
    q = q * f + 0.240222424f;
    q = q * f + 0.693147004f;
    Real scale = intBitsToFloat((Int(whole) + 127) << 23);
    return select(x < -126.0f, 0.0f, (1.0f + f * q) * scale);
}

/// log2(x) of a normal number x > 0. Absolute error below 1e-7 + 6e-8 |log2 x|; exact for powers of
/// two. -127 for 0 and below.
Real log2_poly(Real x) {
    Int bits = floatBitsToInt(max(x, 0.0f));
    Int exponent = (bits - 0x3f3504f3) >> 23;  // so that the mantissa is in sqrt(0.5)..sqrt(2)
    Real f = intBitsToFloat(bits - (exponent << 23)) - 1.0f;
    Real p = -0.145744562f;
    p = p * f + 0.236890405f;
    p = p * f - 0.250069022f;
    p = p * f + 0.286707461f;
    p = p * f - 0.360087216f;
    p = p * f + 0.480939448f;
    p = p * f - 0.721357167f;
    p = p * f + 1.44269478f;
    return Real(exponent) + f * p;
}

/// x^y for x >= 0 and a y that is not 0; 0 for x <= 0. Relative error below
/// 2e-7 + |y| (5e-8 + 8e-8 |log2 x|); exactly 1 for x = 1.
Real pow_poly(Real x, Real y) {
    return select(x > 0.0f, exp2_poly(y * log2_poly(x)), 0.0f);
}

/// sin(x), x in radians, |x| <= 8192. Absolute error below 2e-7 for |x| <= 100.
Real sin_poly(Real x) {
    Real half_turns = floor(x * 0.318309886f + 0.5f);
    // pi in three parts (Cody and Waite, 1980), the first two of which multiply exactly.
    Real r = x - half_turns * 3.140625f;
    r = r - half_turns * 9.67502593994140625e-4f;
    r = r - half_turns * 1.509957990978376e-7f;
    Real t = r * r;
    Real p = 2.59048852e-06f;
    p = p * t - 0.000198008973f;
    p = p * t + 0.00833289977f;
    p = p * t - 0.166666478f;
    Real sine = r + r * t * p;
    Real is_odd = half_turns - 2.0f * floor(half_turns * 0.5f);
    return sine * (1.0f - 2.0f * is_odd);
}

/// cos(x), x in radians, |x| <= 8192. Absolute error below 3e-7 for |x| <= 100.
Real cos_poly(Real x) {
    Real half_turns = floor(x * 0.318309886f);
    Real middle = half_turns + 0.5f;
    Real r = x - middle * 3.140625f;
    r = r - middle * 9.67502593994140625e-4f;
    r = r - middle * 1.509957990978376e-7f;
    Real t = r * r;
    Real p = 2.59048852e-06f;
    p = p * t - 0.000198008973f;
    p = p * t + 0.00833289977f;
    p = p * t - 0.166666478f;
    Real sine = r + r * t * p;
    Real is_odd = half_turns - 2.0f * floor(half_turns * 0.5f);
    return sine * (2.0f * is_odd - 1.0f);
}

/// The angle of (x, y) from the x axis, -pi..pi. Absolute error below 4e-7; 0 for (0, 0).
Real atan2_poly(Real y, Real x) {
    Real ax = abs(x);
    Real ay = abs(y);
    Real ratio = min(ax, ay) / max(max(ax, ay), 1e-30f);
    Real t = ratio * ratio;
    Real p = -0.00405455986f;
    p = p * t + 0.0218629371f;
    p = p * t - 0.0559123084f;
    p = p * t + 0.0964219719f;
    p = p * t - 0.139086306f;
    p = p * t + 0.199465662f;
    p = p * t - 0.333298594f;
    p = p * t + 0.999999344f;
    Real angle = ratio * p;
    angle = select(ay > ax, 0.5f * PI - angle, angle);
    angle = select(x < 0.0f, PI - angle, angle);
    return select(y < 0.0f, -angle, angle);
}

/// acos(x), 0..pi; x is held to -1..1. Absolute error below 5e-7; exactly 0 at 1.
Real acos_poly(Real x) {
    Real a = min(abs(x), 1.0f);
    Real p = 0.0026117214f;
    p = p * a - 0.0120033976f;
    p = p * a + 0.0277629159f;
    p = p * a - 0.0491974391f;
    p = p * a + 0.0888358876f;
    p = p * a - 0.214591086f;
    p = p * a + 1.57079625f;
    Real angle = sqrt(1.0f - a) * p;
    return select(x < 0.0f, PI - angle, angle);
}

#endif
