// SPDX-License-Identifier: MIT
#pragma once

/// Evaluating a procedural source over one tile.

#include "composite/tile.h"

namespace patina {

/// Three planes of a colour or normal, one of a scalar, as the record's reading says; from the
/// place of the texels alone, with detail that is finer than a texel faded to its mean.
void procedural_tile(const SourceRecord& record, const TileSpan& span, float* const planes[3]);

}  // namespace patina
