// SPDX-License-Identifier: MIT
#pragma once

/// Where the light of a level floor comes from: what ground_shadow.h weighs the parts of the sky
/// with that a model hides.

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "render/radiance_map.h"

namespace patina::render {

struct EnvironmentSun;

/// Bands of elevation, from the horizon up; band k holds sin^2 of it from k / 32 to (k + 1) / 32,
/// so that an even sky gives as much through each.
inline constexpr int kSkyBands = 32;
inline constexpr int kSkyAzimuths = 64;

/// By azimuth, then by band; azimuth a begins at atan2(z, x) = -pi + a 2 pi / 64, in the directions
/// of the map. The shares of all the light that a level floor gets: 1 together.
using SkyShares = std::array<std::array<float, kSkyBands>, kSkyAzimuths>;

/// As much from everywhere.
SkyShares even_sky();
/// What a map gives without its suns; an even sky where that is nothing.
SkyShares sky_shares(const RadianceMap& map, const std::vector<EnvironmentSun>& suns);

}  // namespace patina::render
