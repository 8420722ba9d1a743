// SPDX-License-Identifier: MIT
#pragma once

/// The maps of one material, baked and encoded once.

#include <array>
#include <memory>
#include <vector>

#include "composite/composite.h"
#include "core/files.h"
#include "io/png_writer.h"

namespace patina::io {

struct EncodedMap {
    ImagePtr image;
    std::shared_ptr<const Bytes> png;
    Hash128 pixels;  ///< content_hash of `image`
};
/// By BakedMap; those that were not asked for are null.
using EncodedMaps = std::array<std::shared_ptr<const EncodedMap>, kBakedMapCount>;

/// Bakes maps as files hold them: dilated, and without an alpha channel that is opaque everywhere.
/// @param islands  what the maps are dilated by, or null
Result<MapSet> bake_for_files(const Program& program, const UvSurfacePtr& islands,
                              ImageProvider& images, int size, const std::vector<BakedMap>& wanted,
                              const Progress& progress);
/// The same, encoded.
Result<EncodedMaps> bake_and_encode(const Program& program, const UvSurfacePtr& islands,
                                    ImageProvider& images, int size,
                                    const std::vector<BakedMap>& wanted, const PngOptions& options,
                                    const Progress& progress);

/// The mean of what a slot reads of its map, as the slot's factor (SlotStatement::factor): colours
/// in linear light.
glm::vec4 mean_factor(const Image& map, Slot slot);

}  // namespace patina::io
