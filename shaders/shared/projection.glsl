// SPDX-License-Identifier: MIT
#ifndef SHARED_PROJECTION_GLSL
#define SHARED_PROJECTION_GLSL

#include "shared/color.glsl"

// Textures projected on a model along its axes. Positions are in model space, where the model's
// longest side is 0..1: x right, y up, z towards the viewer in front. A side is 1 for what faces
// the positive end of the axis, -1 for what faces the other: seen from either, a picture is upright
// and not mirrored. Axes: 0 x, 1 y, 2 z. Coordinates: u right, v down.
//
// Weights and normals: Ben Golus, "Normal Mapping for a Triplanar Shader", 2017; Morten Mikkelsen,
// "Surface Gradient-Based Bump Mapping Framework", JCGT 9(3), 2020.

/// How much of the picture along x, y and z a surface shows that faces `normal`, a unit vector;
/// their sum is 1. blend: 0 shows the one that it faces most, 1 goes over evenly.
Real3 projection_weights(Real3 normal, float blend) {
    Real3 facing = abs(normal);
    Real least = greatest_component(facing) * (1.0f - max(blend, 0.001f));
    Real3 above = max(facing - Real3(least), 0.0f);
    return above * (1.0f / (above.x + above.y + above.z));
}

/// Where in the picture along `axis` a place of the model lies. Patina's own: upright and unmirrored
/// from all six sides.
Real2 projected_place(int axis, Real3 position, Real side) {
    if (axis == 0)
        return Real2(select(side < 0.0f, position.z, 1.0f - position.z), 1.0f - position.y);
    if (axis == 1)
        return Real2(position.x, select(side < 0.0f, 1.0f - position.z, position.z));
    return Real2(select(side < 0.0f, 1.0f - position.x, position.x), 1.0f - position.y);
}

/// The direction in model space that a tangent-space normal of that picture leans to, without what
/// it has along the axis.
Real3 projected_lean(int axis, Real3 normal, Real side) {
    if (axis == 0) return Real3(Real(0.0f), normal.y, -(normal.x * side));
    if (axis == 1) return Real3(normal.x, Real(0.0f), -(normal.y * side));
    return Real3(normal.x * side, normal.y, Real(0.0f));
}

#endif
