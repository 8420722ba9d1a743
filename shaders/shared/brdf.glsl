// SPDX-License-Identifier: MIT
#ifndef SHARED_BRDF_GLSL
#define SHARED_BRDF_GLSL

#include "shared/color.glsl"
#include "shared/transcendental.glsl"

// How surfaces reflect light: the terms of Cook and Torrance's model ("A reflectance model for
// computer graphics", 1982) as glTF 2.0 Appendix B uses it, with alternatives to each.
//
// n normal, v towards the eye, l towards the light, h half way between v and l; all unit vectors.
// roughness: what glTF stores. alpha: its square (Burley, 2012), at least LEAST_ALPHA.
// Visibility is V = G / (4 (n.l) (n.v)), which glTF uses because it cancels; specular = D V F.

// Numbers of the terms, in the order of engine/render/shading.h.
const int DISTRIBUTION_GGX = 0;
const int DISTRIBUTION_BECKMANN = 1;
const int DISTRIBUTION_BLINN_PHONG = 2;
const int GEOMETRY_SMITH_SEPARABLE = 0;
const int GEOMETRY_SMITH_CORRELATED = 1;
const int GEOMETRY_SCHLICK_GGX = 2;
const int GEOMETRY_LECTURE = 3;
const int FRESNEL_SCHLICK = 0;
const int FRESNEL_SPHERICAL_GAUSSIAN = 1;
const int DIFFUSE_LAMBERT = 0;
const int DIFFUSE_BURLEY = 1;
const int DIFFUSE_OREN_NAYAR = 2;
const int DIFFUSE_LECTURE = 3;

/// Which term stands where, for a whole picture.
struct BrdfTerms {
    int distribution;
    int geometry;
    int fresnel;
    int diffuse;
};

/// The terms for light from all around: the lecture's diffuse term is for lamps, whose light it does
/// not divide by pi, and gives way to Lambert's.
BrdfTerms ambient_terms(BrdfTerms terms) {
    BrdfTerms ambient = terms;
    if (terms.diffuse == DIFFUSE_LECTURE) ambient.diffuse = DIFFUSE_LAMBERT;
    return ambient;
}

// Below it a highlight is narrower than float cosines near 1 can tell apart.
const float LEAST_ALPHA = 0.002f;
// n.v is held above it, so that surfaces seen edge-on (or from behind, by an interpolated normal)
// stay finite.
const float LEAST_N_DOT_V = 1e-4f;

/// n.v of a surface as all terms read it.
Real held_n_dot_v(Real3 n, Real3 v) {
    return clamp(dot(n, v), LEAST_N_DOT_V, 1.0f);
}

/// The width of the microfacet distribution.
Real alpha_from_roughness(Real roughness) {
    return max(roughness * roughness, LEAST_ALPHA);
}

/// (1 - x)^5, the curve of Schlick's Fresnel term.
Real schlick_weight(Real x) {
    Real m = clamp(1.0f - x, 0.0f, 1.0f);
    Real m2 = m * m;
    return m2 * m2 * m;
}

// D: how many microfacets face h. The integral of D (n.h) over the hemisphere is 1.

/// GGX: B. Walter and others, "Microfacet models for refraction through rough surfaces", 2007,
/// after Trowbridge and Reitz, 1975. glTF 2.0 B.3.2. 1 / (pi alpha^2) at n.h = 1.
Real distribution_ggx(Real n_dot_h, Real alpha) {
    Real alpha2 = alpha * alpha;
    Real d = n_dot_h * n_dot_h * (alpha2 - 1.0f) + 1.0f;
    return alpha2 / (PI * d * d);
}

/// Beckmann: Gaussian slopes. Beckmann and Spizzichino, 1963; in Walter's form.
Real distribution_beckmann(Real n_dot_h, Real alpha) {
    Real alpha2 = alpha * alpha;
    Real c2 = max(n_dot_h * n_dot_h, 1e-6f);
    Real gauss = exp2_poly((c2 - 1.0f) / (alpha2 * c2) * 1.44269504f);
    return gauss / (PI * alpha2 * c2 * c2);
}

/// Blinn-Phong as a normalised distribution, with the exponent 2 / alpha^2 - 2 that has Beckmann's
/// curvature at n.h = 1 (Walter, 2007).
Real distribution_blinn_phong(Real n_dot_h, Real alpha) {
    Real inverse_alpha2 = 1.0f / (alpha * alpha);
    Real exponent = max(2.0f * inverse_alpha2 - 2.0f, 1e-3f);
    return pow_poly(n_dot_h, exponent) * ((exponent + 2.0f) * (0.5f / PI));
}

