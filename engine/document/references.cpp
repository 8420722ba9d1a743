// SPDX-License-Identifier: MIT
#include "document/references.h"

#include <algorithm>
#include <set>
#include <string>

namespace patina {
namespace {

bool has_references(const LayerList& layers) {
    bool found = false;
    for_each_source(layers, [&](const Source& source) {
        found = found || std::holds_alternative<ReferenceSource>(source);
    });
    return found;
}

/// Which layers each layer of a stack depends on directly.
class Dependencies {
  public:
    explicit Dependencies(const LayerList& stack) {
        top_ = add(stack);
        for (std::size_t i = 0; i < nodes_.size(); ++i) add_references(i);
    }

    struct Node {
        LayerPtr layer;
        std::vector<std::size_t> needs = {};  ///< once for each time that it is evaluated
        enum class Mark { New, Open, Done } mark = Mark::New;
        int cost = 1;   ///< layers evaluated for it
        int depth = 1;  ///< of groups and references from it down
    };

    /// Fails where there is a cycle; costs and depths are known afterwards.
    Status visit_all() {
        for (Node& node : nodes_)
            if (Status status = visit(node); !status) return status;
        return {};
    }

    const std::vector<Node>& nodes() const { return nodes_; }
    const std::vector<std::size_t>& top() const { return top_; }

    /// Marks all that depends on the layer, itself included.
    std::vector<bool> dependants(LayerId id) const {
        std::vector<bool> reached(nodes_.size(), false);
        const auto own = index_.find(id);
        if (own == index_.end()) return reached;
        reached[own->second] = true;
        for (bool grows = true; grows;) {
            grows = false;
            for (std::size_t i = 0; i < nodes_.size(); ++i) {
                const auto& needs = nodes_[i].needs;
                if (reached[i] || std::none_of(needs.begin(), needs.end(),
                                               [&](std::size_t need) { return reached[need]; }))
                    continue;
                reached[i] = grows = true;
            }
        }
        return reached;
    }

  private:
    /// Returns the indices of the layers in the list.
    std::vector<std::size_t> add(const LayerList& layers) {
        std::vector<std::size_t> indices;
        std::optional<std::size_t> base;
        for (const LayerPtr& layer : layers) {
            const std::size_t index = nodes_.size();
            indices.push_back(index);
            nodes_.push_back({layer});
            index_.emplace(layer->id, index);
            if (const auto* group = std::get_if<GroupContent>(&layer->content)) {
                std::vector<std::size_t> children = add(group->children);
                nodes_[index].needs = std::move(children);
            }
            if (layer->clipped && base) nodes_[index].needs.push_back(*base);
            if (!layer->clipped) base = index;
        }
        return indices;
    }

    void add_references(std::size_t index) {
        for_each_own_source(*nodes_[index].layer, [&](const Source& source) {
            const auto* const reference = std::get_if<ReferenceSource>(&source);
            if (reference == nullptr) return;
            if (const auto found = index_.find(reference->layer); found != index_.end())
                nodes_[index].needs.push_back(found->second);
        });
    }

    Status visit(Node& node) {
        using Mark = Node::Mark;
        if (node.mark == Mark::Done) return {};
        node.mark = Mark::Open;
        for (const std::size_t need : node.needs) {
            Node& other = nodes_[need];
            if (other.mark == Mark::Open)
                return failure("{} would depend on itself, by what {} reads",
                               quoted_for_message(other.layer->name, 80),
                               quoted_for_message(node.layer->name, 80));
            if (Status status = visit(other); !status) return status;
            node.cost = std::min(node.cost + other.cost, kMaxEvaluatedLayers + 1);
            node.depth = std::max(node.depth, other.depth + 1);
        }
        node.mark = Mark::Done;
        return {};
    }

    std::vector<Node> nodes_;  ///< top-level layers and those in groups, bottom to top
    std::vector<std::size_t> top_;
    std::map<LayerId, std::size_t> index_;
};

void collect_ids(const LayerList& layers, std::set<LayerId>& ids) {
    for (const LayerPtr& layer : layers) {
        ids.insert(layer->id);
        if (const auto* group = std::get_if<GroupContent>(&layer->content))
            collect_ids(group->children, ids);
    }
}

/// The layers of that name, the highest first.
void collect_named(const LayerList& layers, const std::string& name, LayerList& found) {
    for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer) {
        if ((*layer)->name == name) found.push_back(*layer);
        if (const auto* group = std::get_if<GroupContent>(&(*layer)->content))
            collect_named(group->children, name, found);
    }
}

/// Takes references to other layers than those that were brought to those of another stack.
class Bringing {
  public:
    Bringing(const LayerList& stack, const LayerList& layers, const LayerNames& names)
        : stack_(stack), names_(names) {
        collect_ids(layers, own_);
    }

