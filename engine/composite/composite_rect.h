// SPDX-License-Identifier: MIT
#pragma once

/// Compositing a rectangle of the maps: tiles of rows, in parallel.

#include "composite/composite.h"
#include "composite/tile_runner.h"

namespace patina {

struct TilesJob {
    const ProgramData* program = nullptr;
    const BoundImages* images = nullptr;
    std::vector<CachePoint> caches = {};
    ChannelBits wanted = 0;
    int size = 0;
    TexelRect rect = {};
    std::size_t around_bytes = kAroundBytes;  ///< AroundJob::budget_bytes
};
/// Takes a tile whose wanted channels lie in the planes of depth 0; called from several threads at
/// once, for other tiles.
using TileSink = std::function<void(const TileSpan& span, TilePlanes& planes)>;

/// Composites the tiles of `rect` and gives each to the sink; normals are bent by the heights.
/// Returns false when it was cancelled before the end.
bool composite_tiles(const TilesJob& job, const TileSink& sink, const Progress& progress);

struct CompositeJob {
    const ProgramData* program = nullptr;
    const BoundImages* images = nullptr;
    std::vector<CachePoint> caches = {};
    int size = 0;
    TexelRect rect = {};
    /// Pixels of the maps that are made, RGBA8, `size` texels a side; null for the others.
    std::array<std::byte*, kBakedMapCount> targets = {};
};

/// The channels that a map shows, and those that bend what it shows.
ChannelBits channels_of(BakedMap map);

/// Writes the texels of `rect` in each target. Returns false when it was cancelled before the end.
bool composite_rect(const CompositeJob& job, const Progress& progress);

}  // namespace patina
