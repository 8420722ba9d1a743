// SPDX-License-Identifier: MIT
#ifndef SHARED_LAMP_GLSL
#define SHARED_LAMP_GLSL

#include "shared/transcendental.glsl"

// What of a lamp's light gets to a place. Windows are those of KHR_lights_punctual, beside the square
// of the distance.

/// 1 at the lamp, brought to 0 at its range ("Range Property"). Metres; a range of 0 reaches
/// everywhere.
Real range_window(Real metres, Real range) {
    Real share = min(metres / max(range, 1e-6f), 2.0f);
    Real share2 = share * share;
    return select(range > 0.0f, clamp(1.0f - share2 * share2, 0.0f, 1.0f), Real(1.0f));
}

/// Irradiance on what faces a sphere of radiance 1, as if all of its light came from its middle: pi at
/// its surface and within.
Real sphere_from_middle(Real distance2, Real radius) {
    Real radius2 = radius * radius;
    return PI * radius2 / max(distance2, radius2);
}

/// Likewise of a rectangle. cosine: of the angle between the way that it shines and the way from its
/// middle to the place; from behind it gives nothing. At most pi.
Real rectangle_from_middle(Real distance2, Real area, Real cosine) {
    return area * max(cosine, 0.0f) / max(distance2, area * (1.0f / PI));
}

/// What a spot sends in a direction, of what it sends ahead: 1 in the inner cone, 0 outside of the
/// outer one ("Inner and Outer Cone Angles"). cosine: of the angle to the way that it shines; scale:
/// 1 / (cos inner - cos outer); offset: -cos outer x scale.
Real cone_window(Real cosine, Real scale, Real offset) {
    Real share = clamp(cosine * scale + offset, 0.0f, 1.0f);
    return share * share;
}

#endif
