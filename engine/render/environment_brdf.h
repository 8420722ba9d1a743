// SPDX-License-Identifier: MIT
#pragma once

/// How a surface mirrors a prefiltered environment: which part of the light, and where the filtered
/// cube is read. The cube is filtered for an eye that looks along the normal and along what it sees
/// mirrored; the lobe of another view is skewed towards the normal and cut off by the surface. It
/// is read where the core of the real lobe lies, at the level whose core is as wide. The split sum
/// is Karis's ("Real Shading in Unreal Engine 4", 2013), the rest Patina's own.

#include <glm/glm.hpp>
#include <vector>

#include "render/shading.h"

namespace patina::render {

/// Levels of FilteredEnvironment::specular.
inline constexpr int kPrefilteredLevels = 6;

/// A direction of what one texel of the filtered cube gathers, about +Z.
struct LobeDirection {
    glm::vec3 direction;
    float weight;       ///< all of a lobe add up to 1
    float solid_angle;  ///< steradians that it stands for
};
/// The lobe of GGX for n = v = r, weighted by n.l.
/// Karis, "Real Shading in Unreal Engine 4", 2013.
std::vector<LobeDirection> prefiltered_lobe(float roughness, unsigned count);

/// One texel of the table.
struct EnvironmentBrdf {
    float scale;  ///< the directional albedo is F0 * scale + bias
    float bias;
    /// The core's mean direction lies in the plane of n and the mirrored eye ray r; its tangential
    /// part is this times that of r.
    float tangent_scale;
    float level_share;  ///< where the cube is as wide: 0 its first level, 1 the last
};

/// For these terms: texel (i, j) of a size x size table is for n.v = (i + 0.5) / size and
/// roughness = (j + 0.5) / size, rows of n.v.
std::vector<EnvironmentBrdf> environment_brdf_table(int size, const PbrTerms& terms = {});

/// What the diffuse term sends out of uniform light: a white surface entering (1 - F0) - grazing
/// (F90 - F0). The lecture's term stands for lamps alone; here it is Lambert's.
struct EnvironmentDiffuse {
    float entering;
    float grazing;
};
/// Laid out in the same way.
std::vector<EnvironmentDiffuse> environment_diffuse_table(int size, const PbrTerms& terms);

}  // namespace patina::render
