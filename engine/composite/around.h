// SPDX-License-Identifier: MIT
#pragma once

/// Adjustments that look around (blur, sharpen, warp), of channels and of masks, and sources that
/// read the relief below their layer. A tile alone cannot make them: before the tiles that are
/// asked for are run, what lies below each such layer is composited for them and a halo of the
/// layer's reach (and of those above it), and kept as float32 rows. A run that comes to the layer
/// reads its neighbours there. A map is made strip by strip, from the top: only the rows around the
/// strip at hand are kept. The borders of the texture meet.

#include <memory>

#include "composite/bound_images.h"
#include "composite/composite.h"
#include "composite/prefix_cache.h"

namespace patina {

/// How far from its place, in texels of a map of `size` a side, an adjustment reads.
int reach_of(const AdjustmentSettings& adjustment, int size);
/// How far from a changed texel others change by the adjustments of a program.
int reach_of(const ProgramData& program, int size);

/// Rows that follow each other, the first of which may lie above the texture: row -1 is the last
/// one.
struct RowRange {
    int begin = 0;
    int end = 0;
    int length() const { return end - begin; }
};

/// What lies below one layer that looks around, at one resolution: some rows of it.
class AroundPlanes {
  public:
    /// Room for `capacity` rows, or for all of them where there are fewer.
    AroundPlanes(const AroundRecord& record, const AdjustmentSettings& adjustment,
                 ChannelBits channels, int size, int capacity);

    const AroundRecord& record() const { return record_; }
    const AdjustmentSettings& adjustment() const { return adjustment_; }
    ChannelBits channels() const { return channels_; }
    int size() const { return size_; }
    int reach() const { return reach_; }
    /// Of a blur: that of the texel itself, and of each of the two that are j texels away.
    const std::vector<float>& weights() const { return weights_; }

    /// Makes `rows` (no more than there is room for, beginning no earlier than those before) the
    /// ones that are kept, and returns those of them that have to be written. Where there is room
    /// for all, all are kept.
    RowRange keep_rows(RowRange rows);

    /// Row y of the texture, one of those that are kept, of a component; times the coverage where
    /// the layer is in a group. Of a blur the sums along the row.
    float* row(Channel channel, int component, int y) {
        return memory_.data() + row_start(first_plane(channel) + component, y);
    }
    const float* row(Channel channel, int component, int y) const {
        return memory_.data() + row_start(first_plane(channel) + component, y);
    }
    /// How many planes of a channel are blurred: its components, and in a group its coverage last.
    /// For relief one follows with the heights as they are.
    int blurred_planes_of(Channel channel) const {
        return component_count(channel) + (record_.has_coverage() ? 1 : 0);
    }
    std::size_t size_bytes() const { return memory_.size() * sizeof(float); }

  private:
    int first_plane(Channel channel) const;
    std::size_t row_start(int plane, int y) const;

    AroundRecord record_;
    AdjustmentSettings adjustment_;
    ChannelBits channels_;
    int size_;
    int reach_;
    int capacity_;  ///< rows
    RowRange kept_;
    std::vector<float> weights_;
    PixelVector<float> memory_;
};

/// One for each of ProgramData::around; null for those that nothing asks for.
using AroundList = std::vector<std::shared_ptr<AroundPlanes>>;

/// What is kept around a strip, for all layers together.
inline constexpr std::size_t kAroundBytes = std::size_t{32} << 20;

struct AroundJob {
    const ProgramData* program = nullptr;
    const BoundImages* images = nullptr;
    std::vector<CachePoint> caches = {};  ///< those that are read are used
    ChannelBits wanted = kAllChannels;
    int size = 0;
    TexelRect rect = {};  ///< the texels that are going to be run, and those next to them
    /// What a strip keeps, where the reach of the layers and the least number of rows allow.
    std::size_t budget_bytes = kAroundBytes;
};

/// Composites what lies below the layers that look around, for one strip of a rectangle after the
/// other.
class AroundPass {
  public:
    /// The job's program and images have to stay.
    explicit AroundPass(AroundJob job);
    ~AroundPass();
    AroundPass(const AroundPass&) = delete;
    AroundPass& operator=(const AroundPass&) = delete;

    /// How many rows of the rectangle a strip has: all of them where nothing looks around, else so
    /// many that what is kept stays within the budget, and enough for all threads.
    int strip_rows() const { return strip_rows_; }
    /// Gets ready for rows [y0, y1) of the rectangle, at most strip_rows() and further down than
    /// those before. Incomplete when it was cancelled.
    void move_to(int y0, int y1, const Progress& progress);
    const AroundList& list() const { return list_; }
    /// What is kept, in all.
    std::size_t size_bytes() const;

  private:
    struct Step;

    AroundJob job_;
    int strip_rows_ = 0;
    AroundList list_;
    std::vector<Step> steps_;
};

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