/// The roughness whose highlight of a point is as wide as that of `roughness` of a disc of
/// `radius` radians. In half vectors the disc is half as wide, and its variance adds to that of the
/// slopes: alpha^2 / 2 of a Gaussian, radius^2 / 16 of the disc, both along one axis.
Real roughness_under_disc(Real roughness, float radius) {
    Real alpha = alpha_from_roughness(roughness);
    return sqrt(sqrt(alpha * alpha + radius * radius * 0.125f));
}

/// The roughness of a surface whose normals vary within what is seen as one point. variance: of the
/// unit normals there, 1 - |their mean|^2, which for small tilts is twice that of the slopes along
/// one axis, as alpha^2 is of a Gaussian. After Marc Olano and Dan Baker, "LEAN mapping", 2010.
Real roughness_with_variance(Real roughness, Real variance) {
    Real alpha = alpha_from_roughness(roughness);
    return sqrt(sqrt(min(alpha * alpha + variance, 1.0f)));
}

/// The distribution DISTRIBUTION_...
Real distribution(int term, Real n_dot_h, Real alpha) {
    if (term == DISTRIBUTION_BECKMANN) return distribution_beckmann(n_dot_h, alpha);
    if (term == DISTRIBUTION_BLINN_PHONG) return distribution_blinn_phong(n_dot_h, alpha);
    return distribution_ggx(n_dot_h, alpha);
}

// V: masking and shadowing. G = 4 (n.l) (n.v) V is in 0..1, and exchanging l and v changes nothing.

/// What Smith's terms for GGX divide by: n.x + sqrt(alpha^2 + (1 - alpha^2) (n.x)^2).
Real smith_ggx_divisor(Real n_dot_x, Real alpha) {
    Real alpha2 = alpha * alpha;
    return n_dot_x + sqrt(alpha2 + (1.0f - alpha2) * n_dot_x * n_dot_x);
}

/// Smith, masking and shadowing apart: glTF 2.0 B.3.2 ("Specular BRDF").
Real visibility_smith_separable(Real n_dot_l, Real n_dot_v, Real alpha) {
    return 1.0f / (smith_ggx_divisor(n_dot_l, alpha) * smith_ggx_divisor(n_dot_v, alpha));
}

/// Smith, masking and shadowing correlated by height. Eric Heitz, "Understanding the
/// masking-shadowing function in microfacet-based BRDFs", 2014. Never below the separable form.
Real visibility_smith_correlated(Real n_dot_l, Real n_dot_v, Real alpha) {
    Real alpha2 = alpha * alpha;
    Real masking = n_dot_l * sqrt(alpha2 + (1.0f - alpha2) * n_dot_v * n_dot_v);
    Real shadowing = n_dot_v * sqrt(alpha2 + (1.0f - alpha2) * n_dot_l * n_dot_l);
    return 0.5f / max(masking + shadowing, 1e-7f);
}

/// Schlick's rational form with k = alpha / 2. Christophe Schlick, "An inexpensive BRDF model",
/// 1994; k after Brian Karis, "Real shading in Unreal Engine 4", 2013.
Real visibility_schlick_ggx(Real n_dot_l, Real n_dot_v, Real alpha) {
    Real k = alpha * 0.5f;
    Real light = n_dot_l * (1.0f - k) + k;
    Real eye = n_dot_v * (1.0f - k) + k;
    return 0.25f / (light * eye);
}

/// The lecture's form: Smith's separable one, after Walter, 2007, with roughness where alpha belongs,
/// G1(n,v) = 2 (n.v) / ((n.v) + sqrt(r^2 + (1 - r^2) (n.v)^2)), which masks more. A test holds
/// that closed form.
Real visibility_lecture(Real n_dot_l, Real n_dot_v, Real alpha) {
    return visibility_smith_separable(n_dot_l, n_dot_v, sqrt(alpha));
}

/// The visibility GEOMETRY_...
Real visibility(int term, Real n_dot_l, Real n_dot_v, Real alpha) {
    if (term == GEOMETRY_SMITH_CORRELATED)
        return visibility_smith_correlated(n_dot_l, n_dot_v, alpha);
    if (term == GEOMETRY_SCHLICK_GGX) return visibility_schlick_ggx(n_dot_l, n_dot_v, alpha);
    if (term == GEOMETRY_LECTURE) return visibility_lecture(n_dot_l, n_dot_v, alpha);
    return visibility_smith_separable(n_dot_l, n_dot_v, alpha);
}

