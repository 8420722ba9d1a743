// SPDX-License-Identifier: MIT
#pragma once

/// What a stack accumulated up to one of its layers, as float32 planes of a whole map, so that an
/// edit above it need not start from the bottom. Equal bit for bit to what running it again gives.

#include <memory>
#include <vector>

#include "composite/tile.h"

namespace patina {

class PrefixCache {
  public:
    /// Memory for `channels` at `size` texels a side; with coverage inside groups (depth > 0).
    PrefixCache(int size, int depth, ChannelBits channels);

    /// Copies the accumulators of the span between the tile's planes and the cache. Spans that do
    /// not overlap may be stored at the same time.
    void store(const TileSpan& span, TilePlanes& planes);
    /// Only the channels in `wanted`.
    void load(const TileSpan& span, ChannelBits wanted, TilePlanes& planes) const;

    ChannelBits channels() const { return channels_; }
    std::size_t size_bytes() const { return memory_.size() * sizeof(float); }
    /// How much a cache of these would take.
    static std::size_t size_bytes(int size, int depth, ChannelBits channels);

  private:
    template <typename Copy>
    void for_each_plane(const TileSpan& span, ChannelBits wanted, TilePlanes& planes,
                        const Copy& copy) const;

    int size_;
    int depth_;
    ChannelBits channels_;
    mutable PixelVector<float> memory_;
};

/// Where a run of a program takes from a cache or gives to one.
struct CachePoint {
    Checkpoint place = {};
    std::shared_ptr<PrefixCache> cache = {};
    bool read = false;  ///< false: written when the run gets there
};

}  // namespace patina
