// SPDX-License-Identifier: MIT
#include "composite/around.h"

#include <algorithm>
#include <cassert>
#include <climits>
#include <cmath>
#include <cstring>

#include "composite/around_kernels.h"
#include "composite/blend_kernels.h"
#include "composite/tile_runner.h"
#include "core/formulae/formulae.h"
#include "core/parallel.h"

namespace patina {
namespace {

/// Kernels read and write whole runs of lanes, four at a time.
constexpr std::size_t kPadding = 64;
constexpr int kStripRowsPerTask = 8;
/// Of a strip: some tasks for each thread.
constexpr int kLeastStripRows = 128;

/// Columns from `begin` on, past the border where there are as many.
struct Range {
    int begin = 0;
    int length = 0;
};

Range grown(int first, int last, int by, int size) {
    if (last - first + 2 * by >= size) return {0, size};
    return {wrapped(first - by, size), last - first + 2 * by};
}

/// Calls visit(first, last) for the one or two parts of a range on this side of the border.
template <typename Visit>
void for_each_part(const Range& range, int size, const Visit& visit) {
    const int end = range.begin + range.length;
    visit(range.begin, std::min(end, size));
    if (end > size) visit(0, end - size);
}

bool blurs(const AdjustmentSettings& adjustment) {
    return adjustment.kind == AdjustmentKind::Blur || adjustment.kind == AdjustmentKind::Sharpen;
}

float texels(float permille, int size) {
    return permille * 0.001f * static_cast<float>(size);
}

/// Normalised, so that what is the same everywhere stays as it is.
std::vector<float> blur_weights(float radius, int reach) {
    std::vector<float> weights;
    float sum = 0.0f;
    for (int j = 0; j <= reach; ++j) {
        weights.push_back(formulae::blur_weight(static_cast<float>(j), radius));
        sum += j == 0 ? weights.back() : 2.0f * weights.back();
    }
    for (float& weight : weights) weight /= sum;
    return weights;
}

/// Of the channels of a layer: see AroundPlanes::blurred_planes_of.
int plane_count(const AroundRecord& record, ChannelBits channels) {
    int planes = 0;
    for (const ChannelInfo& entry : kChannels)
        if ((channels & channel_bit(entry.channel)) != 0)
            planes += component_count(entry.channel) + record.has_coverage() + record.relief;
    return planes;
}

std::size_t bytes_of_rows(const AroundRecord& record, ChannelBits channels, int rows, int size) {
    return static_cast<std::size_t>(plane_count(record, channels)) *
           static_cast<std::size_t>(rows) * static_cast<std::size_t>(size) * sizeof(float);
}

/// Fills the planes of one layer: first with what lies below it, then, for a blur, with the sums
/// along each row.
class Preparation {
  public:
    /// `wanted`: of the stack, or of the layer whose mask is kept.
    Preparation(const AroundJob& job, const AroundList& earlier, AroundPlanes& planes, int halo,
                ChannelBits wanted)
        : job_(job), planes_(planes) {
        const int size = job.size;
        columns_ = grown(job.rect.x0, job.rect.x1, halo, size);
        read_columns_ = grown(job.rect.x0, job.rect.x1, halo + planes.reach(), size);
        const AroundRecord& record = planes.record();
        run_ = {.program = job.program,
                .images = job.images,
                .wanted = job.program->with_needed(wanted),
                .around = &earlier,
                .start = record.start,
                .stop = record.begin};
        if (record.of_mask) return;
        for (const CachePoint& point : job.caches)
            if (point.read && point.place.end <= run_.stop) run_.caches.push_back(point);
    }

    void run(RowRange rows, const Progress& progress) {
        parallel_for(
            rows.begin, rows.end, kStripRowsPerTask, [&](std::int64_t first, std::int64_t last) {
                if (progress.cancelled()) return;
                TilePlanes tile(job_.program->depths);
                TileRunner runner(run_, tile);
                std::vector<float> line(static_cast<std::size_t>(job_.size + 2 * planes_.reach()) +
                                        kPadding);
                std::vector<float> sums(static_cast<std::size_t>(job_.size) + kPadding);
                for (auto i = static_cast<int>(first); i < static_cast<int>(last); ++i) {
                    const int y = wrapped(i, job_.size);
                    composite_row(y, runner, tile);
                    if (blurs(planes_.adjustment())) blur_row(y, line, sums);
                }
            });
    }

  private:
    void composite_row(int y, TileRunner& runner, TilePlanes& tile) {
        for_each_part(read_columns_, job_.size, [&](int first, int last) {
            for (int x = first; x < last; x += kTileTexels) {
                const TileSpan span{
                    .x = x, .y = y, .count = std::min(kTileTexels, last - x), .size = job_.size};
                runner.run(span);
                keep(span, tile);
            }
        });
    }

