// SPDX-License-Identifier: MIT
#include "editor/session/thumbnail_materials.h"

#include <algorithm>
#include <utility>

#include "core/formulae/formulae.h"
#include "document/stack_tree.h"

namespace patina::editor {
namespace {

Material stack_of(std::vector<Layer> layers) {
    Material material;
    material.id = {1};
    for (Layer& layer : layers) material.stack.push_back(std::make_shared<Layer>(std::move(layer)));
    return material;
}

Layer only_base_color(Source source) {
    Layer layer;
    layer.id = {1};
    ChannelSettings& base = at(layer.channels, Channel::BaseColor);
    base.enabled = true;
    base.source = std::move(source);
    return layer;
}

/// A number is shown as a grey, a normal as its usual colour, a height around middle grey.
Source as_color(const Source& source, Channel channel) {
    const ChannelKind kind = info(channel).kind;
    const auto shown = [kind](const glm::vec3& value) {
        if (kind == ChannelKind::Color) return value;
        if (kind == ChannelKind::Scalar) return glm::vec3(value.x);
        const float x = formulae::encoded_from_signed(value.x);
        if (kind == ChannelKind::Height) return glm::vec3(x);
        return glm::vec3(x, formulae::encoded_from_signed(value.y),
                         formulae::encoded_from_signed(value.z));
    };
    Source result = source;
    if (auto* constant = std::get_if<ConstantSource>(&result))
        constant->value = shown(constant->value);
    if (auto* procedural = std::get_if<ProceduralSource>(&result))
        for (RampStop& stop : procedural->ramp) stop.value = shown(stop.value);
    if (auto* image = std::get_if<ImageSource>(&result)) {
        image->color_space = ColorSpace::Srgb;  // the picture as it is stored
        image->multiply = glm::vec3(1.0f);
        image->add = glm::vec3(0.0f);
        image->directx_normal = false;
    }
    // Other layers are not there to be read.
    if (std::holds_alternative<ReliefSource>(result) ||
        std::holds_alternative<ReferenceSource>(result))
        result = ConstantSource{glm::vec3(0.5f)};
    return result;
}

std::optional<Channel> shown_channel(const Layer& layer) {
    for (const ChannelInfo& row : kChannels)
        if (at(layer.channels, row.channel).enabled) return row.channel;
    return std::nullopt;
}

Layer white_through(Mask mask) {
    Layer layer = only_base_color(ConstantSource{glm::vec3(1.0f)});
    layer.id = {2};
    layer.mask = std::move(mask);
    return layer;
}

/// The heights that masks read are no part of the picture.
Layer level() {
    Layer layer;
    layer.id = {3};
    ChannelSettings& height = at(layer.channels, Channel::Height);
    height.enabled = true;
    height.mode = BlendMode::Replace;
    return layer;
}

/// What an adjustment does, shown on all hues and on greys.
Material adjusted_spectrum(const Layer& adjustment) {
    ProceduralSource spectrum{.kind = ProceduralKind::GradientLinear, .scale = 1.0f};
    spectrum.ramp = {{0.0f, {1, 0, 0}},  {0.17f, {1, 1, 0}}, {0.33f, {0, 1, 0}}, {0.5f, {0, 1, 1}},
                     {0.67f, {0, 0, 1}}, {0.83f, {1, 0, 1}}, {1.0f, {1, 0, 0}}};
    ProceduralSource greys{.kind = ProceduralKind::GradientLinear, .scale = 1.0f};
    greys.transform.rotation_degrees = 90.0f;
    Layer shade = only_base_color(greys);
    shade.id = {2};
    shade.opacity = 0.6f;
    Layer copy = adjustment;
    copy.visible = true;
    copy.clipped = false;
    copy.opacity = 1.0f;
    copy.mask = {};
    copy.height_blend = {};
    copy.channels = default_channels();
    at(copy.channels, Channel::BaseColor).enabled = true;
    return stack_of({only_base_color(spectrum), std::move(shade), std::move(copy)});
}

/// The layer with that id and the groups around it, and nothing else.
std::vector<LayerPtr> only_branch(const std::vector<LayerPtr>& layers, LayerId id) {
    std::vector<LayerPtr> result;
    for (const LayerPtr& layer : layers) {
        if (layer->id == id) {
            result.push_back(layer);
            continue;
        }
        const auto* group = std::get_if<GroupContent>(&layer->content);
        if (group == nullptr) continue;
        std::vector<LayerPtr> children = only_branch(group->children, id);
        if (children.empty()) continue;
        Layer copy = *layer;
        std::get<GroupContent>(copy.content).children = std::move(children);
        result.push_back(std::make_shared<Layer>(std::move(copy)));
    }
    return result;
}

/// With no channel but the height, so that it is seen by what reads the heights below alone.
LayerPtr only_height(const LayerPtr& layer) {
    Layer copy = *layer;
    for (const ChannelInfo& row : kChannels)
        if (row.channel != Channel::Height) at(copy.channels, row.channel).enabled = false;
    return std::make_shared<Layer>(std::move(copy));
}

LayerPtr hidden(const LayerPtr& layer) {
    Layer copy = *layer;
    copy.visible = false;
    return std::make_shared<Layer>(std::move(copy));
}

/// What a mask of the layer reads: the heights below it in its list, and all layers, hidden, for
/// references.
std::vector<LayerPtr> what_masks_read(const std::vector<LayerPtr>& stack, LayerId id) {
    std::vector<LayerPtr> read;
    for (const LayerPtr& layer : stack) read.push_back(hidden(layer));
    const auto path = path_of(stack, id);
    if (!path) return read;
    const std::span<const std::size_t> whole = *path;
    const LayerList& list = list_at(stack, whole.first(whole.size() - 1));
    for (std::size_t i = 0; i < whole.back(); ++i) read.push_back(only_height(list[i]));
    return read;
}

}  // namespace

Material layer_thumbnail(const Layer& layer) {
    if (layer.is_adjustment()) return adjusted_spectrum(layer);
    if (layer.is_group()) {
        Layer copy = layer;
        copy.visible = true;
        copy.opacity = 1.0f;
        copy.mode = BlendMode::Normal;
        copy.mask = {};
        copy.height_blend = {};
        for (ChannelSettings& settings : copy.channels) settings.opacity = 1.0f;
        return stack_of({std::move(copy)});
    }
    const std::optional<Channel> channel = shown_channel(layer);
    if (!channel) return stack_of({});
    return source_thumbnail(at(layer.channels, *channel).source, *channel);
}

bool reads_other_layers(const Mask& mask) {
    return std::any_of(mask.entries.begin(), mask.entries.end(), [](const MaskEntry& entry) {
        return std::holds_alternative<ReliefSource>(entry.source) ||
               std::holds_alternative<ReferenceSource>(entry.source);
    });
}

Material mask_thumbnail(const Mask& mask, const std::vector<LayerPtr>& stack, LayerId layer) {
    Material shown =
        stack_of({only_base_color(ConstantSource{glm::vec3(0.0f)}), white_through(mask), level()});
    const std::vector<LayerPtr> read = what_masks_read(stack, layer);
    shown.stack.insert(shown.stack.begin(), read.begin(), read.end());
    return shown;
}

Mask only_entry(const MaskEntry& entry) {
    Mask mask;
    MaskEntry alone = entry;
    alone.visible = true;
    alone.opacity = 1.0f;
    alone.combine = BlendMode::Replace;
    if (entry.adjustment)
        mask.entries.push_back(
            {.source = ProceduralSource{.kind = ProceduralKind::GradientLinear, .scale = 1.0f}});
    mask.entries.push_back(std::move(alone));
    return mask;
}

Material source_thumbnail(const Source& source, Channel channel) {
    return stack_of({only_base_color(as_color(source, channel))});
}

Material preset_thumbnail(const Preset& preset) {
    Material material;
    material.id = {1};
    material.stack = preset.layers;
    return material;
}

Material with_only_layer(const Material& material, LayerId layer) {
    Material copy = material;
    copy.stack = only_branch(material.stack, layer);
    return copy;
}

Material with_mask_shown(const Material& material, LayerId layer) {
    const LayerPtr found = find_layer(material, layer);
    if (!found) return material;
    Material copy = material;
    copy.stack = mask_thumbnail(found->mask, material.stack, layer).stack;
    return copy;
}

}  // namespace patina::editor
