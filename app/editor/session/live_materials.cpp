// SPDX-License-Identifier: MIT
#include "editor/session/live_materials.h"

#include <algorithm>
#include <utility>

#include "core/log.h"
#include "document/worn_surface.h"

namespace patina::editor {

LiveMaterials::LiveMaterials(std::function<void()> wake)
    : wake_(std::move(wake)), thread_([this] { run(); }) {}

LiveMaterials::~LiveMaterials() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
        current_.cancel();
    }
    work_.notify_all();
    thread_.join();
}

void LiveMaterials::show(const DocumentPtr& document, std::vector<Wanted> materials,
                         std::shared_ptr<ImageProvider> images, MaterialId first) {
    // Only this thread changes what is wanted: it may look without the lock.
    const auto is_wanted = [](const Wanted& wanted, const Worn& worn) {
        return wanted.material == worn.material;
    };
    const bool as_before =
        document == document_ && images == images_ &&
        std::equal(materials.begin(), materials.end(), wanted_.begin(), wanted_.end(), is_wanted);
    std::vector<int> seen_sizes;
    for (const Wanted& each : materials) seen_sizes.push_back(each.seen_size);
    std::vector<Worn> wanted;
    if (!as_before)
        for (auto& [material, seen_size] : materials) {
            UvSurfacePtr surface = surface_read(*document, *material, surface_of(material->id));
            wanted.push_back({std::move(material), std::move(surface)});
        }
    document_ = document;
    {
        const std::lock_guard lock(mutex_);
        seen_sizes_ = std::move(seen_sizes);
        if (as_before || (wanted == wanted_ && images == images_)) {
            first_ = first;
            return;
        }
        if (images != images_) forget_ = true;
        wanted_ = std::move(wanted);
        images_ = std::move(images);
        first_ = first;
        current_.cancel();
    }
    work_.notify_all();
}

std::map<MaterialId, UvSurfacePtr> LiveMaterials::surfaces() const {
    std::map<MaterialId, UvSurfacePtr> surfaces;
    for (const Worn& worn : wanted_)
        if (worn.surface) surfaces.emplace(worn.material->id, worn.surface);
    return surfaces;
}

UvSurfacePtr LiveMaterials::surface_of(MaterialId material) const {
    for (const Worn& worn : wanted_)
        if (worn.material->id == material) return worn.surface;
    return nullptr;
}

std::vector<LiveMaterials::Changed> LiveMaterials::take() {
    std::vector<Changed> result;
    {
        const std::lock_guard lock(mutex_);
        result.swap(ready_);
    }
    if (!result.empty()) work_.notify_all();
    return result;
}

bool LiveMaterials::settled() const {
    const std::lock_guard lock(mutex_);
    return !busy_ && !forget_ && ready_.empty() && !next_task();
}

/// The selected material before the others, previews before full sizes.
std::optional<LiveMaterials::Task> LiveMaterials::next_task() const {
    std::optional<Task> refinement;
    std::optional<Task> preview;
    for (std::size_t i = 0; i < wanted_.size(); ++i) {
        const Worn& worn = wanted_[i];
        const MaterialPtr& material = worn.material;
        const auto made = made_.find(material->id);
        const bool is_first = material->id == first_;
        const bool current = made != made_.end() && made->second.worn == worn;
        const int least = std::min(material->resolution, seen_sizes_[i]);
        if (!current) {
            if (!preview || is_first) preview = Task{worn, least};
        } else if (made->second.size < material->resolution) {
            if (!refinement || is_first) refinement = Task{worn, material->resolution};
        }
    }
    return preview ? preview : refinement;
}

std::optional<LiveMaterials::Changed> LiveMaterials::make(const Task& task, Made& made,
                                                          ImageProvider& images,
                                                          const Progress& progress) {
    const Material& material = *task.worn.material;
    const Program program = Program::compile(material, task.worn.surface);
    const std::vector<BakedMap> needed = render::baked_maps_of(program.slots());
    Changed changed;
    changed.source_material = material.source_material.value_or(-1);
    MapSet maps;
    if (!needed.empty()) {
        for (const Hash128& image : program.images())
            if (const auto pixels = images.pixels(image); !pixels)
                log_warning("{}", pixels.error().message);
        LiveComposite& composite = task.size < material.resolution ? made.preview : made.full;
        const auto update = composite.update(program, images, task.size, progress);
        if (!update) {
            if (!progress.cancelled()) log_warning("{}", update.error().message);
            return std::nullopt;
        }
        changed.elapsed_ms = update->elapsed_ms;
        if (made.size == task.size && made.worn.material) changed.texels = update->changed;
        maps = composite.maps();
    }
    changed.surface = render::surface_of(material, program.slots(), maps, images);
    return changed;
}

void LiveMaterials::run() {
    std::unique_lock lock(mutex_);
    while (!stopping_) {
        if (std::exchange(forget_, false)) made_.clear();
        // One result at a time, so that maps are not held by a queue while they are updated.
        const std::optional<Task> task = ready_.empty() ? next_task() : std::nullopt;
        if (!task) {
            work_.wait(lock);
            continue;
        }
        const std::shared_ptr<ImageProvider> images = images_;
        current_ = Progress();
        const Progress progress = current_;
        busy_ = true;
        Made& made = made_[task->worn.material->id];
        lock.unlock();
        std::optional<Changed> changed = make(*task, made, *images, progress);
        lock.lock();
        busy_ = false;
        // A failure that is not a cancellation counts as made: it has been reported.
        if (!forget_ && (changed || !progress.cancelled())) {
            made.worn = task->worn;
            made.size = task->size;
        }
        if (changed && !forget_) ready_.push_back(std::move(*changed));
        lock.unlock();
        changed.reset();
        wake_();
        lock.lock();
    }
}

}  // namespace patina::editor
