// SPDX-License-Identifier: MIT
#pragma once

/// Running the operations of a program on one tile.

#include <functional>
#include <limits>

#include "composite/around.h"
#include "composite/source_fetch.h"

namespace patina {

/// Called after each Blend, Adjust and BlendGroup, with what it laid on and the planes as they are
/// now.
using BlendObserver =
    std::function<void(const Operation&, const FetchedSource& source, float weight_of_first_texel,
                       float mask_of_first_texel, TilePlanes& planes)>;

struct TileRun {
    const ProgramData* program = nullptr;
    const BoundImages* images = nullptr;
    ChannelBits wanted = kAllChannels;
    std::vector<CachePoint> caches = {};  ///< in the order of the operations
    BlendObserver observer = nullptr;
    /// Of all that look around; where they are null, the channel is taken to be the same in every
    /// texel.
    const AroundList* around = nullptr;
    /// The run begins here. Where that is not the first operation, nothing that lies below is in
    /// the planes.
    std::int32_t start = 0;
    /// The run ends before this operation, with everything before it done in every texel.
    std::int32_t stop = std::numeric_limits<std::int32_t>::max();
};

/// Leaves the wanted channels of the stack in the planes of depth 0.
void run_tile(const TileRun& run, const TileSpan& span, TilePlanes& planes);

}  // namespace patina
