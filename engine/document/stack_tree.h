// SPDX-License-Identifier: MIT
#pragma once

/// A stack as a tree: finding layers in it, and rebuilding it with something changed. Only the
/// nodes from the change up to the root are made anew; all others are shared with the old tree.

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/result.h"
#include "document/document.h"
#include "document/layer_edits.h"

namespace patina {

using LayerList = std::vector<LayerPtr>;

/// The index in each list on the way down to a layer; empty stands for the stack itself.
using LayerPath = std::vector<std::size_t>;

std::optional<LayerPath> path_of(const LayerList& stack, LayerId id);
const LayerPtr& layer_at(const LayerList& stack, std::span<const std::size_t> path);
/// The children of the group at `path`, or the stack.
const LayerList& list_at(const LayerList& stack, std::span<const std::size_t> path);

/// Layers in the list, groups and all they hold counted.
int layer_count(const LayerList& layers);
/// The deepest nesting: 1 when there is no group with children.
int layer_depth(const LayerList& layers);

/// Calls visit(source) for what each channel and mask entry of the layer itself reads, on or off.
template <typename LayerType, typename Visit>
void for_each_own_source(LayerType& layer, const Visit& visit) {
    for (auto& settings : layer.channels) visit(settings.source);
    for (auto& entry : layer.mask.entries) visit(entry.source);
}

/// The same for all of the layers, groups before their children.
template <typename Visit>
void for_each_source(const LayerList& layers, const Visit& visit) {
    for (const LayerPtr& layer : layers) {
        for_each_own_source(*layer, visit);
        if (const auto* group = std::get_if<GroupContent>(&layer->content))
            for_each_source(group->children, visit);
    }
}

/// The stack with the list at `path` changed. Groups whose children stayed the same are kept.
LayerList with_list_at(const LayerList& stack, std::span<const std::size_t> path,
                       const std::function<void(LayerList&)>& change);

/// Whether a layer's own lock stops a change. A locked group around it always does.
enum class OwnLock { Respected, Ignored };

/// Fails when the layer at `path` may not be changed because it or a group around it is locked.
Status check_unlocked(const LayerList& stack, std::span<const std::size_t> path,
                      OwnLock lock = OwnLock::Respected);

/// The layers with new ids from `next_id` on: of each first its own, then its mask entries', then
/// its children's. References among them stay among them.
LayerList with_fresh_ids(const LayerList& layers, std::uint64_t& next_id);

/// Puts layers (the first one lowest) at a place; refuses what would be too many or too deep.
Result<LayerList> with_inserted(const LayerList& stack, const LayerList& layers, LayerPlace place);
LayerList with_removed(const LayerList& stack, std::span<const std::size_t> path);

}  // namespace patina
