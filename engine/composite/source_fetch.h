// SPDX-License-Identifier: MIT
#pragma once

/// Evaluating a source over one tile: constant, image or procedural.

#include "composite/bound_images.h"
#include "composite/planes.h"
#include "composite/tile.h"

namespace patina {

/// What a source gives: three planes of a colour or normal, one of a scalar, and its own coverage.
/// They point into the planes of the tile, or at constants that live as long as the program.
struct FetchedSource {
    ReadPlane components[3] = {};
    ReadPlane coverage = {};
};

/// Any source but relief, for which the run has to look around.
/// @param target  planes that may be overwritten, and hold the components unless they are constant
/// @param planes  scratch: the plane of the source's coverage is overwritten
FetchedSource fetch_source(const SourceRecord& record, const BoundImage& image,
                           const TileSpan& span, float* const target[3], TilePlanes& planes);

}  // namespace patina
