// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <set>

#include "composite/composite_rect.h"
#include "composite/prefix_caches.h"
#include "core/log.h"

namespace patina {
namespace {

/// Hash of all that decides the texels of a map.
Hash128 map_hash(const Program& program, BakedMap map) {
    switch (map) {
        case BakedMap::BaseColor:
            return program.slot_hash(Slot::BaseColor);
        case BakedMap::OcclusionRoughnessMetalness:
            return Hasher()
                .add(program.slot_hash(Slot::MetallicRoughness))
                .add(program.slot_hash(Slot::Occlusion))
                .finish();
        case BakedMap::Normal:
            return program.slot_hash(Slot::Normal);
        case BakedMap::Emissive:
            return program.slot_hash(Slot::Emissive);
    }
    return {};
}

/// Which of the images were there: a composite with placeholders is another picture.
Hash128 availability_hash(const BoundImages& images) {
    Hasher hasher;
    for (const BoundImage& image : images.sources) hasher.add(image.placeholder);
    return hasher.finish();
}

/// With `reach` texels more on every side; the whole side where that is beyond the border, past
/// which the other end of the map has changed.
TexelRect widened(TexelRect rect, int reach, int size) {
    const auto widen = [&](int& first, int& last) {
        first -= reach;
        last += reach;
        if (first >= 0 && last <= size) return;
        first = 0;
        last = size;
    };
    if (reach == 0) return rect;
    widen(rect.x0, rect.x1);
    widen(rect.y0, rect.y1);
    return rect;
}

double milliseconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

}  // namespace

struct LiveComposite::State {
    explicit State(std::size_t cache_budget_bytes) : caches(cache_budget_bytes) {}

    std::vector<BakedMap> stale_maps(const Program& program, int size, const Hash128& available);
    std::byte* writable(BakedMap map, int size);
    std::vector<CachePoint> storing_points(const ProgramData& program, int size, ChannelBits wanted,
                                           const std::vector<CachePoint>& read);
    void report(const BoundImages& bound);

    PrefixCaches caches;
    ReducedImages reduced;
    MapSet maps;
    std::array<Hash128, kBakedMapCount> shown = {};  ///< map_hash and availability of each map
    std::optional<Program> last;                     ///< what was composited last
    std::set<std::string> reported;                  ///< failures that the log has
};

LiveComposite::LiveComposite(std::size_t cache_budget_bytes)
    : state_(std::make_unique<State>(cache_budget_bytes)) {}
LiveComposite::~LiveComposite() = default;
LiveComposite::LiveComposite(LiveComposite&&) noexcept = default;
LiveComposite& LiveComposite::operator=(LiveComposite&&) noexcept = default;

const MapSet& LiveComposite::maps() const {
    return state_->maps;
}

std::size_t LiveComposite::cache_bytes() const {
    return state_->caches.size_bytes() + state_->reduced.size_bytes();
}

/// The maps that do not show `program` yet. Drops those that it does not need; forgets all where
/// the size has changed.
std::vector<BakedMap> LiveComposite::State::stale_maps(const Program& program, int size,
                                                       const Hash128& available) {
    if (maps.size != size) maps = {.size = size};
    const std::vector<BakedMap> needed = maps_of(program);
    std::vector<BakedMap> stale;
    for (int index = 0; index < kBakedMapCount; ++index) {
        const auto map = static_cast<BakedMap>(index);
        const auto at = static_cast<std::size_t>(index);
        const Hash128 hash = Hasher().add(map_hash(program, map)).add(available).finish();
        if (std::find(needed.begin(), needed.end(), map) == needed.end()) {
            maps.maps[at] = nullptr;
        } else if (maps.maps[at] == nullptr || shown[at] != hash) {
            stale.push_back(map);
            shown[at] = hash;
        }
    }
    return stale;
}

/// The pixels of a map to write: those of the last update where nobody else holds them, else a copy
/// of them, else fresh ones.
std::byte* LiveComposite::State::writable(BakedMap map, int size) {
    ImagePtr& shared = maps.maps[static_cast<std::size_t>(map)];
    std::shared_ptr<Image> own;
    if (shared == nullptr) {
        own = std::make_shared<Image>(Image{.width = size, .height = size, .channels = 4});
        own->data.resize(own->row_bytes() * static_cast<std::size_t>(size));
    } else if (shared.use_count() == 1) {
        own = std::const_pointer_cast<Image>(shared);
    } else {
        own = std::make_shared<Image>(*shared);
    }
    shared = own;
    return own->data.data();
}

/// Where the run is to fill caches: below what was edited, unless it starts further up.
std::vector<CachePoint> LiveComposite::State::storing_points(const ProgramData& program, int size,
                                                             ChannelBits wanted,
                                                             const std::vector<CachePoint>& read) {
    std::vector<CachePoint> points;
    if (!last) return points;
    for (const Checkpoint& place : places_below_edit(last->data(), program)) {
        const bool skipped = std::any_of(read.begin(), read.end(), [&](const CachePoint& point) {
            return place.end >= point.place.begin && place.end <= point.place.end;
        });
        if (skipped) continue;
        if (auto cache = caches.make_room(place, size, wanted))
            points.push_back({.place = place, .cache = std::move(cache)});
    }
    return points;
}

void LiveComposite::State::report(const BoundImages& bound) {
    for (const std::string& line : bound.failures)
        if (reported.insert(line).second) log_line(LogLevel::Warning, line);
}

Result<LiveComposite::Update> LiveComposite::update(const Program& program, ImageProvider& images,
                                                    int size, const Progress& progress) {
    return update_within({0, 0, size, size}, program, images, size, progress);
}

Result<LiveComposite::Update> LiveComposite::update_within(const TexelRect& within,
                                                           const Program& program,
                                                           ImageProvider& images, int size,
                                                           const Progress& progress) {
    const auto start = std::chrono::steady_clock::now();
    State& state = *state_;
    const ProgramData& data = program.data();
    const BoundImages bound = bind_images(data, kAllChannels, size, images, state.reduced);
    state.report(bound);
    const bool fresh = state.maps.size != size;
    Update update;
    update.changed_maps = state.stale_maps(program, size, availability_hash(bound));
    if (update.changed_maps.empty()) return update;

    const TexelRect whole{0, 0, size, size};
    ChannelBits wanted = 0;
    CompositeJob job{.program = &data, .images = &bound, .size = size};
    job.rect = fresh ? whole : widened(within, reach_of(data, size), size);
    for (const BakedMap map : update.changed_maps) {
        if (state.maps[map] == nullptr) job.rect = whole;
        wanted |= channels_of(map);
    }
    wanted = data.with_needed(wanted);
    for (const BakedMap map : update.changed_maps)
        job.targets[static_cast<std::size_t>(map)] = state.writable(map, size);

    // Placeholders would be cached under the hash of what they stand for.
    const bool cacheable = bound.failures.empty();
    std::vector<CachePoint> stored;
    if (cacheable) job.caches = state.caches.readable(data, size, wanted);
    if (cacheable && job.rect == whole)
        stored = state.storing_points(data, size, wanted, job.caches);
    job.caches.insert(job.caches.end(), stored.begin(), stored.end());
    if (!composite_rect(job, progress)) {
        state.maps = {};
        return failure("compositing was cancelled");
    }
    for (const CachePoint& point : stored) state.caches.keep(point, size);
    state.last = program;
    update.changed = job.rect;
    update.elapsed_ms = milliseconds_since(start);
    return update;
}

}  // namespace patina
