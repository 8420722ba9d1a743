// SPDX-License-Identifier: MIT
#ifndef SHARED_PHONG_GLSL
#define SHARED_PHONG_GLSL

#include "shared/color.glsl"
#include "shared/transcendental.glsl"

// The traditional models, in the units of a fixed-function pipeline: light x (diffuse x (n.l) +
// specular x lobe) + ambient x diffuse, where a light's colour is its irradiance / pi.
// Bui Tuong Phong, "Illumination for computer generated pictures", 1975; James F. Blinn, "Models of
// light reflection for computer synthesized pictures", 1977.

struct PhongMaterial {
    Real3 diffuse;   // linear, 0..1
    Real3 specular;  // linear, 0..1
    Real exponent;
};

/// What of a lobe is left under a light near the horizon: nothing from behind, all of it from 14
/// degrees on. A wide lobe that were simply cut off there would end in an edge across the surface.
Real lobe_above_horizon(Real n_dot_l) {
    return clamp(4.0f * n_dot_l, 0.0f, 1.0f);
}

/// Phong's lobe: the light's mirror direction against the eye's. 0 where the light is behind.
Real phong_lobe(Real r_dot_v, Real n_dot_l, Real exponent) {
    return lobe_above_horizon(n_dot_l) * pow_poly(r_dot_v, exponent);
}

/// Blinn's lobe: the half vector against the normal. 0 where the light is behind.
Real blinn_phong_lobe(Real n_dot_h, Real n_dot_l, Real exponent) {
    return lobe_above_horizon(n_dot_l) * pow_poly(n_dot_h, exponent);
}

// The conversion from a metal-roughness material. A highlight is as wide as GGX's: at the angle
// where the lobe has fallen to one half, so has GGX's distribution D,
//   (cos^2 (a^2 - 1) + 1)^2 = 2 a^4,  so  tan^2 = a^2 (sqrt 2 - 1) / (1 - sqrt 2 a^2),  a: alpha.
// From alpha^2 = 1 / sqrt 2 (roughness 0.92) GGX never falls so far; there the exponent is 1, its
// least. The greatest belong to roughness 0.17: with lights that are points a narrower highlight
// would fall between the pixels, and a mirror would show none at all.

const float MOST_BLINN_PHONG_EXPONENT = 4096.0f;
const float MOST_PHONG_EXPONENT = 1024.0f;  // as wide: its angle is twice that between n and h

/// tan^2 of the angle between n and h at which GGX has fallen to one half.
Real half_maximum_tangent2(Real alpha) {
    Real alpha2 = alpha * alpha;
    return alpha2 * 0.414213562f / max(1.0f - 1.41421356f * alpha2, 1e-6f);
}

/// log2(1 + t), t >= 0, also for t so small that 1 + t is 1.
Real log2_one_plus(Real t) {
    Real series = t * (1.44269504f - t * (0.721347520f - t * 0.480898347f));
    return select(t < 0.01f, series, log2_poly(1.0f + t));
}

/// Blinn-Phong's exponent e: cos^e is one half at that angle between n and h.
Real blinn_phong_exponent(Real roughness) {
    Real t = half_maximum_tangent2(roughness * roughness);
    return clamp(2.0f / max(log2_one_plus(t), 1e-7f), 1.0f, MOST_BLINN_PHONG_EXPONENT);
}

/// Phong's exponent: as h turns by an angle, the mirror direction turns by twice that.
Real phong_exponent(Real roughness) {
    Real t = half_maximum_tangent2(roughness * roughness);
    // cos 2a = (1 - t) / (1 + t), and log2 of its inverse is log2(1 + 2t / (1 - t)).
    Real fall = log2_one_plus(2.0f * t / max(1.0f - t, 1e-6f));
    return clamp(1.0f / max(fall, 1e-7f), 1.0f, MOST_PHONG_EXPONENT);
}

/// How strongly a lobe shines: by f0 and the peak at which it reflects all light that meets it, but
/// held to 1 in every channel together, because a fixed-function colour ends there; the hue stays.
/// Phong's lobe of exponent e, which no n.l narrows, spreads over 2 pi / (e + 1), so its peak is
/// (e + 1) / 2 in units of irradiance / pi, or (E + 4) / 8 for Blinn's exponent E = 4 e.
Real3 phong_specular_color(Real3 f0, Real roughness) {
    Real peak = (blinn_phong_exponent(roughness) + 4.0f) * 0.125f;
    return f0 * min(peak, 1.0f / max(greatest_component(f0), 1e-4f));
}

/// Diffuse colour. A metal keeps 0.6 of its base colour, where physics leaves it nothing: with no
/// surroundings to mirror, artists gave metals a diffuse colour (the metals of Silicon Graphics'
/// teapots.c keep 0.53 to 0.75 of their reflectance).
Real3 phong_diffuse_color(Real3 base_color, Real metalness) {
    return base_color * (1.0f - 0.4f * metalness);
}

/// The Phong material that stands for a metal-roughness one.
PhongMaterial phong_material(Real3 base_color, Real metalness, Real roughness, Real3 f0) {
    PhongMaterial material;
    material.diffuse = phong_diffuse_color(base_color, metalness);
    material.specular = phong_specular_color(f0, roughness);
    material.exponent = phong_exponent(roughness);
    return material;
}

/// The Blinn-Phong material that stands for a metal-roughness one.
PhongMaterial blinn_phong_material(Real3 base_color, Real metalness, Real roughness, Real3 f0) {
    PhongMaterial material;
    material.diffuse = phong_diffuse_color(base_color, metalness);
    material.specular = phong_specular_color(f0, roughness);
    material.exponent = blinn_phong_exponent(roughness);
    return material;
}

#endif
