// SPDX-License-Identifier: MIT
#include "composite/prefix_caches.h"

#include <algorithm>

namespace patina {
namespace {

constexpr std::size_t kCachesOfStack = 2;
constexpr std::size_t kCachesOfGroups = 1;

std::vector<Checkpoint> checkpoints_of(const ProgramData& program, int depth, std::int32_t begin) {
    std::vector<Checkpoint> places;
    for (const Checkpoint& place : program.checkpoints)
        if (place.depth == depth && place.begin == begin) places.push_back(place);
    return places;
}

/// The first operation of the group whose layer ends at `place`, or -1 where it is no group.
std::int32_t group_begin(const ProgramData& program, const Checkpoint& place, std::int32_t from) {
    for (const Checkpoint& inner : program.checkpoints)
        if (inner.depth == place.depth + 1 && inner.begin >= from && inner.end <= place.end)
            return inner.begin;
    return -1;
}

/// How many layers from the bottom up are alike.
std::size_t common_layers(const std::vector<Checkpoint>& before,
                          const std::vector<Checkpoint>& after) {
    const std::size_t shorter = std::min(before.size(), after.size());
    std::size_t alike = 0;
    while (alike < shorter && before[alike].hash == after[alike].hash) ++alike;
    return alike;
}

}  // namespace

std::vector<CachePoint> PrefixCaches::readable(const ProgramData& program, int size,
                                               ChannelBits wanted) {
    std::vector<CachePoint> points;
    std::int32_t resumed = 0;
    for (int depth = 0; depth < program.depths; ++depth)
        for (auto place = program.checkpoints.rbegin(); place != program.checkpoints.rend();
             ++place) {
            if (place->depth != depth || place->begin < resumed) continue;
            const bool same_stack_served = std::any_of(
                points.begin(), points.end(),
                [&](const CachePoint& point) { return point.place.begin == place->begin; });
            Entry* const entry = same_stack_served ? nullptr : find(*place, size, wanted);
            if (entry == nullptr) continue;
            points.push_back({.place = *place, .cache = entry->cache, .read = true});
            if (depth == 0) resumed = place->end;
        }
    return points;
}

PrefixCaches::Entry* PrefixCaches::find(const Checkpoint& place, int size, ChannelBits wanted) {
    const ChannelBits needed = place.touched & wanted;
    for (auto entry = entries_.begin(); entry != entries_.end(); ++entry) {
        if (entry->hash != place.hash || entry->size != size || entry->depth != place.depth)
            continue;
        if ((needed & ~entry->cache->channels()) != 0) continue;
        entries_.splice(entries_.begin(), entries_, entry);
        return &entries_.front();
    }
    return nullptr;
}

std::shared_ptr<PrefixCache> PrefixCaches::make_room(const Checkpoint& place, int size,
                                                     ChannelBits wanted) {
    const ChannelBits channels = place.touched & wanted;
    const std::size_t needed = PrefixCache::size_bytes(size, place.depth, channels);
    if (channels == 0 || needed > budget_bytes_ || find(place, size, wanted) != nullptr)
        return nullptr;
    const bool of_stack = place.depth == 0;
    drop_beyond((of_stack ? kCachesOfStack : kCachesOfGroups) - 1, size, of_stack);
    while (!entries_.empty() && size_bytes() + needed > budget_bytes_) entries_.pop_back();
    return std::make_shared<PrefixCache>(size, place.depth, channels);
}

void PrefixCaches::drop_beyond(std::size_t entries, int size, bool of_stack) {
    std::size_t kept = 0;
    for (auto entry = entries_.begin(); entry != entries_.end();) {
        const bool alike = entry->size == size && (entry->depth == 0) == of_stack;
        entry = alike && ++kept > entries ? entries_.erase(entry) : std::next(entry);
    }
}

void PrefixCaches::keep(const CachePoint& point, int size) {
    entries_.push_front({point.place.hash, size, point.place.depth, point.cache});
}

std::size_t PrefixCaches::size_bytes() const {
    std::size_t sum = 0;
    for (const Entry& entry : entries_) sum += entry.cache->size_bytes();
    return sum;
}

std::vector<Checkpoint> places_below_edit(const ProgramData& before, const ProgramData& after) {
    std::vector<Checkpoint> places;
    std::int32_t begin_before = 0;
    std::int32_t begin_after = 0;
    for (int depth = 0; depth < std::min(before.depths, after.depths); ++depth) {
        const auto old_layers = checkpoints_of(before, depth, begin_before);
        const auto new_layers = checkpoints_of(after, depth, begin_after);
        const std::size_t alike = common_layers(old_layers, new_layers);
        if (alike > 0) places.push_back(new_layers[alike - 1]);
        if (alike == old_layers.size() || alike == new_layers.size()) break;
        const auto end_of = [&](const std::vector<Checkpoint>& layers, std::int32_t begin) {
            return alike > 0 ? layers[alike - 1].end : begin;
        };
        begin_before = group_begin(before, old_layers[alike], end_of(old_layers, begin_before));
        begin_after = group_begin(after, new_layers[alike], end_of(new_layers, begin_after));
        if (begin_before < 0 || begin_after < 0) break;
    }
    return places;
}

}  // namespace patina
