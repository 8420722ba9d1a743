// SPDX-License-Identifier: MIT
#include "composite/tile_runner.h"

#include <algorithm>
#include <utility>

#include "composite/adjust_kernels.h"
#include "composite/fetch_kernels.h"
#include "composite/tile_tasks.h"

namespace patina {
namespace {

/// Whether an operation has to do with the accumulator of one of its channels at its own depth.
bool reads_or_writes(const Operation& operation, ChannelBits channel) {
    switch (operation.code) {
        case OpCode::ToEncoded:
        case OpCode::ToLinear:
        case OpCode::Blend:
        case OpCode::Adjust:
        case OpCode::BlendGroup:
            return channel_bit(operation.channel) == channel;
        case OpCode::GroupCopy:
            return true;
        case OpCode::MaskBegin:
        case OpCode::MaskEntry:
        case OpCode::MaskAdjust:
        case OpCode::MaskHeight:
        case OpCode::MaskKeep:
        case OpCode::MaskClip:
        case OpCode::GroupBegin:
        case OpCode::Reference:
            return false;
    }
    return true;
}

}  // namespace

class TileRunner::Runner {
  public:
    Runner(const TileRun& run, TilePlanes& planes)
        : run_(run),
          program_(*run.program),
          planes_(planes),
          tasks_(run, planes),
          end_(std::min(program_.operations.size(), static_cast<std::size_t>(run.stop))),
          wanted_(run.wanted) {
        plan_bottom();
    }

    void run(const TileSpan& span);

  private:
    void plan_bottom();
    const Operation* first_at_bottom(ChannelBits channel) const;
    void fill_bottom(ChannelBits channels, int count);
    void run_until(std::size_t next, std::size_t end);
    std::size_t skipped(const Operation& operation, std::size_t next) const;
    std::size_t refer(const Operation& operation, std::size_t next);
    std::size_t resumed(std::size_t next);
    void store_caches(std::size_t next);
    bool may_jump(const Operation& operation, std::size_t next) const;
    std::size_t step(const Operation& operation, std::size_t next);
    void join_mask(const Operation& operation, std::size_t index);
    TileBlocks join_fetched(const Operation& operation);
    FetchedSource mask_entry(const Operation& operation);
    FetchedSource adjusted_mask(const Operation& operation);
    void share_by_height(const Operation& operation);
    ReadPlane height_coverage(int depth);
    void clear(int depth, ChannelBits channels);
    void copy_group(const Operation& operation);
    FetchedSource adjusted(const Operation& operation);
    void run_or_look_around(const Operation& operation, const AdjustTask& task);
    void recode(const Operation& operation);
    FetchedSource blend_source(const Operation& operation);
    FetchedSource child_source(const Operation& operation);
    TileBlocks blocks_of(const Operation& operation);
    void blend_fetched(const Operation& operation, std::size_t index);
    void blend(const Operation& operation, const FetchedSource& source);
    FetchTarget scratch() { return {planes_.source(0), planes_.source(1), planes_.source(2)}; }
    /// @param target   planes that may be overwritten
    /// @param accepts  texels that may be given as they are stored
    FetchedSource fetch(const Operation& operation, const FetchTarget& target,
                        const AcceptsStored& accepts = nullptr) {
        return fetch(operation.source, operation.depth, target, accepts);
    }
    FetchedSource fetch(std::int32_t source, int depth, const FetchTarget& target,
                        const AcceptsStored& accepts = nullptr);
    FetchedSource fetch_relief(const SourceRecord& record, float* to);
    FetchedSource fetch_reference(const SourceRecord& record, int depth, const FetchTarget& target);

