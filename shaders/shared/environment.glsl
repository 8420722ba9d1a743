// SPDX-License-Identifier: MIT
#ifndef SHARED_ENVIRONMENT_GLSL
#define SHARED_ENVIRONMENT_GLSL

#include "shared/brdf.glsl"
#include "shared/transcendental.glsl"

// Light from all around: which direction a texel stands for, spherical harmonics, and what the
// split sum adds up. Directions are unit vectors in the world: +Y up, right-handed.

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
/// OpenGL 4.1, table 3.19. The greatest component is 1.
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

/// Nine numbers: coefficients, or values of the basis, of real spherical harmonics of order 0 to 2.
struct Sh9 {
    Real value[9];
};

/// The basis in a direction. Orthonormal over the sphere.
/// R. Ramamoorthi and P. Hanrahan, "An efficient representation for irradiance environment maps",
/// SIGGRAPH 2001.
Sh9 sh9_basis(Real3 d) {
    Sh9 basis;
    basis.value[0] = 0.282094792f;
    basis.value[1] = 0.488602512f * d.y;
    basis.value[2] = 0.488602512f * d.z;
    basis.value[3] = 0.488602512f * d.x;
    basis.value[4] = 1.092548431f * d.x * d.y;
    basis.value[5] = 1.092548431f * d.y * d.z;
    basis.value[6] = 0.315391565f * (3.0f * d.z * d.z - 1.0f);
    basis.value[7] = 1.092548431f * d.x * d.z;
    basis.value[8] = 0.546274215f * (d.x * d.x - d.y * d.y);
    return basis;
}

/// Irradiance / pi on a surface that faces the direction whose basis is given, from the projection
/// of radiance onto the basis: a convolution with the cosine. Uniform radiance gives itself.
Real sh9_irradiance_over_pi(Sh9 radiance, Sh9 basis) {
    Real order0 = radiance.value[0] * basis.value[0];
    Real order1 = radiance.value[1] * basis.value[1] + radiance.value[2] * basis.value[2] +
                  radiance.value[3] * basis.value[3];
    Real order2 = radiance.value[4] * basis.value[4] + radiance.value[5] * basis.value[5] +
                  radiance.value[6] * basis.value[6] + radiance.value[7] * basis.value[7] +
                  radiance.value[8] * basis.value[8];
    return order0 + order1 * (2.0f / 3.0f) + order2 * 0.25f;
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

/// For u of the unit square. Brian Karis, "Real shading in Unreal Engine 4", 2013. Other
/// distributions are weighted against GGX, which is drawn.
SplitSumSample split_sum_sample(BrdfTerms terms, Real2 u, Real n_dot_v, Real alpha) {
    Real3 h = sample_ggx_half_vector(u, alpha);
    Real3 v = Real3(sqrt(max(1.0f - n_dot_v * n_dot_v, 0.0f)), 0.0f, n_dot_v);
    Real v_dot_h = clamp(dot(v, h), 0.0f, 1.0f);
    SplitSumSample result;
    result.light = h * (2.0f * v_dot_h) - v;
    Real n_dot_l = result.light.z;
    Real lit = visibility(terms.geometry, max(n_dot_l, 0.0f), n_dot_v, alpha) * 4.0f * n_dot_l *
               v_dot_h / max(h.z, 1e-6f);
    if (terms.distribution != DISTRIBUTION_GGX)
        lit = lit * (distribution(terms.distribution, h.z, alpha) / distribution_ggx(h.z, alpha));
    Real weight = select(n_dot_l > 0.0f, lit, 0.0f);
    Real grazing = fresnel(terms.fresnel, v_dot_h, Real3(0.0f), Real(1.0f)).x;
    result.scale = (1.0f - grazing) * weight;
    result.bias = grazing * weight;
    result.density = ggx_mirrored_density(h.z, v_dot_h, alpha);
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

#endif
