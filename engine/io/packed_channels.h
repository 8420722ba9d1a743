// SPDX-License-Identifier: MIT
#pragma once

/// Maps put together of channels as those are composited: of more than 8 bits, or with numbers that
/// the baked maps lack. Nothing is kept but the maps.

#include <vector>

#include "composite/composite.h"
#include "io/map_packing.h"

namespace patina::io {

/// The channels that the maps hold, each once.
std::vector<Channel> channels_of(const std::vector<PackedMap>& maps);

/// One image for each map, of `size` texels a side and `type`. Fails as bake_maps does.
Result<std::vector<Image>> packed_channels(const Program& program, ImageProvider& images, int size,
                                           const std::vector<PackedMap>& maps, SampleType type,
                                           const Progress& progress = {});

}  // namespace patina::io