// F: how much a microfacet reflects; f0 head on, f90 at grazing angles.

/// Schlick, 1994; glTF 2.0 B.3.2. f0 at v.h = 1, f90 at v.h = 0, monotone between.
Real3 fresnel_schlick(Real v_dot_h, Real3 f0, Real f90) {
    return f0 + (Real3(f90) - f0) * schlick_weight(v_dot_h);
}

/// Schlick's curve as a power of two. Sebastien Lagarde, "Spherical Gaussian approximation for
/// Blinn-Phong, Phong and Fresnel", 2012. Within 0.01 of it.
Real3 fresnel_spherical_gaussian(Real v_dot_h, Real3 f0, Real f90) {
    return f0 + (Real3(f90) - f0) * exp2_poly((-5.55473f * v_dot_h - 6.98316f) * v_dot_h);
}

/// The Fresnel term FRESNEL_...
Real3 fresnel(int term, Real v_dot_h, Real3 f0, Real f90) {
    if (term == FRESNEL_SPHERICAL_GAUSSIAN) return fresnel_spherical_gaussian(v_dot_h, f0, f90);
    return fresnel_schlick(v_dot_h, f0, f90);
}

/// The mean over all l, weighted by n.l, of Schlick's curve of v.h: what mirroring takes from the
/// light that would enter a surface in uniform light. Fitted to the integral, within 1e-5.
Real schlick_mean(Real n_dot_v) {
    Real m = clamp(1.0f - n_dot_v, 0.0f, 1.0f);
    return 8.19e-5f +
           m * (2.02873e-3f + m * (9.2689e-3f + m * (7.86598e-3f + m * 8.91574e-3f)));
}

// Reflectance of materials, glTF 2.0 with KHR_materials_ior and KHR_materials_specular.

/// F0 of a dielectric in air, ((ior - 1) / (ior + 1))^2. 0.04 for 1.5; 1 for 0, which the extension
/// gives the meaning of a full mirror.
Real f0_from_ior(Real ior) {
    Real r = (ior - 1.0f) / (ior + 1.0f);
    return r * r;
}

/// F0 of a dielectric with specular factor (0..1) and linear colour.
Real3 dielectric_f0(Real ior, Real specular_factor, Real3 specular_color) {
    return min(specular_color * f0_from_ior(ior), 1.0f) * specular_factor;
}

/// F0 of a material: a metal's is its base colour.
Real3 material_f0(Real3 dielectric, Real3 base_color, Real metalness) {
    return mix(dielectric, base_color, metalness);
}

/// F0 of what is not metal in a material, 0..1: material_f0 solved for it. Metal alone has lost it.
Real3 dielectric_part_f0(Real3 f0, Real3 base_color, Real metalness) {
    return clamp((f0 - metalness * base_color) / max(1.0f - metalness, 1e-3f), 0.0f, 1.0f);
}

/// F90 of a material: 1 for metals, the specular factor for dielectrics.
Real material_f90(Real specular_factor, Real metalness) {
    return mix(specular_factor, Real(1.0f), metalness);
}

/// The colour of the diffuse part: metals have none.
Real3 diffuse_color(Real3 base_color, Real metalness) {
    return base_color * (1.0f - metalness);
}

// Diffuse terms, for a white surface: without colour, with 1/pi.

/// Brent Burley, "Physically based shading at Disney", 2012. Exchanging l and v changes nothing.
Real diffuse_burley(Real n_dot_l, Real n_dot_v, Real v_dot_h, Real roughness) {
    Real rise = 2.0f * v_dot_h * v_dot_h * roughness - 0.5f;  // F_D90 - 1
    Real light = 1.0f + rise * schlick_weight(n_dot_l);
    Real eye = 1.0f + rise * schlick_weight(n_dot_v);
    return light * eye * (1.0f / PI);
}