    void keep(const TileSpan& span, TilePlanes& tile) {
        const int depth = planes_.record().depth;
        const std::size_t bytes = static_cast<std::size_t>(span.count) * sizeof(float);
        if (planes_.record().of_mask) {
            float* const row = planes_.row(AroundRecord::kMaskChannel, 0, span.y);
            std::memcpy(row + span.x, tile.mask(depth), bytes);
            return;
        }
        for (const ChannelInfo& entry : kChannels) {
            const Channel channel = entry.channel;
            if ((planes_.channels() & channel_bit(channel)) == 0) continue;
            const int components = component_count(channel);
            for (int k = 0; k < components; ++k) {
                float* const value = tile.channel(depth, channel, k);
                if (depth > 0)
                    multiply_tile({.data = value}, {.data = tile.coverage(depth, channel)}, value,
                                  span.count);
                std::memcpy(planes_.row(channel, k, span.y) + span.x, value, bytes);
            }
            if (depth > 0)
                std::memcpy(planes_.row(channel, components, span.y) + span.x,
                            tile.coverage(depth, channel), bytes);
            if (planes_.record().relief)
                std::memcpy(
                    planes_.row(channel, planes_.blurred_planes_of(channel), span.y) + span.x,
                    tile.channel(depth, channel), bytes);
        }
    }

    void blur_row(int y, std::vector<float>& line, std::vector<float>& sums) {
        const int reach = planes_.reach();
        std::vector<const float*> lines;
        for (int j = 0; j <= 2 * reach; ++j) lines.push_back(line.data() + j);
        const BlurTask task{.weights = planes_.weights().data(),
                            .reach = reach,
                            .lines = lines.data(),
                            .count = columns_.length,
                            .sums = sums.data()};
        for (const ChannelInfo& entry : kChannels) {
            if ((planes_.channels() & channel_bit(entry.channel)) == 0) continue;
            for (int k = 0; k < planes_.blurred_planes_of(entry.channel); ++k) {
                float* const row = planes_.row(entry.channel, k, y);
                for (int i = 0; i < columns_.length + 2 * reach; ++i)
                    line[static_cast<std::size_t>(i)] =
                        row[wrapped(columns_.begin - reach + i, job_.size)];
                blur_tile(task);
                const float* from = sums.data();
                for_each_part(columns_, job_.size, [&](int first, int last) {
                    const auto count = static_cast<std::size_t>(last - first);
                    std::memcpy(row + first, from, count * sizeof(float));
                    from += count;
                });
            }
        }
    }

