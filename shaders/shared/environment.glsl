// SPDX-License-Identifier: MIT
#ifndef SHARED_ENVIRONMENT_GLSL
#define SHARED_ENVIRONMENT_GLSL

#include "shared/brdf.glsl"
#include "shared/transcendental.glsl"

// Light from all around: which direction a texel stands for, and what the split sum adds up.
// Directions are unit vectors in the world: +Y up, right-handed.

/// Where a direction reads an equirectangular map: u = 0.5 + atan2(z, x) / 2pi to the right,
/// v = acos(y) / pi from the top row, both 0..1. The centre lies towards +X.
Real2 equirect_uv(Real3 direction) {
    return Real2(0.5f + atan2_poly(direction.z, direction.x) * (0.5f / PI),
                 acos_poly(direction.y) * (1.0f / PI));
}

/// The direction that an equirectangular map holds at uv: the inverse of equirect_uv.
Real3 equirect_direction(Real2 uv) {
    Real polar = uv.y * PI;
    Real azimuth = (uv.x - 0.5f) * (2.0f * PI);
    Real ring = sin_poly(polar);
    return Real3(ring * cos_poly(azimuth), cos_poly(polar), ring * sin_poly(azimuth));
}

/// The direction, not of unit length, through point (s, t) of a cube's face, each -1..1: s to the
/// right and t down the rows of the face. Faces +X -X +Y -Y +Z -Z are 0..5.
/// OpenGL 4.1, "Cube Map Texture Selection". The greatest component is 1.
Real3 cube_direction(int face, Real s, Real t) {
    if (face == 0) return Real3(1.0f, -t, -s);
    if (face == 1) return Real3(-1.0f, -t, s);
    if (face == 2) return Real3(s, 1.0f, t);
    if (face == 3) return Real3(s, -1.0f, -t);
    if (face == 4) return Real3(s, -t, 1.0f);
    return Real3(-s, -t, -1.0f);
}

/// The solid angle of a texel at (s, t) of a face of `size` texels a side. Summed over a cube it is
/// 4 pi, but for 1 / size^2.
Real cube_texel_solid_angle(Real s, Real t, float size) {
    Real distance2 = 1.0f + s * s + t * t;
    return (4.0f / (size * size)) / (distance2 * sqrt(distance2));
}

/// What one sample adds to the split sum: its light direction in the tangent frame (z along the
/// normal, the eye in the x-z plane), and the scale and bias of F0 in the directional albedo. The
/// means over the unit square are the albedo F0 * scale + bias. 0 where the light is below. With it
/// how dense such directions are, a steradian.
struct SplitSumSample {
    Real3 light;
    Real scale;
    Real bias;
    Real density;
};

/// For u of the unit square. Brian Karis, "Real shading in Unreal Engine 4", 2013.
SplitSumSample split_sum_sample(BrdfTerms terms, Real2 u, Real n_dot_v, Real alpha) {
    Real3 h = sample_ggx_half_vector(u, alpha);
    Real3 v = Real3(sqrt(max(1.0f - n_dot_v * n_dot_v, 0.0f)), 0.0f, n_dot_v);
    ReflectionAngles angles;
    angles.v_dot_h = clamp(dot(v, h), 0.0f, 1.0f);
    SplitSumSample result;
    result.light = h * (2.0f * angles.v_dot_h) - v;
    angles.n_dot_l = max(result.light.z, 0.0f);
    angles.n_dot_v = n_dot_v;
    angles.n_dot_h = h.z;
    angles.l_dot_v = 2.0f * angles.v_dot_h * angles.v_dot_h - 1.0f;
    Real weight = mirrored_worth(terms, angles, alpha);
    Real grazing = fresnel(terms.fresnel, angles.v_dot_h, Real3(0.0f), Real(1.0f)).x;
    result.scale = (1.0f - grazing) * weight;
    result.bias = grazing * weight;
    result.density = ggx_mirrored_density(h.z, angles.v_dot_h, alpha);
    return result;
}

/// What one direction adds to the diffuse part in uniform light: of the entering light, and of it
/// times the curve of the Fresnel term. The means over the unit square are a and b; a white surface
/// sends out a (1 - F0) - b (F90 - F0).
struct DiffuseSample {
    Real entering;
    Real grazing;
};

/// For u of the unit square, directions as dense as n.l.
DiffuseSample diffuse_sample(BrdfTerms terms, Real2 u, Real n_dot_v, Real roughness) {
    Real3 l = direction_about_z(sqrt(max(1.0f - u.y, 1e-6f)), u.x);
    Real3 v = Real3(sqrt(max(1.0f - n_dot_v * n_dot_v, 0.0f)), 0.0f, n_dot_v);
    ReflectionAngles angles = reflection_angles(Real3(0.0f, 0.0f, 1.0f), v, l);
    Real3 black = Real3(0.0f);
    DiffuseSample result;
    result.entering =
        PI * brdf_diffuse(terms, angles, Real3(1.0f), black, Real(0.0f), roughness).x;
    result.grazing =
        result.entering * fresnel(terms.fresnel, angles.v_dot_h, black, Real(1.0f)).x;
    return result;
}

// The levels of a prefiltered cube are spread so that smooth surfaces, where the eye sees steps,
// have more of them: level share t = r (3 - r) / 2 of roughness r, both 0..1, and its inverse.

/// Where a roughness lies among the levels: 0 the sharp one, 1 the last.
Real prefiltered_level_share(Real roughness) {
    return roughness * (1.5f - 0.5f * roughness);
}

/// The roughness that a level is filtered for.
Real prefiltered_roughness(Real level_share) {
    return 1.5f - sqrt(max(2.25f - 2.0f * level_share, 0.0f));
}

/// The level of a map whose texels are as large as what one of the drawn directions stands for; both
/// solid angles in steradians, that of a texel in level 0. J. Krivanek and M. Colbert, "Real-time
/// shading with filtered importance sampling", 2008.
Real filtered_level(Real solid_angle, Real texel_angle) {
    return max(0.5f * log2_poly(solid_angle / texel_angle), 0.0f);
}

/// What a level filtered for that roughness shows of a small disc of light, `radius` radians, that
/// gives what faces it irradiance 1. cosine: of the angle between the disc's middle and where the
/// level is read. The lobe that levels are filtered with has the normal and the eye there:
/// h is half way from it to the disc.
Real disc_in_level(Real cosine, Real roughness, float radius) {
    Real n_dot_l = max(cosine, 0.0f);
    Real n_dot_h = sqrt(0.5f + 0.5f * n_dot_l);
    Real alpha = alpha_from_roughness(roughness_under_disc(roughness, radius));
    return n_dot_l * ggx_mirrored_density(n_dot_h, n_dot_h, alpha);
}

#endif
