// SPDX-License-Identifier: MIT
#pragma once

/// What kernels are given for the operations of a program. Most tasks are the same in every tile,
/// but for where their texels lie and how many there are: those are worked out once.

#include <cstdint>
#include <vector>

#include "composite/mask_kernels.h"
#include "composite/tile_runner.h"

namespace patina {

/// Whether what an operation lays on covers every texel already.
inline bool is_opaque(const Operation& operation) {
    return operation.depth == 0 || (operation.flags & kOpaque) != 0;
}

class TileTasks {
  public:
    /// Both have to stay. None is ready where somebody observes, who looks for sources in planes.
    TileTasks(const TileRun& run, TilePlanes& planes);

    /// A task that is ready, and what does it.
    template <class Task, class Kernel>
    struct Ready {
        Task task;
        Kernel kernel;
        StoredTexels image;  ///< where texels are read as they are stored: from the first on

        /// The task in a tile; of its blocks nothing is said.
        Task& at(const TileSpan& span) {
            task.count = span.count;
            if (image.texels != nullptr) task.stored.texels = texels_at(span, image);
            return task;
        }
    };
    using Blend = Ready<BlendTask, BlendKernel>;
    using Entry = Ready<MaskTask, MaskKernel>;
    /// Of the operation with that index; null where its source is another one in every tile.
    Blend* ready_blend(std::size_t index) { return found(blends_, index); }
    Entry* ready_entry(std::size_t index) { return found(entries_, index); }

    /// The tasks of operations that read `source` in `count` texels, but for the tile's blocks.
    BlendTask blend_task(const Operation& operation, const FetchedSource& source, int count) const;
    MaskTask mask_task(const Operation& operation, const FetchedSource& source, int count) const;

    /// Which texels a Blend or MaskEntry takes as they are stored; the operation has to stay.
    AcceptsStored takes_stored(const Operation& operation) const;
    const SourceRecord& source_of(const Operation& operation) const {
        return program_.sources[index_of(operation)];
    }

  private:
    template <class Task>
    Task* found(std::vector<Task>& tasks, std::size_t operation) {
        if (ready_.empty() || ready_[operation] < 0) return nullptr;
        return &tasks[static_cast<std::size_t>(ready_[operation])];
    }
    template <class Task, class Kernel>
    std::int32_t got_ready(const Operation& operation, std::vector<Ready<Task, Kernel>>& all,
                           Task (TileTasks::*make)(const Operation&, const FetchedSource&, int)
                               const,
                           Kernel (*kernel_of)(const Task&));
    static std::size_t index_of(const Operation& operation) {
        return static_cast<std::size_t>(operation.source);
    }
    ReadPlane weight_of(const Operation& operation, const FetchedSource& source, int count) const;
    const Levels* levels_of(const Operation& operation) const;

    const TileRun& run_;
    const ProgramData& program_;
    TilePlanes& planes_;
    /// By operation: index into `blends_` or, of a mask's entry, into `entries_`; -1: neither.
    std::vector<std::int32_t> ready_;
    std::vector<Blend> blends_;
    std::vector<Entry> entries_;
};

}  // namespace patina
