// SPDX-License-Identifier: MIT
#ifndef SHARED_NORMAL_BLEND_GLSL
#define SHARED_NORMAL_BLEND_GLSL

// Tangent-space normals laid over each other. Normals are unit vectors, +Y up as in glTF, z > 0;
// flat is (0, 0, 1). Opacity comes first: fade the source to flat (normal_faded), then blend.
//
// Colin Barre-Brisebois and Stephen Hill, "Blending in Detail", 2012,
// https://blog.selfshadow.com/publications/blending-in-detail/.

/// A vector at unit length; flat where it has none.
Real3 unit_normal(Real3 v) {
    Real length_squared = dot(v, v);
    Real3 unit = v * inversesqrt(max(length_squared, 1e-20f));
    return select(length_squared > 1e-20f, unit, Real3(0.0f, 0.0f, 1.0f));
}

/// What a texel that stores 0..1 stands for: -1..1 (glTF 2.0, 3.9.3). Of a normal, not of unit length.
Real signed_from_encoded(Real encoded) {
    return encoded * 2.0f - 1.0f;
}
Real3 signed_from_encoded(Real3 encoded) {
    return encoded * 2.0f - 1.0f;
}

/// What a texel stores of -1..1: 0..1.
Real encoded_from_signed(Real value) {
    return value * 0.5f + 0.5f;
}
Real3 encoded_from_signed(Real3 value) {
    return value * 0.5f + 0.5f;
}

/// Weight 1 keeps the normal, 0 gives flat, between them a lerp at unit length.
Real3 normal_faded(Real3 normal, Real weight) {
    return unit_normal(mix(Real3(0.0f, 0.0f, 1.0f), normal, weight));
}

/// The source covers the backdrop by the weight: a lerp at unit length.
Real3 normal_over(Real3 backdrop, Real3 source, Real weight) {
    return unit_normal(mix(backdrop, source, weight));
}

/// In a group, whose backdrop covers in part: `laid`, the source laid on the backdrop by the weight,
/// counts as far as there is a backdrop, elsewhere the source by its weight. `laid` for coverage 1,
/// the source for 0.
Real3 normal_in_group(Real3 laid, Real coverage, Real3 source, Real weight) {
    return unit_normal(laid * coverage + source * (weight * (1.0f - coverage)));
}

/// Reoriented normal mapping: the source turned by the rotation that takes flat to the backdrop.
/// A flat source leaves the backdrop, a flat backdrop leaves the source; length is kept.
Real3 normal_blend_rnm(Real3 backdrop, Real3 source) {
    Real3 t = Real3(backdrop.x, backdrop.y, backdrop.z + 1.0f);
    Real3 u = Real3(-source.x, -source.y, source.z);
    return t * (dot(t, u) / t.z) - u;
}

/// UDN: the source only bends the backdrop, which keeps its z. Flat sources leave the backdrop.
Real3 normal_blend_udn(Real3 backdrop, Real3 source) {
    return unit_normal(Real3(backdrop.x + source.x, backdrop.y + source.y, backdrop.z));
}

/// Partial derivatives: the slopes of the two surfaces add, as those of heights do. Commutative;
/// flat is neutral. What faces down or sideways, which has no slope, counts as all but upright.
Real3 normal_blend_partial_derivative(Real3 backdrop, Real3 source) {
    Real below_z = max(backdrop.z, 1e-3f);
    Real own_z = max(source.z, 1e-3f);
    return unit_normal(Real3(backdrop.x * own_z + source.x * below_z,
                             backdrop.y * own_z + source.y * below_z, below_z * own_z));
}

/// Whiteout: slopes add and heights multiply. Commutative; flat is neutral.
Real3 normal_blend_whiteout(Real3 backdrop, Real3 source) {
    return unit_normal(Real3(backdrop.x + source.x, backdrop.y + source.y, backdrop.z * source.z));
}

#endif
