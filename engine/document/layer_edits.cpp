// SPDX-License-Identifier: MIT
#include "document/layer_edits.h"

#include <algorithm>

#include "document/change.h"
#include "document/check.h"

namespace patina {
namespace {

Edit layer_edit(const Material& material, const Layer& layer, std::string label, MergeKey merge_key,
                OwnLock lock, LayerChange change) {
    return {.label = std::move(label),
            .merge_key = std::move(merge_key),
            .apply = [material_id = material.id, layer_id = layer.id, lock,
                      change = std::move(change)](const Document& before) {
                return with_layer(before, material_id, layer_id, lock, change);
            }};
}

/// An edit that changes the stack around the layer at `path`, which is unlocked.
using PathChange = std::function<Result<LayerList>(const LayerList& stack, const LayerPath& path,
                                                   std::uint64_t& next_id)>;

Edit structure_edit(const Material& material, LayerId layer, std::string label, PathChange change) {
    return {.label = std::move(label),
            .merge_key = {},
            .apply = [material_id = material.id, layer,
                      change = std::move(change)](const Document& before) {
                return with_stack(
                    before, material_id,
                    [&](const LayerList& stack, std::uint64_t& next_id) -> Result<LayerList> {
                        const std::optional<LayerPath> path = path_of(stack, layer);
                        if (!path) return failure("there is no layer {}", layer.value);
                        return change(stack, *path, next_id);
                    });
            }};
}

Status check_new_layers(const Document& document, const LayerList& layers) {
    if (layer_count(layers) > kMaxLayers)
        return failure("a material can have at most {} layers", kMaxLayers);
    if (layer_depth(layers) > kMaxLayerDepth)
        return failure("groups can be nested at most {} deep", kMaxLayerDepth);
    for (const LayerPtr& layer : layers) {
        if (Status status = check_layer(*layer); !status) return status;
        if (Status status = check_images(document, *layer); !status) return status;
    }
    return {};
}

Layer fill_named(std::string_view name) {
    Layer layer;
    layer.name = name;
    at(layer.channels, Channel::BaseColor).enabled = true;
    return layer;
}

std::string copy_name(const std::string& name) {
    constexpr std::string_view suffix = " copy";
    return name.size() + suffix.size() > kMaxNameBytes ? name : name + std::string(suffix);
}

/// The paths of `layers`, lowest first, when all are in one list and none is locked.
Result<std::vector<LayerPath>> sibling_paths(const LayerList& stack,
                                             const std::vector<LayerId>& layers) {
    if (layers.empty()) return failure("choose the layers to group first");
    std::vector<LayerPath> paths;
    for (const LayerId id : layers) {
        const std::optional<LayerPath> path = path_of(stack, id);
        if (!path) return failure("there is no layer {}", id.value);
        if (Status status = check_unlocked(stack, *path); !status) return passed_on(status);
        paths.push_back(*path);
    }
    std::sort(paths.begin(), paths.end());
    paths.erase(std::unique(paths.begin(), paths.end()), paths.end());
    const auto in_first_list = [&](const LayerPath& path) {
        return std::equal(path.begin(), path.end() - 1, paths[0].begin(), paths[0].end() - 1);
    };
    if (!std::all_of(paths.begin(), paths.end(), in_first_list))
        return failure("only layers of one list can be grouped: choose them side by side");
    return paths;
}

Result<LayerList> grouped(const LayerList& stack, const std::vector<LayerId>& layers,
                          std::uint64_t& next_id) {
    const Result<std::vector<LayerPath>> paths = sibling_paths(stack, layers);
    if (!paths) return passed_on(paths);
    Layer group = group_layer();
    group.id = LayerId{next_id++};
    auto& children = std::get<GroupContent>(group.content).children;
    for (const LayerPath& path : *paths) children.push_back(layer_at(stack, path));

    LayerPath parents = paths->front();
    parents.pop_back();
    LayerList result = with_list_at(stack, parents, [&](LayerList& list) {
        const std::size_t place = paths->back().back() + 1 - paths->size();
        for (std::size_t i = paths->size(); i-- > 0;)
            list.erase(list.begin() + static_cast<std::ptrdiff_t>((*paths)[i].back()));
        list.insert(list.begin() + static_cast<std::ptrdiff_t>(place),
                    std::make_shared<const Layer>(std::move(group)));
    });
    if (layer_depth(result) > kMaxLayerDepth)
        return failure("groups can be nested at most {} deep", kMaxLayerDepth);
    if (layer_count(result) > kMaxLayers)
        return failure("a material can have at most {} layers", kMaxLayers);
    return result;
}

Result<LayerList> moved(const LayerList& stack, const LayerPath& path, LayerPlace place) {
    if (Status status = check_unlocked(stack, path); !status) return passed_on(status);
    const LayerPtr layer = layer_at(stack, path);
    const bool onto_itself =
        place.kind != LayerPlace::Kind::TopOfStack && place.anchor == layer->id;
    const bool beside =
        place.kind == LayerPlace::Kind::Above || place.kind == LayerPlace::Kind::Below;
    if (onto_itself && beside) return stack;
    if (onto_itself || path_of({layer}, place.anchor))
        return failure("{} cannot go into itself", quoted_for_message(layer->name, 80));
    Result<LayerList> result = with_inserted(with_removed(stack, path), {layer}, place);
    // Where it was already: keep the old nodes, so that nothing counts as changed.
    if (result && path_of(*result, layer->id) == path) return stack;
    return result;
}

}  // namespace

Layer value_layer() {
    Layer layer = fill_named("Fill");
    at(layer.channels, Channel::Metalness).enabled = true;
    at(layer.channels, Channel::Roughness).enabled = true;
    return layer;
}

Layer image_layer(const ImageAsset& image) {
    Layer layer = fill_named(check_name(image.name) ? std::string_view(image.name) : "Image");
    ImageSource source;
    source.image = image.hash;
    source.color_space = image.color_space;
    source.alpha_is_coverage = image.channels == 2 || image.channels == 4;
    at(layer.channels, Channel::BaseColor).source = source;
    return layer;
}

Layer procedural_layer(ProceduralKind kind) {
    Layer layer = fill_named(choice(kind).label);
    ProceduralSource source;
    source.kind = kind;
    at(layer.channels, Channel::BaseColor).source = source;
    return layer;
}

Layer adjustment_layer(AdjustmentKind kind) {
    Layer layer = fill_named(choice(kind).label);
    layer.blend_space = BlendSpace::SrgbEncoded;
    layer.content = AdjustmentContent{{.kind = kind}};
    return layer;
}

Layer group_layer() {
    Layer layer;
    layer.name = "Group";
    for (ChannelSettings& settings : layer.channels) settings.enabled = true;
    layer.content = GroupContent{};
    return layer;
}

LayerId next_layer_id(const Document& document) {
    return LayerId{document.next_id};
}

Edit add_layer(const Material& material, const Layer& layer, LayerPlace place) {
    return add_layers(material, {std::make_shared<const Layer>(layer)}, place,
                      "Add layer " + layer.name);
}

Edit add_layers(const Material& material, std::vector<LayerPtr> layers, LayerPlace place,
                std::string label) {
    return {.label = std::move(label),
            .merge_key = {},
            .apply = [id = material.id, layers = std::move(layers),
                      place](const Document& before) -> Result<Document> {
                if (Status status = check_new_layers(before, layers); !status)
                    return passed_on(status);
                return with_stack(before, id, [&](const LayerList& stack, std::uint64_t& next_id) {
                    return with_inserted(stack, with_fresh_ids(layers, next_id), place);
                });
            }};
}

Edit remove_layer(const Material& material, const Layer& layer) {
    return structure_edit(
        material, layer.id, "Delete " + layer.name,
        [](const LayerList& stack, const LayerPath& path, std::uint64_t&) -> Result<LayerList> {
            if (Status status = check_unlocked(stack, path); !status) return passed_on(status);
            return with_removed(stack, path);
        });
}

Edit duplicate_layer(const Material& material, const Layer& layer) {
    return structure_edit(
        material, layer.id, "Duplicate " + layer.name,
        [](const LayerList& stack, const LayerPath& path, std::uint64_t& next_id) {
            Layer copy = *layer_at(stack, path);
            const LayerPlace place = above(copy.id);
            copy.name = copy_name(copy.name);
            copy.locked = false;
            const LayerList copies = {std::make_shared<const Layer>(std::move(copy))};
            return with_inserted(stack, with_fresh_ids(copies, next_id), place);
        });
}

Edit move_layer(const Material& material, const Layer& layer, LayerPlace place) {
    return structure_edit(material, layer.id, "Move " + layer.name,
                          [place](const LayerList& stack, const LayerPath& path, std::uint64_t&) {
                              return moved(stack, path, place);
                          });
}

Edit group_layers(const Material& material, const std::vector<LayerPtr>& layers) {
    std::vector<LayerId> ids;
    for (const LayerPtr& layer : layers) ids.push_back(layer->id);
    const std::string what =
        layers.size() == 1 ? layers.front()->name : fmt::format("{} layers", layers.size());
    return {.label = "Group " + what,
            .merge_key = {},
            .apply = [id = material.id, ids = std::move(ids)](const Document& before) {
                return with_stack(before, id, [&](const LayerList& stack, std::uint64_t& next_id) {
                    return grouped(stack, ids, next_id);
                });
            }};
}

Edit ungroup_layer(const Material& material, const Layer& group) {
    return structure_edit(
        material, group.id, "Ungroup " + group.name,
        [](const LayerList& stack, const LayerPath& path, std::uint64_t&) -> Result<LayerList> {
            if (Status status = check_unlocked(stack, path); !status) return passed_on(status);
            const LayerPtr layer = layer_at(stack, path);
            const auto* content = std::get_if<GroupContent>(&layer->content);
            if (!content) return failure("{} is not a group", quoted_for_message(layer->name, 80));
            const std::span<const std::size_t> parents = std::span(path).first(path.size() - 1);
            return with_list_at(stack, parents, [&](LayerList& list) {
                const auto at = list.erase(list.begin() + static_cast<std::ptrdiff_t>(path.back()));
                list.insert(at, content->children.begin(), content->children.end());
            });
        });
}

Edit replace_stack(const Material& material, std::vector<LayerPtr> layers, std::string label) {
    return {.label = std::move(label),
            .merge_key = {},
            .apply = [id = material.id,
                      layers = std::move(layers)](const Document& before) -> Result<Document> {
                if (Status status = check_new_layers(before, layers); !status)
                    return passed_on(status);
                return with_stack(
                    before, id,
                    [&](const LayerList& stack, std::uint64_t& next_id) -> Result<LayerList> {
                        for (std::size_t i = 0; i < stack.size(); ++i)
                            if (Status status = check_unlocked(stack, LayerPath{i}); !status)
                                return passed_on(status);
                        return with_fresh_ids(layers, next_id);
                    });
            }};
}

Edit rename_layer(const Material& material, const Layer& layer, std::string name) {
    return layer_edit(material, layer, "Rename layer to " + name, {}, OwnLock::Respected,
                      [name](Layer& copy) -> Status {
                          if (Status status = check_name(name); !status) return status;
                          copy.name = name;
                          return {};
                      });
}

Edit set_layer_visible(const Material& material, const Layer& layer, bool visible) {
    return layer_edit(material, layer, (visible ? "Show " : "Hide ") + layer.name, {},
                      OwnLock::Ignored, [visible](Layer& copy) -> Status {
                          copy.visible = visible;
                          return {};
                      });
}

Edit set_layer_locked(const Material& material, const Layer& layer, bool locked) {
    return layer_edit(material, layer, (locked ? "Lock " : "Unlock ") + layer.name, {},
                      OwnLock::Ignored, [locked](Layer& copy) -> Status {
                          copy.locked = locked;
                          return {};
                      });
}

Edit set_layer_opacity(const Material& material, const Layer& layer, float opacity) {
    return layer_edit(material, layer, "Opacity of " + layer.name,
                      {"layer.opacity", layer.id.value}, OwnLock::Respected,
                      [opacity](Layer& copy) -> Status {
                          copy.opacity = opacity;
                          return check_range(Parameter::LayerOpacity, opacity);
                      });
}

Edit set_layer_clipped(const Material& material, const Layer& layer, bool clipped) {
    return layer_edit(material, layer, (clipped ? "Clip " : "Unclip ") + layer.name, {},
                      OwnLock::Respected, [clipped](Layer& copy) -> Status {
                          copy.clipped = clipped;
                          return {};
                      });
}

Edit set_adjustment(const Material& material, const Layer& layer,
                    const AdjustmentSettings& adjustment, Parameter parameter) {
    const ParameterInfo& row = info(parameter);
    const bool merges = row.kind != ParameterKind::Choice;
    return layer_edit(
        material, layer, fmt::format("{} of {}", row.label, layer.name),
        merges ? MergeKey{fmt::format("adjustment.{}", row.id), layer.id.value} : MergeKey{},
        OwnLock::Respected, [adjustment](Layer& copy) -> Status {
            auto* content = std::get_if<AdjustmentContent>(&copy.content);
            if (!content)
                return failure("{} is not an adjustment", quoted_for_message(copy.name, 80));
            content->adjustment = adjustment;
            if (!adjusts(adjustment.kind, Channel::Normal))
                at(copy.channels, Channel::Normal).enabled = false;
            return check_adjustment(adjustment);
        });
}

Edit set_layer_mode(const Material& material, const Layer& layer, BlendMode mode) {
    return layer_edit(material, layer, "Blend mode of " + layer.name, {}, OwnLock::Respected,
                      [mode](Layer& copy) -> Status {
                          if (!blends_layer(mode, copy.is_group()))
                              return failure("blend mode {} does not apply to {}", info(mode).label,
                                             mode == BlendMode::PassThrough
                                                 ? "layers that are no group"
                                                 : "colours");
                          copy.mode = mode;
                          return {};
                      });
}

Edit set_layer_blend_space(const Material& material, const Layer& layer, BlendSpace space) {
    return layer_edit(material, layer, "Blend space of " + layer.name, {}, OwnLock::Respected,
                      [space](Layer& copy) -> Status {
                          copy.blend_space = space;
                          return {};
                      });
}

Edit set_layer_height_blend(const Material& material, const Layer& layer, const HeightBlend& blend,
                            Parameter parameter) {
    const ParameterInfo& row = info(parameter);
    const bool merges = row.kind != ParameterKind::Switch;
    return layer_edit(
        material, layer, fmt::format("{} of {}", row.label, layer.name),
        merges ? MergeKey{fmt::format("height-blend.{}", row.id), layer.id.value} : MergeKey{},
        OwnLock::Respected, [blend](Layer& copy) -> Status {
            copy.height_blend = blend;
            return check_height_blend(blend);
        });
}

Edit set_group_open(const Material& material, const Layer& group, bool open) {
    return layer_edit(material, group, (open ? "Unfold " : "Fold ") + group.name, {},
                      OwnLock::Ignored, [open](Layer& copy) -> Status {
                          auto* content = std::get_if<GroupContent>(&copy.content);
                          if (!content)
                              return failure("{} is not a group",
                                             quoted_for_message(copy.name, 80));
                          content->open = open;
                          return {};
                      });
}

Edit set_channel_enabled(const Material& material, const Layer& layer, Channel channel,
                         bool enabled) {
    return layer_edit(
        material, layer,
        fmt::format("{} {} of {}", info(channel).label, enabled ? "on" : "off", layer.name), {},
        OwnLock::Respected, [channel, enabled](Layer& copy) -> Status {
            const auto* const content = std::get_if<AdjustmentContent>(&copy.content);
            if (enabled && content && !adjusts(content->adjustment.kind, channel))
                return failure("normals can only be blurred, sharpened and warped");
            at(copy.channels, channel).enabled = enabled;
            return {};
        });
}

Edit set_channel_mode(const Material& material, const Layer& layer, Channel channel,
                      std::optional<BlendMode> mode) {
    return layer_edit(material, layer,
                      fmt::format("{} blend mode of {}", info(channel).label, layer.name), {},
                      OwnLock::Respected, [channel, mode](Layer& copy) -> Status {
                          if (mode && !applies_to(*mode, channel))
                              return failure("blend mode {} does not apply to the {} channel",
                                             info(*mode).label, info(channel).id);
                          at(copy.channels, channel).mode = mode;
                          return {};
                      });
}

Edit set_channel_opacity(const Material& material, const Layer& layer, Channel channel,
                         float opacity) {
    return layer_edit(material, layer,
                      fmt::format("{} opacity of {}", info(channel).label, layer.name),
                      {fmt::format("channel.opacity/{}", info(channel).id), layer.id.value},
                      OwnLock::Respected, [channel, opacity](Layer& copy) -> Status {
                          at(copy.channels, channel).opacity = opacity;
                          return check_range(Parameter::ChannelOpacity, opacity);
                      });
}

}  // namespace patina
