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
        const OpCode code = program_.operations[i].code;
        if (code == OpCode::Blend) get_blend_ready(i);
        if (code == OpCode::MaskEntry) get_entry_ready(i);
    }
}

void TileTasks::get_blend_ready(std::size_t index) {
    const Operation& operation = program_.operations[index];
    const bool first = (operation.flags & kFirst) != 0;
    const auto accepts = [&](const StoredTexels& texels) {
        return !first && is_opaque(operation) &&
               blends_stored(operation.channel, operation.mode, texels);
    };
    const std::optional<FetchedSource> source =
        steady_source(source_of(operation), bound_of(operation), accepts);
    if (!source) return;
    const bool masked = (operation.flags & kUsesMask) != 0;
    const BlendTask task =
        blend_task(operation, *source,
                   masked ? ReadPlane{.data = planes_.mask(operation.depth)} : source->coverage);
    ready_[index] = static_cast<std::int32_t>(blends_.size());
    blends_.push_back({task, blend_kernel(task), source->stored});
}

void TileTasks::get_entry_ready(std::size_t index) {
    const Operation& operation = program_.operations[index];
    const auto accepts = [&](const StoredTexels& texels) {
        return mask_reads_stored(operation.mode, texels);
    };
    const std::optional<FetchedSource> source =
        steady_source(source_of(operation), bound_of(operation), accepts);
    if (!source) return;
    const MaskTask task = mask_task(operation, *source);
    ready_[index] = static_cast<std::int32_t>(entries_.size());
    entries_.push_back({task, mask_kernel(task), source->stored});
}

/// The levels of a mask entry; null where they would change nothing. The identity holds to 0..1
/// what can lie beyond.
const Levels* TileTasks::levels_of(const Operation& operation) const {
    static constexpr Levels kIdentity;
    const SourceRecord& record = source_of(operation);
    if (record.levels >= 0) return &program_.levels[static_cast<std::size_t>(record.levels)];
    const auto* const source = std::get_if<ImageSource>(&record.source);
    if (source == nullptr) return &kIdentity;
    const bool within = bound_of(operation).image->type != SampleType::F32 &&
                        source->multiply == glm::vec3(1.0f) && source->add == glm::vec3(0.0f);
    return within ? nullptr : &kIdentity;
}

MaskTask TileTasks::mask_task(const Operation& operation, const FetchedSource& source) const {
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
            .invert_mask = (operation.flags & kInvertMask) != 0};
}

BlendTask TileTasks::blend_task(const Operation& operation, const FetchedSource& source,
                                const ReadPlane& weight) const {
    BlendTask task{.channel = operation.channel,
                   .mode = operation.mode,
                   .first = (operation.flags & kFirst) != 0,
                   .stored = source.stored,
                   .weight = weight,
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
