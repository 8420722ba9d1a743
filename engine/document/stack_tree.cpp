// SPDX-License-Identifier: MIT
#include "document/stack_tree.h"

#include <algorithm>

#include "document/references.h"

namespace patina {
namespace {

const LayerList* children_of(const Layer& layer) {
    const auto* group = std::get_if<GroupContent>(&layer.content);
    return group ? &group->children : nullptr;
}

bool find_path(const LayerList& layers, LayerId id, LayerPath& path) {
    for (std::size_t i = 0; i < layers.size(); ++i) {
        path.push_back(i);
        if (layers[i]->id == id) return true;
        const LayerList* children = children_of(*layers[i]);
        if (children && find_path(*children, id, path)) return true;
        path.pop_back();
    }
    return false;
}

/// A place as the list that it is in and the index there.
struct Spot {
    LayerPath list;
    std::size_t index = 0;
};

Result<Spot> spot_of(const LayerList& stack, LayerPlace place) {
    if (place.kind == LayerPlace::Kind::TopOfStack) return Spot{{}, stack.size()};
    std::optional<LayerPath> path = path_of(stack, place.anchor);
    if (!path) return failure("there is no layer {} to put a layer at", place.anchor.value);

    if (place.kind == LayerPlace::Kind::Above || place.kind == LayerPlace::Kind::Below) {
        const std::size_t index = path->back();
        path->pop_back();
        return Spot{*path, place.kind == LayerPlace::Kind::Above ? index + 1 : index};
    }
    const Layer& group = *layer_at(stack, *path);
    if (!group.is_group())
        return failure("{} is not a group: layers cannot go into it",
                       quoted_for_message(group.name, 80));
    return Spot{*path, children_of(group)->size()};
}

Status check_size(const LayerList& stack) {
    if (const int count = layer_count(stack); count > kMaxLayers)
        return failure("a material can have at most {} layers, this would make {}", kMaxLayers,
                       count);
    if (const int depth = layer_depth(stack); depth > kMaxLayerDepth)
        return failure("groups can be nested at most {} deep, this would make {}", kMaxLayerDepth,
                       depth);
    return {};
}

LayerPtr renumbered(const Layer& layer, std::uint64_t& next_id, LayerIdMap& given) {
    Layer copy = layer;
    copy.id = LayerId{next_id++};
    given[layer.id] = copy.id;
    for (MaskEntry& entry : copy.mask.entries) entry.id = MaskEntryId{next_id++};
    if (auto* group = std::get_if<GroupContent>(&copy.content))
        for (LayerPtr& child : group->children) child = renumbered(*child, next_id, given);
    return std::make_shared<const Layer>(std::move(copy));
}

}  // namespace

std::optional<LayerPath> path_of(const LayerList& stack, LayerId id) {
    LayerPath path;
    if (!find_path(stack, id, path)) return std::nullopt;
    return path;
}

const LayerPtr& layer_at(const LayerList& stack, std::span<const std::size_t> path) {
    return list_at(stack, path.first(path.size() - 1))[path.back()];
}

const LayerList& list_at(const LayerList& stack, std::span<const std::size_t> path) {
    const LayerList* list = &stack;
    for (const std::size_t index : path) list = children_of(*(*list)[index]);
    return *list;
}

int layer_count(const LayerList& layers) {
    int count = 0;
    for (const LayerPtr& layer : layers) {
        const LayerList* children = children_of(*layer);
        count += 1 + (children ? layer_count(*children) : 0);
    }
    return count;
}

int layer_depth(const LayerList& layers) {
    int depth = 0;
    for (const LayerPtr& layer : layers) {
        const LayerList* children = children_of(*layer);
        depth = std::max(depth, 1 + (children ? layer_depth(*children) : 0));
    }
    return depth;
}

LayerList with_list_at(const LayerList& stack, std::span<const std::size_t> path,
                       const std::function<void(LayerList&)>& change) {
    LayerList copy = stack;
    if (path.empty()) {
        change(copy);
        return copy;
    }
    LayerPtr& group = copy[path.front()];
    const LayerList& before = *children_of(*group);
    LayerList after = with_list_at(before, path.subspan(1), change);
    if (after != before) {
        Layer changed = *group;
        std::get<GroupContent>(changed.content).children = std::move(after);
        group = std::make_shared<const Layer>(std::move(changed));
    }
    return copy;
}

Status check_unlocked(const LayerList& stack, std::span<const std::size_t> path, OwnLock lock) {
    for (std::size_t depth = 1; depth <= path.size(); ++depth) {
        const Layer& layer = *layer_at(stack, path.first(depth));
        if (!layer.locked) continue;
        const std::string name = quoted_for_message(layer.name, 80);
        const bool is_itself = depth == path.size();
        if (is_itself && lock == OwnLock::Ignored) continue;
        if (is_itself) return failure("{} is locked: unlock it first", name);
        return failure("{} is in {}, which is locked: unlock it first",
                       quoted_for_message(layer_at(stack, path)->name, 80), name);
    }
    return {};
}

LayerList with_fresh_ids(const LayerList& layers, std::uint64_t& next_id) {
    LayerIdMap given;
    LayerList fresh;
    for (const LayerPtr& layer : layers) fresh.push_back(renumbered(*layer, next_id, given));
    return with_references_moved(fresh, given);
}

Result<LayerList> with_inserted(const LayerList& stack, const LayerList& layers, LayerPlace place) {
    const Result<Spot> spot = spot_of(stack, place);
    if (!spot) return passed_on(spot);
    if (Status status = check_unlocked(stack, spot->list); !status) return passed_on(status);
    LayerList result = with_list_at(stack, spot->list, [&](LayerList& list) {
        list.insert(list.begin() + static_cast<std::ptrdiff_t>(spot->index), layers.begin(),
                    layers.end());
    });
    if (Status status = check_size(result); !status) return passed_on(status);
    return result;
}

LayerList with_removed(const LayerList& stack, std::span<const std::size_t> path) {
    return with_list_at(stack, path.first(path.size() - 1), [&](LayerList& list) {
        list.erase(list.begin() + static_cast<std::ptrdiff_t>(path.back()));
    });
}

}  // namespace patina
