// SPDX-License-Identifier: MIT
#pragma once

/// Maps of 8 bits made of those that a save has baked, so that nothing is baked twice.

#include <optional>

#include "io/baked_files.h"
#include "io/map_packing.h"

namespace patina::io {

/// The file that a map has already as a PNG: one whose channels are those of a baked map in their
/// order. Null where there is none of `size` texels a side.
std::shared_ptr<const EncodedMap> same_file(const PackedMap& map, const EncodedMaps& baked,
                                            int size);

/// The map put together of baked ones; unset where it holds what none of them does.
std::optional<Image> packed_bytes(const PackedMap& map, const EncodedMaps& baked, int size);

}  // namespace patina::io