/// Oren and Nayar, "Generalization of Lambert's reflectance model", 1994, qualitative form, with
/// roughness as the deviation of slopes in radians; without trigonometry after Yasuhiro Fujii.
/// Lambert's for roughness 0.
Real diffuse_oren_nayar(Real n_dot_l, Real n_dot_v, Real l_dot_v, Real roughness) {
    Real sigma2 = roughness * roughness;
    Real a = 1.0f - 0.5f * sigma2 / (sigma2 + 0.33f);
    Real b = 0.45f * sigma2 / (sigma2 + 0.09f);
    Real s = l_dot_v - n_dot_l * n_dot_v;
    Real divisor = select(s > 0.0f, max(max(n_dot_l, n_dot_v), 1e-4f), 1.0f);
    return (a + b * s / divisor) * (1.0f / PI);
}

// A surface under one light.

struct ReflectionAngles {
    Real n_dot_l;  // 0..1; 0: the light is behind
    Real n_dot_v;  // LEAST_N_DOT_V..1
    Real n_dot_h;  // 0..1
    Real v_dot_h;  // 0..1
    Real l_dot_v;  // -1..1
};

ReflectionAngles reflection_angles(Real3 n, Real3 v, Real3 l) {
    Real3 between = v + l;
    Real3 h = between * inversesqrt(max(dot(between, between), 1e-12f));
    ReflectionAngles angles;
    angles.n_dot_l = clamp(dot(n, l), 0.0f, 1.0f);
    angles.n_dot_v = held_n_dot_v(n, v);
    angles.n_dot_h = clamp(dot(n, h), 0.0f, 1.0f);
    angles.v_dot_h = clamp(dot(v, h), 0.0f, 1.0f);
    angles.l_dot_v = clamp(dot(l, v), -1.0f, 1.0f);
    return angles;
}

/// The specular BRDF D V F.
Real3 brdf_specular(BrdfTerms terms, ReflectionAngles angles, Real3 f0, Real f90, Real roughness) {
    Real alpha = alpha_from_roughness(roughness);
    Real dv = distribution(terms.distribution, angles.n_dot_h, alpha) *
              visibility(terms.geometry, angles.n_dot_l, angles.n_dot_v, alpha);
    return fresnel(terms.fresnel, angles.v_dot_h, f0, f90) * dv;
}

/// What of a reflectance in colour keeps light out of the diffuse part: its largest component, so
/// that a tinted reflection does not let light of the other colours in (KHR_materials_specular).
Real reflected_share(Real3 reflectance) {
    return greatest_component(reflectance);
}

/// The diffuse BRDF, (1 - F) x colour x term: what is not reflected enters. glTF 2.0 B.3.
/// The lecture's is the colour alone: without 1/pi and without 1 - F.
Real3 brdf_diffuse(BrdfTerms terms, ReflectionAngles angles, Real3 color, Real3 f0, Real f90,
                   Real roughness) {
    if (terms.diffuse == DIFFUSE_LECTURE) return color;
    Real term = 1.0f / PI;
    if (terms.diffuse == DIFFUSE_BURLEY)
        term = diffuse_burley(angles.n_dot_l, angles.n_dot_v, angles.v_dot_h, roughness);
    if (terms.diffuse == DIFFUSE_OREN_NAYAR)
        term = diffuse_oren_nayar(angles.n_dot_l, angles.n_dot_v, angles.l_dot_v, roughness);
    Real entering = 1.0f - reflected_share(fresnel(terms.fresnel, angles.v_dot_h, f0, f90));
    return color * (entering * term);
}

/// What the specular part is multiplied by to give back the energy that single scattering loses.
/// directional_albedo: what a surface with F = 1 reflects of uniform light at this n.v and
/// roughness. 1 for albedo 1; a mirror-coloured surface (f0 = 1) then reflects everything.
/// Emmanuel Turquin, "Practical multiple scattering compensation for microfacet models", 2019.
Real3 multiple_scattering_scale(Real3 f0, Real directional_albedo) {
    return Real3(1.0f) + f0 * (1.0f / max(directional_albedo, 1e-3f) - 1.0f);
}

// Light from all around that does not reach a surface.

/// What of the mirrored environment an occlusion map leaves: with occlusion 1 all of it, with 0
/// nothing; the more of the lobe lies within what is open, the more. occlusion: the share of a
/// uniform sky that reaches the surface, 0..1. Sebastien Lagarde and Charles de Rousiers, "Moving
/// Frostbite to physically based rendering", 2014, section 4.10.2.
Real mirrored_share(Real n_dot_v, Real occlusion, Real alpha) {
    Real open = max(n_dot_v + occlusion, 1e-4f);
    Real share = pow_poly(open, exp2_poly(-16.0f * alpha - 1.0f)) - 1.0f + occlusion;
    return select(occlusion < 1.0f, clamp(share, 0.0f, 1.0f), Real(1.0f));
}

