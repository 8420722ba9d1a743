// SPDX-License-Identifier: MIT
#pragma once

/// Compositing a rectangle of the maps: tiles of rows, in parallel.

#include "composite/composite.h"
#include "composite/run_tile.h"

namespace patina {

struct CompositeJob {
    const ProgramData* program = nullptr;
    const BoundImages* images = nullptr;
    std::vector<CachePoint> caches = {};
    int size = 0;
    TexelRect rect = {};
    /// Pixels of the maps that are made, RGBA8, `size` texels a side; null for the others.
    std::array<std::byte*, kBakedMapCount> targets = {};
};

/// The channels that a map shows.
ChannelBits channels_of(BakedMap map);

/// Writes the texels of `rect` in each target. Returns false when it was cancelled before the end.
bool composite_rect(const CompositeJob& job, const Progress& progress);

}  // namespace patina
