// SPDX-License-Identifier: MIT
#pragma once

/// The prefix caches of one material: which are kept, and which of them a run can use.

#include <list>

#include "composite/prefix_cache.h"

namespace patina {

/// One thread at a time. Keeps at most two caches of the stack and one of a group for each
/// resolution, the least recently used of all goes first when they exceed the budget.
class PrefixCaches {
  public:
    explicit PrefixCaches(std::size_t budget_bytes) : budget_bytes_(budget_bytes) {}

    /// The places from which a run of `program` can go on: the furthest of the stack, and of each
    /// group that follows it.
    std::vector<CachePoint> readable(const ProgramData& program, int size, ChannelBits wanted);

    /// Makes room for what `program` accumulates at `place`; null where that exceeds the budget or
    /// is there already. Not found by readable() before it is kept.
    std::shared_ptr<PrefixCache> make_room(const Checkpoint& place, int size, ChannelBits wanted);
    void keep(const CachePoint& point, int size);

    std::size_t size_bytes() const;

  private:
    struct Entry {
        Hash128 hash;
        int size = 0;
        int depth = 0;
        std::shared_ptr<PrefixCache> cache;
    };
    Entry* find(const Checkpoint& place, int size, ChannelBits wanted);
    void drop_beyond(std::size_t entries, int size, bool of_stack);

    std::list<Entry> entries_;  ///< the most recently used first
    std::size_t budget_bytes_;
};

/// The places below what differs between two programs: in the stack, and in the group in which it
/// differs, if it is one. A run that stores there makes the next edit of the same layer cheap.
std::vector<Checkpoint> places_below_edit(const ProgramData& before, const ProgramData& after);

}  // namespace patina