/// What is left of light from the mirrored direction of a normal map, by its cosine to the normal of
/// the surface itself: all above the horizon, less and less below. Jeff Russell, "Horizon occlusion
/// for normal mapped reflections", 2013.
Real horizon_share(Real cosine) {
    Real left = clamp(1.0f + 1.3f * cosine, 0.0f, 1.0f);
    return left * left;
}

// Sampling. Directions are in the tangent frame: z along the normal.

/// Two unit vectors across z, which make a right-handed frame with it. T. Duff and others, "Building
/// an orthonormal basis, revisited", 2017.
struct Across {
    Real3 x_axis;
    Real3 y_axis;
};
Across across_of(Real3 z) {
    Real side = select(z.z < 0.0f, Real(-1.0f), Real(1.0f));
    Real a = -1.0f / (side + z.z);
    Real b = z.x * z.y * a;
    Across frame;
    frame.x_axis = Real3(1.0f + side * z.x * z.x * a, side * b, -side * z.x);
    frame.y_axis = Real3(b, side + z.y * z.y * a, -z.y);
    return frame;
}

/// A direction by its cosine to z and a turn 0..1 about it.
Real3 direction_about_z(Real cosine, Real turn) {
    Real sine = sqrt(max(1.0f - cosine * cosine, 0.0f));
    Real phi = turn * (2.0f * PI);
    return Real3(sine * cos_poly(phi), sine * sin_poly(phi), cosine);
}

/// A half vector for u of the unit square, with the density D (n.h) of GGX. Walter, 2007.
Real3 sample_ggx_half_vector(Real2 u, Real alpha) {
    Real cosine2 = (1.0f - u.y) / (1.0f + (alpha * alpha - 1.0f) * u.y);
    return direction_about_z(sqrt(max(cosine2, 0.0f)), u.x);
}

/// How dense the directions are that the eye sees mirrored by half vectors so drawn, a steradian:
/// D (n.h) / (4 v.h). Walter, 2007, equations 14 and 24.
Real ggx_mirrored_density(Real n_dot_h, Real v_dot_h, Real alpha) {
    return distribution_ggx(n_dot_h, alpha) * n_dot_h / (4.0f * max(v_dot_h, 1e-4f));
}

/// What light from a direction drawn so is worth before the Fresnel term: (n.l) D V of the terms over
/// ggx_mirrored_density. Its mean is what a surface with F = 1 reflects of uniform light. n.l is at
/// most 2 (v.h) (n.h), but where the eye is behind an interpolated normal: there, and nowhere else,
/// the floor of n.h is met, and keeps single pixels from sparkling.
Real mirrored_worth(BrdfTerms terms, ReflectionAngles angles, Real alpha) {
    Real worth = 4.0f * angles.n_dot_l * angles.v_dot_h / max(angles.n_dot_h, 1e-3f) *
                 visibility(terms.geometry, angles.n_dot_l, angles.n_dot_v, alpha);
    if (terms.distribution == DISTRIBUTION_GGX) return worth;
    return worth * (distribution(terms.distribution, angles.n_dot_h, alpha) /
                    distribution_ggx(angles.n_dot_h, alpha));
}

/// A half vector that the eye at v (unit, z > 0) sees, for u of the unit square.
/// J. Dupuy and A. Benyoub, "Sampling visible GGX normals with spherical caps", 2023.
Real3 sample_ggx_visible_half_vector(Real2 u, Real3 v, Real alpha) {
    Real3 stretched = normalize(Real3(v.x * alpha, v.y * alpha, v.z));
    Real z = (1.0f - u.y) * (1.0f + stretched.z) - stretched.z;
    Real3 cap = direction_about_z(clamp(z, -1.0f, 1.0f), u.x);
    Real3 h = cap + stretched;
    return normalize(Real3(h.x * alpha, h.y * alpha, max(h.z, 1e-6f)));
}

/// Per steradian of l, the density of mirroring v at such a half vector: G1(v) D / (4 n.v).
/// Eric Heitz, "Sampling the GGX distribution of visible normals", 2018, equation 17.
Real ggx_visible_density(Real n_dot_h, Real n_dot_v, Real alpha) {
    return distribution_ggx(n_dot_h, alpha) / (2.0f * smith_ggx_divisor(n_dot_v, alpha));
}

#endif
