// SPDX-License-Identifier: MIT
#include "composite/prefix_cache.h"

#include <cstring>

namespace patina {
namespace {

std::size_t plane_count(int depth, ChannelBits channels) {
    std::size_t planes = 0;
    for (const ChannelInfo& entry : kChannels)
        if ((channels & channel_bit(entry.channel)) != 0)
            planes += static_cast<std::size_t>(component_count(entry.channel) + (depth > 0));
    return planes;
}

}  // namespace

PrefixCache::PrefixCache(int size, int depth, ChannelBits channels)
    : size_(size),
      depth_(depth),
      channels_(channels),
      memory_(size_bytes(size, depth, channels) / sizeof(float)) {}

std::size_t PrefixCache::size_bytes(int size, int depth, ChannelBits channels) {
    return plane_count(depth, channels) * static_cast<std::size_t>(size) *
           static_cast<std::size_t>(size) * sizeof(float);
}

/// Calls copy(plane of the tile, place in the cache) for each plane.
template <typename Copy>
void PrefixCache::for_each_plane(const TileSpan& span, ChannelBits wanted, TilePlanes& planes,
                                 const Copy& copy) const {
    const std::size_t side = static_cast<std::size_t>(size_);
    float* place =
        memory_.data() + static_cast<std::size_t>(span.y) * side + static_cast<std::size_t>(span.x);
    for (const ChannelInfo& entry : kChannels) {
        if ((channels_ & channel_bit(entry.channel)) == 0) continue;
        if ((wanted & channel_bit(entry.channel)) == 0) {
            const int planes_of_channel = component_count(entry.channel) + (depth_ > 0 ? 1 : 0);
            place += side * side * static_cast<std::size_t>(planes_of_channel);
            continue;
        }
        for (int k = 0; k < component_count(entry.channel); ++k, place += side * side)
            copy(planes.channel(depth_, entry.channel, k), place);
        if (depth_ == 0) continue;
        copy(planes.coverage(depth_, entry.channel), place);
        place += side * side;
    }
}

void PrefixCache::store(const TileSpan& span, TilePlanes& planes) {
    const std::size_t bytes = static_cast<std::size_t>(span.count) * sizeof(float);
    for_each_plane(span, channels_, planes,
                   [&](const float* tile, float* cache) { std::memcpy(cache, tile, bytes); });
}

void PrefixCache::load(const TileSpan& span, ChannelBits wanted, TilePlanes& planes) const {
    const std::size_t bytes = static_cast<std::size_t>(span.count) * sizeof(float);
    for_each_plane(span, wanted, planes,
                   [&](float* tile, const float* cache) { std::memcpy(tile, cache, bytes); });
}

}  // namespace patina