    LayerList brought(const LayerList& layers) {
        LayerList result;
        for (const LayerPtr& layer : layers) result.push_back(brought(layer));
        return result;
    }
    int dropped() const { return dropped_; }

  private:
    LayerPtr brought(const LayerPtr& layer) {
        Layer copy = *layer;
        for (const ChannelInfo& row : kChannels) {
            ChannelSettings& settings = at(copy.channels, row.channel);
            if (!is_lost(settings.source)) continue;
            dropped_ += settings.enabled ? 1 : 0;
            settings.enabled = false;
            settings.source = ConstantSource{stack_bottom(row.channel)};
        }
        dropped_ += static_cast<int>(std::erase_if(
            copy.mask.entries, [&](MaskEntry& entry) { return is_lost(entry.source); }));
        if (auto* group = std::get_if<GroupContent>(&copy.content))
            group->children = brought(group->children);
        return copy == *layer ? layer : std::make_shared<const Layer>(std::move(copy));
    }

    /// Whether what it reads is not there; else it reads it.
    bool is_lost(Source& source) const {
        auto* const reference = std::get_if<ReferenceSource>(&source);
        if (reference == nullptr || own_.contains(reference->layer)) return false;
        const auto name = names_.find(reference->layer);
        if (name == names_.end()) return true;
        LayerList found;
        collect_named(stack_, name->second, found);
        // Ids of their own mean those that are brought.
        std::erase_if(found, [&](const LayerPtr& layer) { return own_.contains(layer->id); });
        if (found.empty()) return true;
        const bool same = std::any_of(found.begin(), found.end(), [&](const LayerPtr& layer) {
            return layer->id == reference->layer;
        });
        if (!same) reference->layer = found.front()->id;
        return false;
    }

    const LayerList& stack_;
    const LayerNames& names_;
    std::set<LayerId> own_;
    int dropped_ = 0;
};

LayerPtr moved_in(const LayerPtr& layer, const LayerIdMap& moved) {
    Layer copy = *layer;
    for_each_own_source(copy, [&](Source& source) {
        auto* const reference = std::get_if<ReferenceSource>(&source);
        if (reference == nullptr) return;
        if (const auto found = moved.find(reference->layer); found != moved.end())
            reference->layer = found->second;
    });
    if (auto* group = std::get_if<GroupContent>(&copy.content))
        group->children = with_references_moved(group->children, moved);
    return copy == *layer ? layer : std::make_shared<const Layer>(std::move(copy));
}

}  // namespace

Status check_references(const LayerList& stack) {
    if (!has_references(stack)) return {};
    Dependencies dependencies(stack);
    if (Status status = dependencies.visit_all(); !status) return status;
    int cost = 0;
    for (const std::size_t index : dependencies.top()) {
        const Dependencies::Node& node = dependencies.nodes()[index];
        cost = std::min(cost + node.cost, kMaxEvaluatedLayers + 1);
        if (node.depth > kMaxEvaluatedDepth)
            return failure("groups and references can be nested at most {} deep",
                           kMaxEvaluatedDepth);
    }
    if (cost > kMaxEvaluatedLayers)
        return failure("references would make more than {} layers of this stack",
                       kMaxEvaluatedLayers);
    return {};
}

std::vector<LayerPtr> referable_layers(const LayerList& stack, LayerId reader) {
    const Dependencies dependencies(stack);
    const std::vector<bool> out = dependencies.dependants(reader);
    std::vector<LayerPtr> layers;
    for (std::size_t i = out.size(); i-- > 0;)
        if (!out[i]) layers.push_back(dependencies.nodes()[i].layer);
    return layers;
}

LayerNames names_read(const LayerList& layers, const LayerList& stack) {
    std::set<LayerId> own;
    collect_ids(layers, own);
    LayerNames names;
    for_each_source(layers, [&](const Source& source) {
        const auto* const reference = std::get_if<ReferenceSource>(&source);
        if (reference == nullptr || own.contains(reference->layer)) return;
        const auto path = path_of(stack, reference->layer);
        if (path) names.emplace(reference->layer, layer_at(stack, *path)->name);
    });
    return names;
}

BroughtLayers brought_to(const LayerList& stack, const LayerList& layers, const LayerNames& names) {
    Bringing bringing(stack, layers, names);
    BroughtLayers result{.layers = bringing.brought(layers)};
    result.dropped = bringing.dropped();
    return result;
}

LayerList with_references_moved(const LayerList& layers, const LayerIdMap& moved) {
    LayerList result;
    result.reserve(layers.size());
    for (const LayerPtr& layer : layers) result.push_back(moved_in(layer, moved));
    return result;
}

}  // namespace patina
