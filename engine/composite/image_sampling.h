// SPDX-License-Identifier: MIT
#pragma once

/// Reading an image at any place: transformed, wrapped and filtered, for the tiles in which its
/// texels do not lie on those of the map.

#include "composite/fetch_kernels.h"
#include "composite/surface_sources.h"
#include "composite/tile.h"

namespace patina {

/// How the taps of a filter are taken.
struct SamplingTask {
    const Image* image = nullptr;
    const SourceRecord* record = nullptr;
    Components components = {};
    bool invert = false;      ///< 1 - x of each tap
    bool decode = false;      ///< each tap from sRGB to linear, so that light is what is filtered
    TileCoordinates at = {};  ///< where, if not at the texels of the tile
    float* planes[3] = {};
};
/// The filtered values at the centres of the texels of `span`. Bilinear taps lie at texel centres;
/// (0, 0) is the upper left corner of the image.
void sample_tile(const SamplingTask& task, const TileSpan& span);

}  // namespace patina
