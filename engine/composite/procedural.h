// SPDX-License-Identifier: MIT
#pragma once

/// Evaluating a procedural source over one tile.

#include "composite/surface_sources.h"
#include "composite/tile.h"

namespace patina {

/// The mean over the texture of what contrast and ramp make of a source, before it is encoded: what
/// it fades to where its cells are too small to be shown. In x where it is a scalar.
glm::vec3 procedural_mean(const ProceduralSource& source, bool scalar);

/// Three planes of a colour or normal, one of a scalar, as the record's reading says; from the
/// place of the texels alone, with detail that is finer than a texel faded to its mean.
/// @param at        other places, where it is projected
/// @param patterns  of the thread, where those that are wanted again are kept
void procedural_tile(const SourceRecord& record, const TileSpan& span, const TileCoordinates& at,
                     float* const planes[3], PatternPlanes& patterns);

}  // namespace patina