    const AroundJob& job_;
    AroundPlanes& planes_;
    TileRun run_;
    Range columns_;
    Range read_columns_;
};

/// Whether a cache goes on from beyond all that reads it.
bool is_skipped(const AroundRecord& record, const std::vector<CachePoint>& caches) {
    return std::any_of(caches.begin(), caches.end(), [&](const CachePoint& point) {
        return point.read && point.place.begin <= record.begin && record.last < point.place.end;
    });
}

}  // namespace

int reach_of(const AdjustmentSettings& adjustment, int size) {
    if (blurs(adjustment)) return static_cast<int>(texels(adjustment.radius_permille, size));
    // One more for the texel beyond, to which the one is mixed.
    if (adjustment.kind == AdjustmentKind::Warp)
        return static_cast<int>(std::ceil(texels(adjustment.distance_permille, size))) + 1;
    return 0;
}

int reach_of(const ProgramData& program, int size) {
    int reach = 0;
    for (const AroundRecord& record : program.around)
        reach += reach_of(program.adjustments[static_cast<std::size_t>(record.adjustment)], size);
    return reach;
}

AroundPlanes::AroundPlanes(const AroundRecord& record, const AdjustmentSettings& adjustment,
                           ChannelBits channels, int size, int capacity)
    : record_(record),
      adjustment_(adjustment),
      channels_(channels),
      size_(size),
      reach_(std::min(reach_of(adjustment, size), size)),
      capacity_(std::min(capacity, size)) {
    if (blurs(adjustment))
        weights_ = blur_weights(texels(adjustment.radius_permille, size), reach_);
    memory_.resize(bytes_of_rows(record, channels, capacity_, size) / sizeof(float) + kPadding);
}

int AroundPlanes::first_plane(Channel channel) const {
    const auto before = static_cast<ChannelBits>(channel_bit(channel) - 1);
    return plane_count(record_, static_cast<ChannelBits>(channels_ & before));
}

RowRange AroundPlanes::keep_rows(RowRange rows) {
    const bool all = capacity_ == size_;
    if (all) rows = {0, size_};
    assert(rows.length() <= capacity_ && (kept_.length() == 0 || rows.begin >= kept_.begin));
    const RowRange fresh = {kept_.length() == 0 ? rows.begin : std::max(rows.begin, kept_.end),
                            rows.end};
    kept_ = rows;
    return fresh;
}

/// Rows lie in a ring: each where the one lay that left as it came.
std::size_t AroundPlanes::row_start(int plane, int y) const {
    const int row = kept_.begin + wrapped(y - kept_.begin, size_);
    return (static_cast<std::size_t>(plane) * static_cast<std::size_t>(capacity_) +
            static_cast<std::size_t>(wrapped(row, capacity_))) *
           static_cast<std::size_t>(size_);
}

/// The rows of one layer, how many of them lie beyond a strip on either side, and what fills them.
struct AroundPass::Step {
    AroundPlanes& planes;
    int rows_beyond;
    Preparation preparation;
};

namespace {

/// For each layer that looks around how far beyond the texels asked for its result is read: by the
/// relief of the heights, which looks one texel around, and by the layers further up that look
/// around themselves.
std::vector<int> halos_of(const ProgramData& program, int size) {
    std::vector<int> halos(program.around.size(), 1);
    for (std::size_t i = halos.size(); i-- > 0;)
        for (std::size_t above = i + 1; above < halos.size(); ++above) {
            const AroundRecord& record = program.around[above];
            if (program.around[i].begin >= record.begin) continue;
            const int reach =
                reach_of(program.adjustments[static_cast<std::size_t>(record.adjustment)], size);
            halos[i] = std::max(halos[i], halos[above] + reach);
        }
    return halos;
}

/// A layer that looks around and is wanted.
struct Reader {
    std::size_t around = 0;    ///< index into ProgramData::around
    ChannelBits channels = 0;  ///< that are kept
    ChannelBits runs_for = 0;  ///< by which the run is to go
    int halo = 0;              ///< how far beyond what is asked for its result is read
    int reach = 0;             ///< and how far beyond that it reads
    int beyond() const { return halo + reach; }
};

std::vector<Reader> readers_of(const AroundJob& job) {
    const ProgramData& program = *job.program;
    const ChannelBits wanted = program.with_needed(job.wanted);
    const std::vector<int> halos = halos_of(program, job.size);
    std::vector<Reader> readers;
    for (std::size_t i = 0; i < program.around.size(); ++i) {
        const AroundRecord& record = program.around[i];
        const bool referred = record.referring != 0;
        const auto of_stack =
            static_cast<ChannelBits>((referred ? record.referring : record.channels) & wanted);
        if (of_stack == 0 || is_skipped(record, job.caches)) continue;
        const ChannelBits kept = referred ? record.channels : of_stack;
        readers.push_back(
            {.around = i,
             .channels = record.of_mask ? channel_bit(AroundRecord::kMaskChannel) : kept,
             .runs_for = record.of_mask ? record.channels : of_stack,
             .halo = halos[i],
             .reach = reach_of(program.adjustments[static_cast<std::size_t>(record.adjustment)],
                               job.size)});
    }
    return readers;
}

int rows_of_strip(const AroundJob& job, const std::vector<Reader>& readers) {
    const int rows = job.rect.y1 - job.rect.y0;
    std::size_t row_bytes = 0, beyond_bytes = 0;
    for (const Reader& reader : readers) {
        const AroundRecord& record = job.program->around[reader.around];
        row_bytes += bytes_of_rows(record, reader.channels, 1, job.size);
        beyond_bytes += bytes_of_rows(record, reader.channels, 2 * reader.beyond(), job.size);
    }
    if (row_bytes == 0) return rows;
    const std::size_t left = job.budget_bytes - std::min(beyond_bytes, job.budget_bytes);
    const auto fitting = static_cast<int>(std::min<std::size_t>(left / row_bytes, INT_MAX));
    return std::clamp(fitting, std::min(kLeastStripRows, rows), rows);
}

}  // namespace

AroundPass::AroundPass(AroundJob job) : job_(std::move(job)), list_(job_.program->around.size()) {
    const ProgramData& program = *job_.program;
    const std::vector<Reader> readers = readers_of(job_);
    strip_rows_ = rows_of_strip(job_, readers);
    for (const Reader& reader : readers) {
        const AroundRecord& record = program.around[reader.around];
        auto planes = std::make_shared<AroundPlanes>(
            record, program.adjustments[static_cast<std::size_t>(record.adjustment)],
            reader.channels, job_.size, strip_rows_ + 2 * reader.beyond());
        steps_.push_back({*planes, reader.beyond(),
                          Preparation(job_, list_, *planes, reader.halo, reader.runs_for)});
        list_[reader.around] = std::move(planes);
    }
}

AroundPass::~AroundPass() = default;

void AroundPass::move_to(int y0, int y1, const Progress& progress) {
    assert(y1 - y0 <= strip_rows_);
    for (Step& step : steps_) {
        if (progress.cancelled()) return;
        const RowRange rows = {y0 - step.rows_beyond, y1 + step.rows_beyond};
        step.preparation.run(step.planes.keep_rows(rows), progress);
    }
}

std::size_t AroundPass::size_bytes() const {
    std::size_t bytes = 0;
    for (const Step& step : steps_) bytes += step.planes.size_bytes();
    return bytes;
}

namespace {

/// The rows of a component that the reach of a tile's own covers, each from column 0 on.
std::vector<const float*> rows_around(const AroundTask& task, int component) {
    const AroundPlanes& planes = *task.planes;
    std::vector<const float*> rows;
    for (int j = -planes.reach(); j <= planes.reach(); ++j)
        rows.push_back(
            planes.row(task.channel, component, wrapped(task.span.y + j, planes.size())));
    return rows;
}

void blur_component(const AroundTask& task, int component, float* to) {
    std::vector<const float*> lines = rows_around(task, component);
    for (const float*& line : lines) line += task.span.x;
    blur_tile({.weights = task.planes->weights().data(),
               .reach = task.planes->reach(),
               .lines = lines.data(),
               .count = task.span.count,
               .sums = to});
}

/// Reads a plane where a warp takes the texels of a tile from, between four texels.
class WarpedReader {
  public:
    explicit WarpedReader(const AroundTask& task) : task_(task) {
        const AdjustmentSettings& adjustment = task.planes->adjustment();
        warp_tile({.x = task.span.x,
                   .y = task.span.y,
                   .count = task.span.count,
                   .size = static_cast<float>(task.span.size),
                   .distance_texels = texels(adjustment.distance_permille, task.span.size),
                   .cells = std::max(static_cast<int>(std::round(adjustment.scale)), 1),
                   .octaves = adjustment.octaves,
                   .seed = adjustment.seed,
                   .right = right_,
                   .down = down_});
    }

