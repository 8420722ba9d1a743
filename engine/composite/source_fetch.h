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

/// @param planes  scratch: the source planes are overwritten
FetchedSource fetch_source(const SourceRecord& record, const BoundImage& image,
                           const TileSpan& span, TilePlanes& planes);

}  // namespace patina
