// SPDX-License-Identifier: MIT
#include "document/history.h"

#include <cassert>
#include <unordered_set>

namespace patina {
namespace {

/// Nodes that have been counted, by address: a node is one as long as the snapshots hold it.
using Nodes = std::unordered_set<const void*>;

void note_layers(const std::vector<LayerPtr>& layers, Nodes& nodes) {
    for (const LayerPtr& layer : layers) {
        if (!nodes.insert(layer.get()).second) continue;
        if (const auto* group = std::get_if<GroupContent>(&layer->content))
            note_layers(group->children, nodes);
    }
}

Nodes nodes_of(const Document* document) {
    Nodes nodes;
    if (!document) return nodes;
    for (const MaterialPtr& material : document->materials) {
        nodes.insert(material.get());
        note_layers(material->stack, nodes);
    }
    for (const auto& [hash, image] : document->images) nodes.insert(image.get());
    return nodes;
}

std::size_t bytes_of_names(const std::vector<std::string>& names) {
    std::size_t bytes = names.capacity() * sizeof(std::string);
    for (const std::string& name : names) bytes += name.capacity();
    return bytes;
}

std::size_t bytes_of_source(const Source& source) {
    if (const auto* noise = std::get_if<ProceduralSource>(&source))
        return noise->ramp.capacity() * sizeof(RampStop);
    if (const auto* parts = std::get_if<GeometrySource>(&source))
        return bytes_of_names(parts->meshes) + bytes_of_names(parts->materials);
    return 0;
}

std::size_t bytes_of_lists(const AdjustmentSettings& adjustment) {
    return adjustment.curve.capacity() * sizeof(CurvePoint) +
           adjustment.gradient.capacity() * sizeof(RampStop);
}

std::size_t bytes_of_layer(const Layer& layer) {
    std::size_t bytes = sizeof(Layer) + layer.name.capacity();
    for (const ChannelSettings& settings : layer.channels)
        bytes += bytes_of_source(settings.source);
    for (const MaskEntry& entry : layer.mask.entries) {
        bytes += sizeof(MaskEntry) + entry.name.capacity() + bytes_of_source(entry.source);
        if (entry.adjustment) bytes += bytes_of_lists(*entry.adjustment);
    }
    if (const auto* content = std::get_if<AdjustmentContent>(&layer.content))
        bytes += bytes_of_lists(content->adjustment);
    return bytes;
}

std::size_t bytes_of_new_layers(const std::vector<LayerPtr>& layers, Nodes& known) {
    std::size_t bytes = layers.capacity() * sizeof(LayerPtr);
    for (const LayerPtr& layer : layers) {
        if (!known.insert(layer.get()).second) continue;
        bytes += bytes_of_layer(*layer);
        if (const auto* group = std::get_if<GroupContent>(&layer->content))
            bytes += bytes_of_new_layers(group->children, known);
    }
    return bytes;
}

std::size_t bytes_of_image(const ImageAsset& image) {
    return sizeof image + image.name.capacity() + image.encoded.bytes_in_memory();
}

/// Whether nothing was changed between two snapshots of one document. By node: an edit that changes
/// nothing keeps the nodes.
bool same_content(const Document& a, const Document& b) {
    return a.materials == b.materials && a.images == b.images && a.environment == b.environment &&
           a.lights == b.lights && a.assigned == b.assigned && a.source == b.source &&
           a.scene == b.scene;
}

}  // namespace

std::size_t added_bytes(const Document* before, const Document* after) {
    if (!after) return 0;
    Nodes known = nodes_of(before);
    std::size_t bytes = sizeof(Document) + after->materials.capacity() * sizeof(MaterialPtr) +
                        after->lights.capacity() * sizeof(Light);
    for (const MaterialPtr& material : after->materials)
        if (known.insert(material.get()).second)
            bytes += sizeof(Material) + material->name.capacity() +
                     bytes_of_new_layers(material->stack, known);
    for (const auto& [hash, image] : after->images)
        if (known.insert(image.get()).second) bytes += bytes_of_image(*image);
    return bytes;
}

History::History(DocumentPtr opened, std::size_t budget_bytes) : budget_bytes_(budget_bytes) {
    assert(opened);
    saved_ = opened;
    steps_.push_back({.label = "Open", .merge_key = {}, .document = std::move(opened), .bytes = 0});
}

const DocumentPtr& History::document() const {
    return steps_[current_].document;
}

Status History::apply(const Edit& edit) {
    const DocumentPtr before = document();
    Result<Document> result = edit.apply(*before);
    if (!result) return passed_on(result);
    if (same_content(*before, *result)) return {};

    const auto after = std::make_shared<const Document>(std::move(*result));
    const bool merges = !sealed_ && current_ > 0 && current_ + 1 == steps_.size() &&
                        !edit.merge_key.action.empty() &&
                        edit.merge_key == steps_[current_].merge_key;
    steps_.resize(current_ + (merges ? 0 : 1));
    const Document* previous = steps_.back().document.get();
    steps_.push_back({.label = edit.label,
                      .merge_key = edit.merge_key,
                      .document = after,
                      .bytes = added_bytes(previous, after.get())});
    current_ = steps_.size() - 1;
    sealed_ = false;
    forget_beyond_budget();
    return {};
}

void History::seal() {
    sealed_ = true;
}

bool History::can_undo() const {
    return current_ > 0;
}
bool History::can_redo() const {
    return current_ + 1 < steps_.size();
}
void History::undo() {
    jump_to(position() - 1);
}
void History::redo() {
    jump_to(position() + 1);
}

std::vector<std::string> History::labels() const {
    std::vector<std::string> labels;
    for (const Step& step : steps_) labels.push_back(step.label);
    return labels;
}

int History::position() const {
    return static_cast<int>(current_);
}

bool History::jump_to(int position) {
    if (position < 0 || static_cast<std::size_t>(position) >= steps_.size()) return false;
    current_ = static_cast<std::size_t>(position);
    seal();
    return true;
}

void History::mark_saved(DocumentPtr saved) {
    saved_ = std::move(saved);
    seal();
}

bool History::is_edited() const {
    return document() != saved_;
}

std::size_t History::bytes() const {
    std::size_t bytes = 0;
    for (const Step& step : steps_) bytes += step.bytes;
    return bytes;
}

void History::forget_beyond_budget() {
    // The current step and the one before it stay: the last edit can always be undone.
    std::size_t total = bytes();
    std::size_t forgotten = 0;
    while (total > budget_bytes_ && steps_.size() - forgotten > 2)
        total -= steps_[++forgotten].bytes;
    if (forgotten == 0) return;
    steps_.erase(steps_.begin(), steps_.begin() + static_cast<std::ptrdiff_t>(forgotten));
    steps_.front().bytes = 0;
    current_ -= forgotten;
}

}  // namespace patina
