// SPDX-License-Identifier: MIT
#pragma once

/// Evaluating a source over one tile: constant, image, procedural or parts of the model.

#include "composite/bound_images.h"
#include "composite/surface_sources.h"
#include "composite/tile.h"

namespace patina {

/// What a source is read from.
struct SourceFetch {
    const SourceRecord* record = nullptr;
    const BoundImage* image = nullptr;
    SurfaceTexels texels = {};
    const std::vector<std::uint8_t>* chosen_parts = nullptr;  ///< of a GeometrySource
};
/// Any source but relief, for which the run has to look around.
/// @param target  planes that may be overwritten, and hold the components unless they are constant
/// @param planes  scratch: the plane of the source's coverage is overwritten
FetchedSource fetch_source(const SourceFetch& from, const TileSpan& span, float* const target[3],
                           TilePlanes& planes);

}  // namespace patina
