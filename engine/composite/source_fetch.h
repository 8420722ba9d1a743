// SPDX-License-Identifier: MIT
#pragma once

/// Evaluating a source over one tile: constant, image, procedural or parts of the model.

#include <array>
#include <functional>
#include <optional>

#include "composite/bound_images.h"
#include "composite/surface_sources.h"
#include "composite/tile.h"

namespace patina {

/// Whether what reads a source takes such texels as they are stored.
using AcceptsStored = std::function<bool(const StoredTexels&)>;

/// What a source is read from.
struct SourceFetch {
    const SourceRecord* record = nullptr;
    const BoundImage* image = nullptr;
    SurfaceTexels texels = {};
    const std::vector<std::uint8_t>* chosen_parts = nullptr;  ///< of a GeometrySource
    AcceptsStored accepts = nullptr;                          ///< null: planes alone
};
/// Planes that may be overwritten; those of a scalar beyond the first hold nothing afterwards.
using FetchTarget = std::array<float*, 3>;

/// What fetch_source gives where that is the same in every tile, constants and texels that are
/// taken as they are stored, these from the first of the image on; nothing of other sources.
std::optional<FetchedSource> steady_source(const SourceRecord& record, const BoundImage& bound,
                                           const AcceptsStored& accepts);

/// Any source but relief, for which the run has to look around.
/// @param target  where the components lie afterwards unless they are constant or stored
/// @param planes  scratch: the plane of the source's coverage is overwritten
FetchedSource fetch_source(const SourceFetch& from, const TileSpan& span, const FetchTarget& target,
                           TilePlanes& planes);

}  // namespace patina
