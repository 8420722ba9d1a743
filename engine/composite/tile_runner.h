// SPDX-License-Identifier: MIT
#pragma once

/// Running the operations of a program on tiles.

#include <functional>
#include <limits>
#include <memory>

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

/// Runs the operations on one tile after the other, in the planes of one thread. What is the same
/// in every tile is worked out once, when it is made.
class TileRunner {
  public:
    /// Both have to stay.
    TileRunner(const TileRun& run, TilePlanes& planes);
    ~TileRunner();
    TileRunner(TileRunner&&) noexcept;
    TileRunner& operator=(TileRunner&&) noexcept;

    /// Leaves the wanted channels of the stack in the planes of depth 0.
    void run(const TileSpan& span);

  private:
    class Runner;
    std::unique_ptr<Runner> runner_;
};

}  // namespace patina
