// SPDX-License-Identifier: MIT
#include "composite/tile_tasks.h"

#include <algorithm>
#include <optional>

namespace patina {

TileTasks::TileTasks(const TileRun& run, TilePlanes& planes)
    : run_(run), program_(*run.program), planes_(planes) {
    if (run.observer) return;
    ready_.assign(program_.operations.size(), -1);
    const std::size_t end = std::min(ready_.size(), static_cast<std::size_t>(run.stop));
    for (auto i = static_cast<std::size_t>(run.start); i < end; ++i) {
        const Operation& operation = program_.operations[i];
        if (operation.code == OpCode::Blend)
            ready_[i] = got_ready(operation, blends_, &TileTasks::blend_task, blend_kernel);
        if (operation.code == OpCode::MaskEntry)
            ready_[i] = got_ready(operation, entries_, &TileTasks::mask_task, mask_kernel);
    }
}

/// Adds what is ready of an operation to `all` and returns where; -1 where nothing is.
template <class Task, class Kernel>
std::int32_t TileTasks::got_ready(const Operation& operation, std::vector<Ready<Task, Kernel>>& all,
                                  Task (TileTasks::*make)(const Operation&, const FetchedSource&,
                                                          int) const,
                                  Kernel (*kernel_of)(const Task&)) {
    const std::optional<FetchedSource> source = steady_source(
        source_of(operation), run_.images->sources[index_of(operation)], takes_stored(operation));
    if (!source) return -1;
    const Task task = (this->*make)(operation, *source, kTileTexels);
    all.push_back({task, kernel_of(task), source->stored});
    return static_cast<std::int32_t>(all.size()) - 1;
}

AcceptsStored TileTasks::takes_stored(const Operation& operation) const {
    if (operation.code == OpCode::MaskEntry)
        return
            [&](const StoredTexels& texels) { return mask_reads_stored(operation.mode, texels); };
    // Who observes looks for sources in planes, and one that replaces is read into them.
    if (run_.observer || (operation.flags & kFirst) != 0 || !is_opaque(operation)) return nullptr;
    return [&](const StoredTexels& texels) {
        return blends_stored(operation.channel, operation.mode, texels);
    };
}

/// The levels of a mask entry; null where they would change nothing. The identity holds to 0..1
/// what can lie beyond.
const Levels* TileTasks::levels_of(const Operation& operation) const {
    static constexpr Levels kIdentity;
    const SourceRecord& record = source_of(operation);
    if (record.levels >= 0) return &program_.levels[static_cast<std::size_t>(record.levels)];
    const auto* const source = std::get_if<ImageSource>(&record.source);
    if (source == nullptr) return &kIdentity;
    const bool within = run_.images->sources[index_of(operation)].image->type != SampleType::F32 &&
                        source->multiply == glm::vec3(1.0f) && source->add == glm::vec3(0.0f);
    return within ? nullptr : &kIdentity;
}

MaskTask TileTasks::mask_task(const Operation& operation, const FetchedSource& source,
                              int count) const {
    const bool adjusts = operation.code == OpCode::MaskAdjust;
    return {.mask = planes_.mask(operation.depth),
            .source = source.components[0],
            .stored = source.stored,
            .combine = operation.mode,
            .opacity = operation.amount,
            .first = (operation.flags & kFirst) != 0,
            .invert = (operation.flags & kInvert) != 0,
            .levels = adjusts ? nullptr : levels_of(operation),
            .last = (operation.flags & kLast) != 0,
            .invert_mask = (operation.flags & kInvertMask) != 0,
            .count = count};
}

/// The mask times the source's own coverage, but for a source that replaces.
ReadPlane TileTasks::weight_of(const Operation& operation, const FetchedSource& source,
                               int count) const {
    const bool masked = (operation.flags & kUsesMask) != 0;
    const ReadPlane mask =
        masked ? ReadPlane{.data = planes_.mask(operation.depth)} : uniform_one();
    const bool first = (operation.flags & kFirst) != 0;
    if (operation.mode == BlendMode::Replace && !first) return mask;
    if (!masked) return source.coverage;
    if (source.coverage.step == 0) return mask;
    multiply_tile(mask, source.coverage, planes_.weight(), count);
    return {.data = planes_.weight()};
}

BlendTask TileTasks::blend_task(const Operation& operation, const FetchedSource& source,
                                int count) const {
    BlendTask task{.channel = operation.channel,
                   .mode = operation.mode,
                   .first = (operation.flags & kFirst) != 0,
                   .count = count,
                   .stored = source.stored,
                   .weight = weight_of(operation, source, count),
                   .source_coverage = source.coverage,
                   .amount = operation.amount};
    for (int k = 0; k < component_count(operation.channel); ++k) {
        task.target[k] = planes_.channel(operation.depth, operation.channel, k);
        task.source[k] = source.components[k];
    }
    // An adjustment changes what is there, and covers no more than that.
    if (!is_opaque(operation) && operation.code != OpCode::Adjust)
        task.target_coverage = planes_.coverage(operation.depth, operation.channel);
    return task;
}

}  // namespace patina
