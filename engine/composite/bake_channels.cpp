// SPDX-License-Identifier: MIT
#include "composite/bake_channels.h"

#include <algorithm>

#include "composite/blend_kernels.h"
#include "composite/composite_rect.h"

namespace patina {
namespace {

std::size_t row_start(int y, int size) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size);
}

Slot slot_of(Channel channel) {
    switch (channel) {
        case Channel::BaseColor:
        case Channel::Opacity:
            return Slot::BaseColor;
        case Channel::Metalness:
        case Channel::Roughness:
            return Slot::MetallicRoughness;
        case Channel::Normal:
        case Channel::Height:
            return Slot::Normal;
        case Channel::Occlusion:
            return Slot::Occlusion;
        case Channel::Emissive:
            return Slot::Emissive;
    }
    return Slot::BaseColor;
}

/// The channels of a tile, colours in linear light.
ChannelSpan span_of(const ProgramData& program, ChannelBits channels, const TileSpan& span,
                    TilePlanes& tile) {
    ChannelSpan result{.x = span.x, .y = span.y, .count = span.count};
    for (const ChannelInfo& entry : kChannels) {
        const ChannelBits bit = channel_bit(entry.channel);
        if ((channels & bit) == 0) continue;
        float* components[3] = {};
        for (int k = 0; k < component_count(entry.channel); ++k)
            components[k] = tile.channel(0, entry.channel, k);
        if ((program.top_encoded & bit) != 0) decode_tile(components, span.count);
        std::copy_n(components, 3, result.values[static_cast<std::size_t>(entry.channel)].begin());
    }
    return result;
}

}  // namespace

bool varies(const Program& program, Channel channel) {
    if (channel == Channel::Height)
        return (program.data().touched & channel_bit(Channel::Height)) != 0;
    return !std::holds_alternative<SlotConstant>(
        program.slots()[static_cast<std::size_t>(slot_of(channel))]);
}

Status composite_channels(const Program& program, ImageProvider& images, int size,
                          const std::vector<Channel>& wanted, const ChannelSink& sink,
                          const Progress& progress) {
    const ProgramData& data = program.data();
    ChannelBits channels = 0;
    for (const Channel channel : wanted) channels |= channel_bit(channel);
    ChannelBits read = data.with_needed(channels);
    if ((channels & channel_bit(Channel::Normal)) != 0) read |= channel_bit(Channel::Height);
    const Result<BoundImages> bound = images_for_bake(data, read, size, images);
    if (!bound) return passed_on(bound);
    const bool done = composite_tiles(
        {.program = &data,
         .images = &*bound,
         .wanted = channels,
         .size = size,
         .rect = {0, 0, size, size}},
        [&](const TileSpan& span, TilePlanes& tile) { sink(span_of(data, channels, span, tile)); },
        progress);
    if (!done) return failure("baking was cancelled");
    return {};
}

Result<ChannelPlanes> bake_channels(const Program& program, ImageProvider& images, int size,
                                    const std::vector<Channel>& wanted, const Progress& progress) {
    ChannelPlanes out;
    out.size = size;
    for (const Channel channel : wanted)
        for (int k = 0; k < component_count(channel); ++k)
            out.planes[static_cast<std::size_t>(channel)][static_cast<std::size_t>(k)].resize(
                row_start(size, size));
    const Status done = composite_channels(
        program, images, size, wanted,
        [&](const ChannelSpan& span) {
            for (const Channel channel : wanted)
                for (int k = 0; k < component_count(channel); ++k)
                    std::copy_n(
                        span.plane(channel, k), span.count,
                        out.planes[static_cast<std::size_t>(channel)][static_cast<std::size_t>(k)]
                                .data() +
                            row_start(span.y, size) + span.x);
        },
        progress);
    if (!done) return passed_on(done);
    return out;
}

}  // namespace patina
