// SPDX-License-Identifier: MIT
#include "composite/composite_rect.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <optional>

#include "composite/output_kernels.h"
#include "core/parallel.h"

namespace patina {
namespace {

/// Rows that one task takes: enough that the two rows of heights beyond them are a small part.
constexpr int kRowsPerTask = 16;

/// Maps from this side on do not stay in the caches until someone reads them.
constexpr int kLargeMapSide = 2048;

/// Composites rows of a rectangle, one after the other.
class RowCompositor {
  public:
    RowCompositor(const TilesJob& job, const AroundList& around, const TileSink& sink);
    void composite_row(int y);

  private:
    template <typename Visit>
    void for_each_span(int y, const Visit& visit);
    void ensure_heights(int y);
    void composite_heights(int y, std::vector<float>& row);
    float height_at(int x, int y);
    void add_relief(const TileSpan& span);
    std::vector<float>& height_row(int y) {
        return heights_[static_cast<std::size_t>(wrapped(y, 3))];
    }

    const TilesJob& job_;
    const TileSink& sink_;
    TileRun run_;
    TileRun height_run_;
    TilePlanes planes_;
    TileRunner runner_;
    std::optional<TileRunner> height_runner_;  ///< where heights bend the normals
    /// Heights of three successive rows, from one texel left of the rectangle to one right of it.
    std::array<std::vector<float>, 3> heights_;
    int next_height_row_;
};

/// Whether heights bend the normals that are wanted.
bool has_relief(const TilesJob& job) {
    return (job.wanted & channel_bit(Channel::Normal)) != 0 &&
           (job.program->touched & channel_bit(Channel::Height)) != 0;
}

RowCompositor::RowCompositor(const TilesJob& job, const AroundList& around, const TileSink& sink)
    : job_(job),
      sink_(sink),
      run_{.program = job.program,
           .images = job.images,
           .wanted = job.program->with_needed(job.wanted),
           .caches = job.caches,
           .around = &around},
      height_run_{.program = job.program,
                  .images = job.images,
                  .wanted = channel_bit(Channel::Height),
                  .around = &around},
      planes_(job.program->depths),
      runner_(run_, planes_),
      next_height_row_(-2) {
    for (const CachePoint& point : job.caches)
        if (point.read) height_run_.caches.push_back(point);
    if (!has_relief(job)) return;
    height_runner_.emplace(height_run_, planes_);
    const auto width = static_cast<std::size_t>(job.rect.x1 - job.rect.x0);
    for (std::vector<float>& row : heights_) row.resize(width + 2 + kMaxLanes);
}

template <typename Visit>
void RowCompositor::for_each_span(int y, const Visit& visit) {
    for (int x = job_.rect.x0; x < job_.rect.x1; x += kTileTexels)
        visit(TileSpan{
            .x = x, .y = y, .count = std::min(kTileTexels, job_.rect.x1 - x), .size = job_.size});
}

float RowCompositor::height_at(int x, int y) {
    height_runner_->run({.x = x, .y = y, .count = 1, .size = job_.size});
    return planes_.channel(0, Channel::Height)[0];
}

/// The height composite of row y, which may lie beyond the border; the borders meet.
void RowCompositor::composite_heights(int y, std::vector<float>& row) {
    const int inside_y = wrapped(y, job_.size);
    for_each_span(inside_y, [&](const TileSpan& span) {
        height_runner_->run(span);
        std::memcpy(row.data() + 1 + span.x - job_.rect.x0, planes_.channel(0, Channel::Height),
                    static_cast<std::size_t>(span.count) * sizeof(float));
    });
    const std::size_t last = static_cast<std::size_t>(job_.rect.x1 - job_.rect.x0);
    const bool whole = job_.rect.x0 == 0 && job_.rect.x1 == job_.size;
    row[0] = whole ? row[last] : height_at(wrapped(job_.rect.x0 - 1, job_.size), inside_y);
    row[last + 1] = whole ? row[1] : height_at(wrapped(job_.rect.x1, job_.size), inside_y);
}

/// Makes sure that the heights of rows y - 1 to y + 1 are there; y only grows.
void RowCompositor::ensure_heights(int y) {
    next_height_row_ = std::max(next_height_row_, y - 1);
    for (; next_height_row_ <= y + 1; ++next_height_row_)
        composite_heights(next_height_row_, height_row(next_height_row_));
}

void RowCompositor::add_relief(const TileSpan& span) {
    const int from = span.x - job_.rect.x0;
    add_relief_tile(
        {.above = height_row(span.y - 1).data() + from,
         .here = height_row(span.y).data() + from,
         .below = height_row(span.y + 1).data() + from,
         .depth_texels = job_.program->height_scale * static_cast<float>(job_.size),
         .count = span.count,
         .normal = {planes_.channel(0, Channel::Normal, 0), planes_.channel(0, Channel::Normal, 1),
                    planes_.channel(0, Channel::Normal, 2)}});
}

void RowCompositor::composite_row(int y) {
    if (height_runner_) ensure_heights(y);
    for_each_span(y, [&](const TileSpan& span) {
        runner_.run(span);
        if (height_runner_) add_relief(span);
        sink_(span, planes_);
    });
}

/// Writes a tile into a map.
void write(const CompositeJob& job, BakedMap map, const TileSpan& span, TilePlanes& planes) {
    std::byte* const target = job.targets[static_cast<std::size_t>(map)];
    if (target == nullptr) return;
    const std::size_t texel =
        static_cast<std::size_t>(span.y) * static_cast<std::size_t>(job.size) +
        static_cast<std::size_t>(span.x);
    const auto plane = [&](Channel channel, int component = 0) {
        return ReadPlane{.data = planes.channel(0, channel, component)};
    };
    const auto color_encoding = [&](Channel channel) {
        const bool encoded = (job.program->top_encoded & channel_bit(channel)) != 0;
        return encoded ? OutputEncoding::AsIs : OutputEncoding::LinearColor;
    };
    OutputTask task{.components = {{}, {}, {}, uniform_one()},
                    .count = span.count,
                    .to_memory = job.size >= kLargeMapSide,
                    .rgba = reinterpret_cast<std::uint8_t*>(target + 4 * texel)};
    const auto set_color = [&](Channel channel) {
        for (int k = 0; k < 3; ++k) task.components[k] = plane(channel, k);
    };
    switch (map) {
        case BakedMap::BaseColor:
            task.encoding = color_encoding(Channel::BaseColor);
            set_color(Channel::BaseColor);
            task.components[3] = plane(Channel::Opacity);
            break;
        case BakedMap::OcclusionRoughnessMetalness:
            task.components[0] = plane(Channel::Occlusion);
            task.components[1] = plane(Channel::Roughness);
            task.components[2] = plane(Channel::Metalness);
            break;
        case BakedMap::Normal:
            task.encoding = OutputEncoding::Normal;
            set_color(Channel::Normal);
            break;
        case BakedMap::Emissive:
            task.encoding = color_encoding(Channel::Emissive);
            set_color(Channel::Emissive);
            break;
    }
    write_tile(task);
}

ChannelBits channels_of_targets(const CompositeJob& job) {
    ChannelBits wanted = 0;
    for (int map = 0; map < kBakedMapCount; ++map)
        if (job.targets[static_cast<std::size_t>(map)] != nullptr)
            wanted |= channels_of(static_cast<BakedMap>(map));
    return wanted;
}

}  // namespace

ChannelBits channels_of(BakedMap map) {
    switch (map) {
        case BakedMap::BaseColor:
            return channel_bit(Channel::BaseColor) | channel_bit(Channel::Opacity);
        case BakedMap::OcclusionRoughnessMetalness:
            return channel_bit(Channel::Occlusion) | channel_bit(Channel::Roughness) |
                   channel_bit(Channel::Metalness);
        case BakedMap::Normal:
            return channel_bit(Channel::Normal) | channel_bit(Channel::Height);
        case BakedMap::Emissive:
            return channel_bit(Channel::Emissive);
    }
    return 0;
}

bool composite_tiles(const TilesJob& job, const TileSink& sink, const Progress& progress) {
    const ChannelBits heights = has_relief(job) ? channel_bit(Channel::Height) : ChannelBits{0};
    AroundPass around(
        {.program = job.program,
         .images = job.images,
         .caches = job.caches,
         .wanted = static_cast<ChannelBits>(job.program->with_needed(job.wanted) | heights),
         .size = job.size,
         .rect = job.rect,
         .budget_bytes = job.around_bytes});
    const int rows = job.rect.y1 - job.rect.y0;
    std::atomic<int> rows_done = 0;
    for (int top = job.rect.y0; top < job.rect.y1; top += around.strip_rows()) {
        const int bottom = std::min(top + around.strip_rows(), job.rect.y1);
        around.move_to(top, bottom, progress);
        parallel_for(top, bottom, kRowsPerTask, [&](std::int64_t y0, std::int64_t y1) {
            if (progress.cancelled()) return;
            RowCompositor compositor(job, around.list(), sink);
            for (int y = static_cast<int>(y0); y < y1; ++y) compositor.composite_row(y);
            rows_done += static_cast<int>(y1 - y0);
            progress.report(static_cast<float>(rows_done) / static_cast<float>(rows));
        });
    }
    return !progress.cancelled();
}

bool composite_rect(const CompositeJob& job, const Progress& progress) {
    ChannelBits wanted = channels_of_targets(job);
    // Heights come from their own pass, with a halo; the planes are asked for where a cache is to
    // be filled.
    const bool stores = std::any_of(job.caches.begin(), job.caches.end(),
                                    [](const CachePoint& point) { return !point.read; });
    if (!stores) wanted &= static_cast<ChannelBits>(~channel_bit(Channel::Height));
    return composite_tiles(
        {.program = job.program,
         .images = job.images,
         .caches = job.caches,
         .wanted = wanted,
         .size = job.size,
         .rect = job.rect},
        [&](const TileSpan& span, TilePlanes& planes) {
            for (int map = 0; map < kBakedMapCount; ++map)
                write(job, static_cast<BakedMap>(map), span, planes);
        },
        progress);
}

}  // namespace patina
