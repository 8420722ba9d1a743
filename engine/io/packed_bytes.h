// SPDX-License-Identifier: MIT
#pragma once

/// Maps of 8 bits made of the bytes of baked ones, in whatever packing.

#include <optional>
#include <vector>

#include "composite/composite.h"
#include "io/map_packing.h"

namespace patina::io {

/// The baked maps whose bytes a map of 8 bits is put together of, each once; unset where it holds
/// numbers that none of them has as bytes (heights, inverted ones, a component of a colour).
std::optional<std::vector<BakedMap>> baked_maps_of(const PackedMap& map);

/// The baked map of `size` texels a side that is the file already: the same channels in the same
/// order, but for an opacity that was left out because it is 1 everywhere.
std::optional<BakedMap> same_map(const PackedMap& map, const MapSet& baked, int size);

/// The map put together of baked ones; unset where it holds what none of them does.
std::optional<Image> packed_bytes(const PackedMap& map, const MapSet& baked, int size);

}  // namespace patina::io
