// SPDX-License-Identifier: MIT
#include "composite/bake_channels.h"

#include <algorithm>
#include <cstring>

#include "composite/output_kernels.h"
#include "composite/run_tile.h"
#include "composite/uniform_values.h"
#include "core/parallel.h"

namespace patina {
namespace {

constexpr int kRowsPerTask = 16;

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

/// Calls `visit(span)` for the tiles of some rows.
template <typename Visit>
void for_each_span(std::int64_t first_row, std::int64_t last_row, int size, const Visit& visit) {
    for (auto y = static_cast<int>(first_row); y < static_cast<int>(last_row); ++y)
        for (int x = 0; x < size; x += kTileTexels)
            visit(TileSpan{.x = x, .y = y, .count = std::min(kTileTexels, size - x), .size = size});
}

class ChannelBaker {
  public:
    ChannelBaker(const ProgramData& program, const BoundImages& images, const AroundList& around,
                 ChannelBits wanted, ChannelPlanes& out)
        : program_(program), images_(images), around_(around), wanted_(wanted), out_(out) {}

    void bake_rows(std::int64_t first, std::int64_t last) {
        TilePlanes planes(program_.depths);
        const TileRun run{
            .program = &program_, .images = &images_, .wanted = wanted_, .around = &around_};
        for_each_span(first, last, out_.size, [&](const TileSpan& span) {
            run_tile(run, span, planes);
            for (const ChannelInfo& entry : kChannels)
                if ((wanted_ & channel_bit(entry.channel)) != 0) copy(entry.channel, span, planes);
        });
    }

    /// Bends the normals by the heights; both are whole.
    void bend_rows(std::int64_t first, std::int64_t last) {
        TilePlanes planes(1);
        std::array<std::vector<float>, 3> heights;
        for (auto& row : heights) row.resize(std::size_t{kTileTexels + 2 + kMaxLanes});
        for_each_span(first, last, out_.size, [&](const TileSpan& span) {
            for (std::size_t row = 0; row < heights.size(); ++row)
                read_heights(span, static_cast<int>(row) - 1, heights[row]);
            for (int k = 0; k < 3; ++k)
                std::memcpy(planes.channel(0, Channel::Normal, k), normal_at(span, k), bytes(span));
            add_relief_tile({.above = heights[0].data(),
                             .here = heights[1].data(),
                             .below = heights[2].data(),
                             .depth_texels = program_.height_scale * static_cast<float>(out_.size),
                             .count = span.count,
                             .normal = {planes.channel(0, Channel::Normal, 0),
                                        planes.channel(0, Channel::Normal, 1),
                                        planes.channel(0, Channel::Normal, 2)}});
            for (int k = 0; k < 3; ++k)
                std::memcpy(normal_at(span, k), planes.channel(0, Channel::Normal, k), bytes(span));
        });
    }

  private:
    static std::size_t bytes(const TileSpan& span) {
        return static_cast<std::size_t>(span.count) * sizeof(float);
    }
    float* plane_at(Channel channel, int component, const TileSpan& span) {
        return out_.planes[static_cast<std::size_t>(channel)][static_cast<std::size_t>(component)]
                   .data() +
               row_start(span.y, span.size) + span.x;
    }
    float* normal_at(const TileSpan& span, int component) {
        return plane_at(Channel::Normal, component, span);
    }

    void copy(Channel channel, const TileSpan& span, TilePlanes& planes) {
        const int components = component_count(channel);
        for (int k = 0; k < components; ++k)
            std::memcpy(plane_at(channel, k, span), planes.channel(0, channel, k), bytes(span));
        if ((program_.top_encoded & channel_bit(channel)) == 0) return;
        float* const color[3] = {plane_at(channel, 0, span), plane_at(channel, 1, span),
                                 plane_at(channel, 2, span)};
        for (int i = 0; i < span.count; ++i) {
            const glm::vec3 linear = linear_color({color[0][i], color[1][i], color[2][i]});
            for (int k = 0; k < 3; ++k) color[k][i] = linear[k];
        }
    }

    /// From one texel before the span to one after it; the borders of the map meet.
    void read_heights(const TileSpan& span, int dy, std::vector<float>& row) {
        const int size = span.size;
        const float* const from =
            out_.plane(Channel::Height).data() + row_start((span.y + dy + size) % size, size);
        std::memcpy(row.data() + 1, from + span.x, bytes(span));
        row[0] = from[(span.x - 1 + size) % size];
        row[static_cast<std::size_t>(span.count) + 1] = from[(span.x + span.count) % size];
    }

    const ProgramData& program_;
    const BoundImages& images_;
    const AroundList& around_;
    ChannelBits wanted_;
    ChannelPlanes& out_;
};

}  // namespace

bool varies(const Program& program, Channel channel) {
    if (channel == Channel::Height)
        return (program.data().touched & channel_bit(Channel::Height)) != 0;
    return !std::holds_alternative<SlotConstant>(
        program.slots()[static_cast<std::size_t>(slot_of(channel))]);
}

Result<ChannelPlanes> bake_channels(const Program& program, ImageProvider& images, int size,
                                    const std::vector<Channel>& wanted, const Progress& progress) {
    ChannelBits channels = 0;
    for (const Channel channel : wanted) channels |= channel_bit(channel);
    const bool relief = (channels & channel_bit(Channel::Normal)) != 0 &&
                        (program.data().touched & channel_bit(Channel::Height)) != 0;
    if (relief) channels |= channel_bit(Channel::Height);
    channels = program.data().with_needed(channels);
    const Result<BoundImages> bound = images_for_bake(program.data(), channels, size, images);
    if (!bound) return passed_on(bound);

    ChannelPlanes out;
    out.size = size;
    for (const ChannelInfo& entry : kChannels)
        if ((channels & channel_bit(entry.channel)) != 0)
            for (int k = 0; k < component_count(entry.channel); ++k)
                out.planes[static_cast<std::size_t>(entry.channel)][static_cast<std::size_t>(k)]
                    .resize(row_start(size, size));
    const AroundList around = prepared_around({.program = &program.data(),
                                               .images = &*bound,
                                               .wanted = channels,
                                               .size = size,
                                               .rect = {0, 0, size, size}},
                                              progress);
    ChannelBaker baker(program.data(), *bound, around, channels, out);
    const auto over_rows = [&](auto step) {
        parallel_for(0, size, kRowsPerTask, [&](std::int64_t first, std::int64_t last) {
            if (!progress.cancelled()) step(first, last);
        });
    };
    over_rows([&](std::int64_t first, std::int64_t last) { baker.bake_rows(first, last); });
    if (relief)
        over_rows([&](std::int64_t first, std::int64_t last) { baker.bend_rows(first, last); });
    if (progress.cancelled()) return failure("baking was cancelled");
    return out;
}

}  // namespace patina