    const TileRun& run_;
    const ProgramData& program_;
    TilePlanes& planes_;
    TileTasks tasks_;
    const std::size_t end_;  ///< of the whole run
    ChannelBits wanted_;     ///< here: within a reference what that one needs
    TileSpan span_ = {};
    ChannelBits bottom_ = 0;     ///< filled in every tile
    ChannelBits unchanged_ = 0;  ///< not filled yet, and the same in every tile
};

void TileRunner::Runner::run(const TileSpan& span) {
    span_ = span;
    if (run_.start == 0) {
        fill_bottom(bottom_, span_.count);
        fill_bottom(std::exchange(unchanged_, ChannelBits{0}), kTileTexels);
    }
    run_until(static_cast<std::size_t>(run_.start), end_);
}

void TileRunner::Runner::run_until(std::size_t next, std::size_t end) {
    for (next = resumed(next); next < end;) {
        const Operation& operation = program_.operations[next];
        const std::size_t past = skipped(operation, next);
        next = past > next ? past : step(operation, next);
        store_caches(next);
        next = resumed(next);
    }
}

/// Where to go on from an operation that is not wanted; `next` from one that is. A reference in
/// which the run is to stop is wanted.
std::size_t TileRunner::Runner::skipped(const Operation& operation, std::size_t next) const {
    if ((operation.channels & wanted_) != 0) return next;
    if (operation.code != OpCode::Reference) return next + 1;
    const auto past = static_cast<std::size_t>(operation.jump);
    return end_ < past ? next : past;
}

/// Runs the operations of a layer that is referred to.
std::size_t TileRunner::Runner::refer(const Operation& operation, std::size_t next) {
    const ReferenceRecord& record = program_.references[static_cast<std::size_t>(operation.source)];
    const ChannelBits outer = std::exchange(wanted_, record.needed);
    clear(operation.depth + 1, record.needed);
    const auto past = static_cast<std::size_t>(operation.jump);
    run_until(next + 1, std::min(past, end_));
    wanted_ = outer;
    return past;
}

/// Decides which channels of the bottom of the stack are filled, and when.
void TileRunner::Runner::plan_bottom() {
    bottom_ = run_.wanted;
    for (const CachePoint& point : run_.caches)
        if (point.read && point.place.begin == 0 && point.place.depth == 0)
            bottom_ &= static_cast<ChannelBits>(~point.cache->channels());
    for (const ChannelInfo& entry : kChannels) {
        // Others than the operations of this run read and write these.
        if (entry.channel == Channel::Height || entry.channel == Channel::Normal) continue;
        const ChannelBits bit = channel_bit(entry.channel) & bottom_;
        const Operation* const first = first_at_bottom(bit);
        const bool stays = first == nullptr;
        const bool covered = !stays && first->code == OpCode::Blend && (first->flags & kFirst) != 0;
        if (stays) unchanged_ |= bit;
        if (stays || covered) bottom_ &= static_cast<ChannelBits>(~bit);
    }
}

/// The first operation that has to do with a channel of depth 0.
const Operation* TileRunner::Runner::first_at_bottom(ChannelBits channel) const {
    const auto begin = program_.operations.begin();
    const auto found = std::find_if(begin + run_.start, begin + static_cast<std::ptrdiff_t>(end_),
                                    [&](const Operation& operation) {
                                        return operation.depth == 0 &&
                                               (operation.channels & channel) != 0 &&
                                               reads_or_writes(operation, channel);
                                    });
    return found == begin + static_cast<std::ptrdiff_t>(end_) ? nullptr : &*found;
}

void TileRunner::Runner::fill_bottom(ChannelBits channels, int count) {
    for (const ChannelInfo& entry : kChannels) {
        if ((channels & channel_bit(entry.channel)) == 0) continue;
        const glm::vec3& bottom = at(program_.bottom, entry.channel);
        for (int k = 0; k < component_count(entry.channel); ++k)
            fill_tile(planes_.channel(0, entry.channel, k), bottom[k], count);
    }
}

/// Where to go on from `next`: past a stack's layers where a cache holds what they accumulate.
std::size_t TileRunner::Runner::resumed(std::size_t next) {
    for (const CachePoint& point : run_.caches) {
        if (!point.read || point.place.begin != static_cast<std::int32_t>(next)) continue;
        point.cache->load(span_, wanted_, planes_);
        return static_cast<std::size_t>(point.place.end);
    }
    return next;
}

void TileRunner::Runner::store_caches(std::size_t next) {
    for (const CachePoint& point : run_.caches)
        if (!point.read && point.place.end == static_cast<std::int32_t>(next))
            point.cache->store(span_, planes_);
}

/// Whether nothing between here and the target of the jump is to be stored or asked for.
bool TileRunner::Runner::may_jump(const Operation& operation, std::size_t next) const {
    if (operation.jump > run_.stop) return false;
    for (const CachePoint& point : run_.caches)
        if (!point.read && point.place.end > static_cast<std::int32_t>(next) &&
            point.place.end < operation.jump)
            return false;
    return true;
}

std::size_t TileRunner::Runner::step(const Operation& operation, std::size_t next) {
    switch (operation.code) {
        case OpCode::MaskBegin:
            fill_tile(planes_.mask(operation.depth), operation.amount, span_.count);
            planes_.masked_blocks(operation.depth) = all_blocks(span_.count);
            break;
        case OpCode::MaskEntry:
        case OpCode::MaskAdjust:
            join_mask(operation, next);
            if ((operation.flags & kLast) != 0 && planes_.masked_blocks(operation.depth) == 0 &&
                !run_.observer && may_jump(operation, next))
                return static_cast<std::size_t>(operation.jump);
            break;
        case OpCode::MaskKeep:
            copy_tile(planes_.mask(operation.depth), planes_.kept_mask(operation.depth),
                      span_.count);
            break;
        case OpCode::MaskClip: {
            float* const mask = planes_.mask(operation.depth);
            multiply_tile({.data = mask}, {.data = planes_.kept_mask(operation.depth)}, mask,
                          span_.count);
            break;
        }
        case OpCode::MaskHeight:
            share_by_height(operation);
            break;
        case OpCode::ToEncoded:
        case OpCode::ToLinear:
            recode(operation);
            break;
        case OpCode::Blend:
            blend_fetched(operation, next);
            break;
        case OpCode::Adjust:
            blend(operation, adjusted(operation));
            break;
        case OpCode::GroupBegin:
            clear(operation.depth + 1, operation.channels & wanted_);
            break;
        case OpCode::GroupCopy:
            copy_group(operation);
            break;
        case OpCode::BlendGroup:
            blend(operation, child_source(operation));
            break;
        case OpCode::Reference:
            return refer(operation, next);
    }
    return next + 1;
}

/// What the source of an entry gives (read where the mask is to lie, if nothing lies below), times
/// what it covers where it is another layer.
FetchedSource TileRunner::Runner::mask_entry(const Operation& operation) {
    const bool first = (operation.flags & kFirst) != 0;
    float* const own = first ? planes_.mask(operation.depth) : planes_.source(0);
    FetchedSource source = fetch(operation, {own, planes_.source(1), planes_.source(2)},
                                 tasks_.takes_stored(operation));
    if (tasks_.source_of(operation).reference < 0 || source.coverage.step == 0) return source;
    multiply_tile(source.components[0], source.coverage, planes_.source(1), span_.count);
    source.components[0] = {.data = planes_.source(1)};
    return source;
}

FetchedSource TileRunner::Runner::adjusted_mask(const Operation& operation) {
    const AdjustTask task{
        .adjustment = &program_.adjustments[static_cast<std::size_t>(operation.source)],
        .channel = AroundRecord::kMaskChannel,
        .count = span_.count,
        .from = {planes_.mask(operation.depth)},
        .to = {planes_.source(0)}};
    run_or_look_around(operation, task);
    return {{{.data = task.to[0]}, {}, {}}, uniform_one()};
}

TileBlocks TileRunner::Runner::join_fetched(const Operation& operation) {
    const bool adjusts = operation.code == OpCode::MaskAdjust;
    MaskTask task = tasks_.mask_task(
        operation, adjusts ? adjusted_mask(operation) : mask_entry(operation), span_.count);
    task.blocks = planes_.masked_blocks(operation.depth);
    return join_mask_tile(task);
}

void TileRunner::Runner::join_mask(const Operation& operation, std::size_t index) {
    TileBlocks& blocks = planes_.masked_blocks(operation.depth);
    if (TileTasks::Entry* const ready = tasks_.ready_entry(index)) {
        MaskTask& task = ready->at(span_);
        task.blocks = blocks;
        blocks = ready->kernel(task);
    } else {
        blocks = join_fetched(operation);
    }
}

/// What the height channel covers at a depth; the stack itself is opaque.
ReadPlane TileRunner::Runner::height_coverage(int depth) {
    return depth == 0 ? uniform_one() : ReadPlane{.data = planes_.coverage(depth, Channel::Height)};
}

void TileRunner::Runner::share_by_height(const Operation& operation) {
    static const UniformPlane surface(0.0f);
    const HeightBlendRecord& record =
        program_.height_blends[static_cast<std::size_t>(operation.source)];
    const int depth = operation.depth;
    HeightShareTask task{.mask = planes_.mask(depth),
                         .below = {.data = planes_.channel(record.below, Channel::Height)},
                         .below_coverage = height_coverage(record.below),
                         .own = surface.plane(),
                         .own_coverage = uniform_one(),
                         .blend = record.blend,
                         .count = span_.count};
    if (record.of_children) {
        task.own = {.data = planes_.channel(depth + 1, Channel::Height)};
        task.own_coverage = height_coverage(depth + 1);
    } else if (record.source >= 0) {
        const FetchedSource source = fetch(record.source, depth, scratch());
        task.own = source.components[0];
        task.own_coverage = source.coverage;
    }
    share_by_height_tile(task);
}

void TileRunner::Runner::clear(int depth, ChannelBits channels) {
    for (const ChannelInfo& entry : kChannels) {
        if ((channels & channel_bit(entry.channel)) == 0) continue;
        const glm::vec3 bottom = stack_bottom(entry.channel);
        for (int k = 0; k < component_count(entry.channel); ++k)
            fill_tile(planes_.channel(depth, entry.channel, k), bottom[k], span_.count);
        fill_tile(planes_.coverage(depth, entry.channel), 0.0f, span_.count);
    }
}

/// The next depth starts from what is accumulated here; the stack itself is opaque.
void TileRunner::Runner::copy_group(const Operation& operation) {
    const int depth = operation.depth;
    for (const ChannelInfo& entry : kChannels) {
        const Channel channel = entry.channel;
        if ((operation.channels & wanted_ & channel_bit(channel)) == 0) continue;
        for (int k = 0; k < component_count(channel); ++k)
            copy_tile(planes_.channel(depth, channel, k), planes_.channel(depth + 1, channel, k),
                      span_.count);
        float* const coverage = planes_.coverage(depth + 1, channel);
        if (depth == 0)
            fill_tile(coverage, 1.0f, span_.count);
        else
            copy_tile(planes_.coverage(depth, channel), coverage, span_.count);
    }
}

/// `depth`: of the operation that reads the source.
FetchedSource TileRunner::Runner::fetch(std::int32_t source, int depth, const FetchTarget& target,
                                        const AcceptsStored& accepts) {
    const auto index = static_cast<std::size_t>(source);
    const SourceRecord& record = program_.sources[index];
    if (record.around >= 0) return fetch_relief(record, target[0]);
    if (record.reference >= 0) return fetch_reference(record, depth + 1, target);
    const bool chosen = record.choice >= 0;
    return fetch_source(
        {.record = &record,
         .image = &run_.images->sources[index],
         .texels = {program_.surface.get(), run_.images->surface_map.get()},
         .chosen_parts =
             chosen ? &program_.chosen_parts[static_cast<std::size_t>(record.choice)] : nullptr,
         .accepts = accepts},
        span_, target, planes_);
}

FetchedSource TileRunner::Runner::fetch_relief(const SourceRecord& record, float* to) {
    patina::fetch_relief(*(*run_.around)[static_cast<std::size_t>(record.around)],
                         std::get<ReliefSource>(record.source), span_, to);
    return {{{.data = to}, {}, {}}, uniform_one()};
}

/// What a layer that is referred to left at `depth`, as the source is read.
FetchedSource TileRunner::Runner::fetch_reference(const SourceRecord& record, int depth,
                                                  const FetchTarget& target) {
    const ReferenceRecord& reference =
        program_.references[static_cast<std::size_t>(record.reference)];
    const Channel channel = reference.channel;
    const ReadPlane covered{.data = planes_.coverage(depth, channel)};
    FetchedSource source{.coverage = reference.of_mask ? uniform_one() : covered};
    if (!reference.of_mask && component_count(channel) == 3) {
        for (int k = 0; k < 3; ++k) source.components[k] = {planes_.channel(depth, channel, k)};
        if (is_vector(record.reading)) return source;
        for (int k = 0; k < 3; ++k) copy_tile(source.components[k].data, target[k], span_.count);
        adjust_tile({.luminance = true}, 3, target.data(), span_.count);
        return {{{.data = target[0]}, {}, {}}, source.coverage};
    }
    ReadPlane value = reference.of_mask ? covered : ReadPlane{planes_.channel(depth, channel)};
    const bool hold = channel == Channel::Height && record.reading != Reading::Height;
    const bool encode = record.reading == Reading::EncodedColor;
    if (hold || encode) {
        copy_tile(value.data, target[0], span_.count);
        adjust_tile({.hold = hold, .encode = encode}, 1, target.data(), span_.count);
        value = {.data = target[0]};
    }
    for (ReadPlane& component : source.components) component = value;
    return source;
}

/// What the adjustment makes of the accumulator.
FetchedSource TileRunner::Runner::adjusted(const Operation& operation) {
    AdjustTask task{.adjustment = &program_.adjustments[static_cast<std::size_t>(operation.source)],
                    .channel = operation.channel,
                    .encoded = (operation.flags & kEncoded) != 0,
                    .count = span_.count};
    FetchedSource source;
    for (int k = 0; k < component_count(operation.channel); ++k) {
        task.from[k] = planes_.channel(operation.depth, operation.channel, k);
        task.to[k] = planes_.source(k);
        source.components[k] = {.data = task.to[k]};
    }
    source.coverage = uniform_one();
    run_or_look_around(operation, task);
    return source;
}

void TileRunner::Runner::run_or_look_around(const Operation& operation, const AdjustTask& task) {
    if (operation.around < 0) return run_adjustment(task);
    const auto index = static_cast<std::size_t>(operation.around);
    const AroundPlanes* const planes =
        run_.around != nullptr ? (*run_.around)[index].get() : nullptr;
    if (planes == nullptr) {
        for (int k = 0; k < component_count(task.channel); ++k)
            copy_tile(task.from[k], task.to[k], task.count);
        return;
    }
    AroundTask around{.planes = planes, .channel = task.channel, .span = span_};
    for (int k = 0; k < component_count(task.channel); ++k) {
        around.own[k] = task.from[k];
        around.to[k] = task.to[k];
    }
    adjust_around(around);
}

void TileRunner::Runner::recode(const Operation& operation) {
    float* const color[3] = {planes_.channel(operation.depth, operation.channel, 0),
                             planes_.channel(operation.depth, operation.channel, 1),
                             planes_.channel(operation.depth, operation.channel, 2)};
    operation.code == OpCode::ToEncoded ? encode_tile(color, span_.count)
                                        : decode_tile(color, span_.count);
}

/// The source of a blend: read where it is to lie if it replaces the accumulator, and as it is
/// stored where the blend reads it so.
FetchedSource TileRunner::Runner::blend_source(const Operation& operation) {
    FetchTarget target = scratch();
    if ((operation.flags & kFirst) != 0 && !run_.observer)
        for (int k = 0; k < component_count(operation.channel); ++k)
            target[static_cast<std::size_t>(k)] =
                planes_.channel(operation.depth, operation.channel, k);
    return fetch(operation, target, tasks_.takes_stored(operation));
}

/// The accumulators of the group's children, in the blend space of the group.
FetchedSource TileRunner::Runner::child_source(const Operation& operation) {
    const int depth = operation.depth + 1;
    FetchedSource source;
    float* planes[3] = {};
    for (int k = 0; k < component_count(operation.channel); ++k) {
        planes[k] = planes_.channel(depth, operation.channel, k);
        source.components[k] = {.data = planes[k]};
    }
    source.coverage = {.data = planes_.coverage(depth, operation.channel)};
    const bool encoded = (operation.flags & kEncoded) != 0;
    if (is_color(operation.channel) && ((operation.flags & kChildEncoded) != 0) != encoded)
        encoded ? encode_tile(planes, span_.count) : decode_tile(planes, span_.count);
    return source;
}

/// The blocks in which a blend may change something.
TileBlocks TileRunner::Runner::blocks_of(const Operation& operation) {
    const bool masked = (operation.flags & kUsesMask) != 0;
    return masked ? planes_.masked_blocks(operation.depth) : all_blocks(span_.count);
}

void TileRunner::Runner::blend_fetched(const Operation& operation, std::size_t index) {
    TileTasks::Blend* const ready = tasks_.ready_blend(index);
    if (ready == nullptr) return blend(operation, blend_source(operation));
    BlendTask& task = ready->at(span_);
    task.blocks = blocks_of(operation);
    ready->kernel(task);
}

void TileRunner::Runner::blend(const Operation& operation, const FetchedSource& source) {
    BlendTask task = tasks_.blend_task(operation, source, span_.count);
    task.blocks = blocks_of(operation);
    blend_tile(task);
    if (run_.observer && (operation.flags & kReferred) == 0) {
        const bool masked = (operation.flags & kUsesMask) != 0;
        run_.observer(operation, source, task.weight.data[0] * task.amount,
                      masked ? planes_.mask(operation.depth)[0] : 1.0f, planes_);
    }
}

TileRunner::TileRunner(const TileRun& run, TilePlanes& planes)
    : runner_(std::make_unique<Runner>(run, planes)) {}
TileRunner::~TileRunner() = default;
TileRunner::TileRunner(TileRunner&&) noexcept = default;
TileRunner& TileRunner::operator=(TileRunner&&) noexcept = default;

void TileRunner::run(const TileSpan& span) {
    runner_->run(span);
}

}  // namespace patina
