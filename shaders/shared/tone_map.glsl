// SPDX-License-Identifier: MIT
#ifndef SHARED_TONE_MAP_GLSL
#define SHARED_TONE_MAP_GLSL

#include "shared/color.glsl"
#include "shared/transcendental.glsl"

// From scene to display: exposed linear Rec. 709 radiance, 0 and up, to linear light 0..1 of an
// sRGB display, still to be encoded. All map black to black, and brighter greys to brighter greys.

// In the order of ToneMap in engine/render/view.h.
const int TONE_MAP_NONE = 0;
const int TONE_MAP_REINHARD = 1;
const int TONE_MAP_ACES = 2;
const int TONE_MAP_AGX = 3;
const int TONE_MAP_PBR_NEUTRAL = 4;

/// Values above 1 are cut.
Real3 tone_map_none(Real3 color) {
    return clamp(color, 0.0f, 1.0f);
}

/// x / (1 + x). E. Reinhard and others, "Photographic tone reproduction for digital images", 2002.
Real3 tone_map_reinhard(Real3 color) {
    Real3 x = max(color, 0.0f);
    return x / (x + 1.0f);
}

/// The curve of the ACES fit below, for one channel.
Real aces_curve(Real x) {
    Real numerator = x * (x + 0.0245786f) - 0.000090537f;
    Real denominator = x * (0.983729f * x + 0.4329510f) + 0.238081f;
    return numerator / denominator;
}

/// Stephen Hill's fit of the ACES reference rendering and sRGB output transforms (2015, in
/// "BakingLab" of M. Pettineo and D. Neubelt): to the working primaries, a curve, and back.
Real3 tone_map_aces(Real3 color) {
    Real3 x = max(color, 0.0f);
    Real r = aces_curve(0.59719f * x.x + 0.35458f * x.y + 0.04823f * x.z);
    Real g = aces_curve(0.07600f * x.x + 0.90834f * x.y + 0.01566f * x.z);
    Real b = aces_curve(0.02840f * x.x + 0.13383f * x.y + 0.83777f * x.z);
    return clamp(Real3(1.60475f * r - 0.53108f * g - 0.07367f * b,
                       -0.10208f * r + 1.10813f * g - 0.00605f * b,
                       -0.00327f * r - 0.07276f * g + 1.07602f * b),
                 0.0f, 1.0f);
}

/// AgX's sigmoid for one channel of the working space: log2 from -12.47393 to 4.026069 stops, then
/// the contrast curve as a polynomial.
Real agx_curve(Real x) {
    Real stops = log2_poly(max(x, 1e-10f));
    Real t = clamp((stops + 12.47393f) * (1.0f / 16.5f), 0.0f, 1.0f);
    Real curve = 15.5f * t - 40.14f;
    curve = curve * t + 31.96f;
    curve = curve * t - 6.868f;
    curve = curve * t + 0.4298f;
    curve = curve * t + 0.1191f;
    return curve * t - 0.00232f;
}

/// AgX, base look. Troy Sobotka, 2022; this fit: Benjamin Wrensch, "Minimal AgX implementation",
/// 2023. Highlights lose their colour as film's do.
Real3 tone_map_agx(Real3 color) {
    Real3 x = max(color, 0.0f);
    Real r = agx_curve(0.842479062f * x.x + 0.0784336f * x.y + 0.0792237451f * x.z);
    Real g = agx_curve(0.0423282423f * x.x + 0.878468636f * x.y + 0.0791661275f * x.z);
    Real b = agx_curve(0.0423756549f * x.x + 0.0784336f * x.y + 0.879142974f * x.z);
    Real3 encoded = clamp(Real3(1.19687901f * r - 0.0980208811f * g - 0.0990297441f * b,
                                -0.0528968518f * r + 1.15190313f * g - 0.0989611768f * b,
                                -0.0529716355f * r - 0.0980434501f * g + 1.15107367f * b),
                          0.0f, 1.0f);
    return Real3(pow_poly(encoded.x, 2.2f), pow_poly(encoded.y, 2.2f), pow_poly(encoded.z, 2.2f));
}

/// Khronos PBR Neutral: base colours come out as they went in, but for the 0.04 that a dielectric
/// reflects; only highlights are compressed, towards white. Khronos Group, "PBR Neutral tone mapper
/// specification", 2024.
Real3 tone_map_pbr_neutral(Real3 color) {
    Real3 x = max(color, 0.0f);
    Real darkest = least_component(x);
    Real offset = select(darkest < 0.08f, darkest - 6.25f * darkest * darkest, 0.04f);
    Real3 base = x - Real3(offset);
    Real peak = greatest_component(base);
    const float start = 0.76f;  // 0.8 - F90's share
    const float room = 1.0f - start;
    Real new_peak = 1.0f - room * room / max(peak + (room - start), 1e-3f);
    Real3 compressed = base * (new_peak / max(peak, 1e-3f));
    Real to_white = 1.0f - 1.0f / (0.15f * max(peak - new_peak, 0.0f) + 1.0f);
    return select(peak < start, base, mix(compressed, Real3(new_peak), to_white));
}

/// The tone map TONE_MAP_...
Real3 tone_map(int kind, Real3 color) {
    if (kind == TONE_MAP_REINHARD) return tone_map_reinhard(color);
    if (kind == TONE_MAP_ACES) return tone_map_aces(color);
    if (kind == TONE_MAP_AGX) return tone_map_agx(color);
    if (kind == TONE_MAP_PBR_NEUTRAL) return tone_map_pbr_neutral(color);
    return tone_map_none(color);
}

#endif
