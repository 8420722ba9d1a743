// SPDX-License-Identifier: MIT
#pragma once

/// Suns: what is small and so bright that a filtered cube with few samples, in half floats, loses
/// or smears it. They are taken out of the map and lit analytically, with their exact power.

#include <vector>

#include "render/environment.h"
#include "render/radiance_map.h"

namespace patina::render {

struct MapWithoutSuns {
    std::vector<EnvironmentSun> suns;
    RadianceMap rest;  ///< where a sun was: as bright as around it
};

/// Takes out regions of connected texels that are over 30 times as bright as the median of the map
/// (by solid angle) and less than 0.15 radians in radius, when they carry more than a hundredth of
/// its light; of these the kMostSuns strongest, the strongest first.
MapWithoutSuns take_out_suns(const RadianceMap& map);

}  // namespace patina::render
