// SPDX-License-Identifier: MIT
#pragma once

/// Adjustments that look around (blur, sharpen, warp), and sources that read the relief below their
/// layer. A tile alone cannot make them: before the tiles that are asked for are run, what lies
/// below each such layer is composited for them and a halo of the layer's reach (and of those above
/// it), and kept as float32 planes. A run that comes to the layer reads its neighbours there. The
/// borders of the texture meet.

#include <memory>

#include "composite/bound_images.h"
#include "composite/composite.h"
#include "composite/prefix_cache.h"

namespace patina {

/// How far from its place, in texels of a map of `size` a side, an adjustment reads.
int reach_of(const AdjustmentSettings& adjustment, int size);
/// How far from a changed texel others change by the adjustments of a program.
int reach_of(const ProgramData& program, int size);

/// What lies below one layer that looks around, at one resolution.
class AroundPlanes {
  public:
    AroundPlanes(const AroundRecord& record, const AdjustmentSettings& adjustment,
                 ChannelBits channels, int size);

    const AroundRecord& record() const { return record_; }
    const AdjustmentSettings& adjustment() const { return adjustment_; }
    ChannelBits channels() const { return channels_; }
    int size() const { return size_; }
    int reach() const { return reach_; }
    /// Of a blur: that of the texel itself, and of each of the two that are j texels away.
    const std::vector<float>& weights() const { return weights_; }

    /// Row y of a component; times the coverage where the layer is in a group. Of a blur the sums
    /// along the row.
    float* row(Channel channel, int component, int y) {
        return memory_.data() + row_start(first_plane(channel) + component, y);
    }
    const float* row(Channel channel, int component, int y) const {
        return memory_.data() + row_start(first_plane(channel) + component, y);
    }
    /// How many planes of a channel are blurred: its components, and in a group its coverage last.
    int blurred_planes_of(Channel channel) const {
        return component_count(channel) + (record_.depth > 0 ? 1 : 0);
    }
    /// Those, and for relief the heights as they are.
    int planes_of(Channel channel) const {
        return blurred_planes_of(channel) + (record_.relief ? 1 : 0);
    }

  private:
    int first_plane(Channel channel) const;
    std::size_t row_start(int plane, int y) const {
        const auto side = static_cast<std::size_t>(size_);
        return (static_cast<std::size_t>(plane) * side + static_cast<std::size_t>(y)) * side;
    }

    AroundRecord record_;
    AdjustmentSettings adjustment_;
    ChannelBits channels_;
    int size_;
    int reach_;
    std::vector<float> weights_;
    PixelVector<float> memory_;
};

/// One for each of ProgramData::around; null for those that nothing asks for.
using AroundList = std::vector<std::shared_ptr<AroundPlanes>>;

struct AroundJob {
    const ProgramData* program = nullptr;
    const BoundImages* images = nullptr;
    std::vector<CachePoint> caches = {};  ///< those that are read are used
    ChannelBits wanted = kAllChannels;
    int size = 0;
    TexelRect rect = {};  ///< the texels that are going to be run, and those next to them
};
/// Composites what lies below the layers that look around. Incomplete when it was cancelled.
AroundList prepared_around(const AroundJob& job, const Progress& progress);

/// What an adjustment makes of one channel in a tile.
struct AroundTask {
    const AroundPlanes* planes = nullptr;
    Channel channel = Channel::BaseColor;
    TileSpan span = {};
    const float* own[3] = {};  ///< the accumulator
    float* to[3] = {};
};
void adjust_around(const AroundTask& task);

/// What a relief source gives in a tile.
void fetch_relief(const AroundPlanes& planes, const ReliefSource& source, const TileSpan& span,
                  float* to);

}  // namespace patina