    void read(int component, float* to) const {
        const int size = task_.span.size;
        const std::vector<const float*> rows = rows_around(task_, component);
        for (int i = 0; i < task_.span.count; ++i) {
            const float whole_x = std::floor(right_[i]), whole_y = std::floor(down_[i]);
            const float part_x = right_[i] - whole_x, part_y = down_[i] - whole_y;
            const int x0 = wrapped(task_.span.x + i + static_cast<int>(whole_x), size);
            const int x1 = x0 + 1 == size ? 0 : x0 + 1;
            const int down = task_.planes->reach() + static_cast<int>(whole_y);
            const auto row = static_cast<std::size_t>(down);
            const float* const above = rows[row];
            const float* const below = rows[row + 1];
            to[i] = formulae::mix(formulae::mix(above[x0], above[x1], part_x),
                                  formulae::mix(below[x0], below[x1], part_x), part_y);
        }
    }

  private:
    const AroundTask& task_;
    alignas(64) float right_[kTileTexels];
    alignas(64) float down_[kTileTexels];
};

}  // namespace

void adjust_around(const AroundTask& task) {
    const AroundPlanes& planes = *task.planes;
    const int components = component_count(task.channel);
    const int count = task.span.count;
    const bool in_group = planes.record().has_coverage();
    alignas(64) float coverage[kTileTexels];
    if (planes.adjustment().kind == AdjustmentKind::Warp) {
        const WarpedReader warped(task);
        for (int k = 0; k < components; ++k) warped.read(k, task.to[k]);
        if (in_group) warped.read(components, coverage);
    } else {
        for (int k = 0; k < components; ++k) blur_component(task, k, task.to[k]);
        if (in_group) blur_component(task, components, coverage);
    }
    const ChannelKind kind = info(task.channel).kind;
    for (int k = 0; k < components; ++k) {
        if (in_group) divide_by_coverage_tile(task.to[k], coverage, task.own[k], count);
        if (planes.adjustment().kind == AdjustmentKind::Sharpen)
            sharpen_tile(task.to[k], task.own[k], planes.adjustment().amount,
                         kind == ChannelKind::Color || kind == ChannelKind::Scalar, count);
    }
    if (kind == ChannelKind::Normal) normalise_tile(task.to, count);
}

void fetch_relief(const AroundPlanes& planes, const ReliefSource& source, const TileSpan& span,
                  float* to) {
    blur_component({.planes = &planes, .channel = Channel::Height, .span = span}, 0, to);
    const int own = planes.blurred_planes_of(Channel::Height);
    relief_tile(static_cast<int>(source.kind), planes.row(Channel::Height, own, span.y) + span.x,
                source.strength, to, span.count);
}

}  // namespace patina
