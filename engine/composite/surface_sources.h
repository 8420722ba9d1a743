// SPDX-License-Identifier: MIT
#pragma once

/// What sources read of the model: the parts that a geometry source picks, the places onto which
/// an image or procedural is projected. Without a surface, or one without UVs, parts are picked
/// everywhere and nothing is projected.

#include <cstdint>
#include <functional>
#include <vector>

#include "composite/operations.h"
#include "composite/planes.h"
#include "composite/tile.h"
#include "scene/uv_map.h"

namespace patina {

/// For each part of the surface, whether the source picks it.
std::vector<std::uint8_t> chosen_parts(const GeometrySource& source, const UvSurface& surface);

/// What a source that picks all parts, or none, stands for: a constant. Other sources are returned
/// as they are.
const Source& resolved_source(const Source& source, const UvSurface* surface);

/// The model at one resolution; nulls where none is at hand.
struct SurfaceTexels {
    const UvSurface* surface = nullptr;
    const UvMap* map = nullptr;
};

/// 1 where the texels of a tile show a part that is chosen, else 0.
void fetch_chosen_parts(const SurfaceTexels& texels, const std::vector<std::uint8_t>& chosen,
                        const TileSpan& span, float* to);

/// Coordinates of a source at the texels of a tile, after its transform.
struct TileCoordinates {
    const float* u = nullptr;
    const float* v = nullptr;
};
/// Reads a source at these coordinates, as it is read at UVs. What it returns may lie in the
/// planes that it is given.
using ReadAtCoordinates =
    std::function<FetchedSource(const TileCoordinates& at, float* const planes[3])>;

/// What a source that is projected gives: of tri-planar ones the pictures along the three axes,
/// each by its weight; normals turned to the surface's own frame.
FetchedSource fetch_projected(const SourceRecord& record, const SurfaceTexels& texels,
                              const TileSpan& span, float* const target[3], TilePlanes& planes,
                              const ReadAtCoordinates& read);

}  // namespace patina
