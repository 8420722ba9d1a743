// SPDX-License-Identifier: MIT
#include "composite/stack_terms.h"

#include <algorithm>

#include "composite/uniform_values.h"

namespace patina {
namespace {

/// Whether the source has a value of full weight in every texel.
bool is_opaque(const Source& source) {
    const auto* const image = std::get_if<ImageSource>(&source);
    return image == nullptr || !image->alpha_is_coverage;
}

/// Whether the layers of a group cover the channel in every texel: some layer does, and none above
/// it clears a part again.
bool covers(const StackTerms& terms, Channel channel) {
    bool covered = false;
    for (const LayerTerms& layer : terms) {
        const auto& contribution = at(layer.channels, channel);
        if (!contribution) continue;
        if (contribution->covers || contribution->mode == BlendMode::Replace)
            covered = contribution->covers;
    }
    return covered;
}

/// Folds what is uniform from the bottom of the mask up. Returns its value where all of it is.
std::optional<float> reduce_mask(const Mask& mask, MaskTerm& term) {
    if (!mask.enabled) return 1.0f;
    term.begin = mask.base;
    term.invert = mask.invert;
    for (const MaskEntry& entry : mask.entries) {
        if (!entry.visible || entry.opacity <= 0.0f) continue;
        const auto* const constant = std::get_if<ConstantSource>(&entry.source);
        if (constant != nullptr && !term.varies()) {
            term.begin = joined_mask_value(term.begin, entry, constant->value.x);
        } else {
            if (entry.combine == MaskCombine::Replace && entry.opacity >= 1.0f)
                term.entries.clear();
            term.entries.push_back(&entry);
        }
    }
    if (term.varies()) return std::nullopt;
    return finished_mask_value(term.begin, mask.invert);
}

void add_contributions(const Layer& layer, float weight, LayerTerms& terms) {
    for (const ChannelInfo& entry : kChannels) {
        const Channel channel = entry.channel;
        const ChannelSettings& settings = at(layer.channels, channel);
        if (!settings.enabled || settings.opacity <= 0.0f) continue;
        Contribution contribution{.source = layer.is_group() ? nullptr : &settings.source,
                                  .mode = effective_blend_mode(layer, channel),
                                  .weight = weight * settings.opacity};
        if (layer.is_group() && layers_of_channel(terms.children, channel).empty()) continue;
        at(terms.channels, channel) = contribution;
    }
}

/// Takes the channels that a group does not pass on from its children.
void keep_channels(StackTerms& terms, ChannelBits kept) {
    for (LayerTerms& layer : terms) {
        for (const ChannelInfo& entry : kChannels)
            if ((kept & channel_bit(entry.channel)) == 0) at(layer.channels, entry.channel).reset();
        keep_channels(layer.children, kept);
    }
    std::erase_if(terms, [](const LayerTerms& layer) { return layer.channel_bits() == 0; });
}

/// The lowest contribution lies on a bottom that is neutral for some modes, or, in a group, on
/// nothing: there its mode is the same as normal.
void simplify_lowest(StackTerms& terms, Channel channel, bool in_group) {
    for (LayerTerms& layer : terms) {
        auto& contribution = at(layer.channels, channel);
        if (!contribution) continue;
        const bool neutral =
            (channel == Channel::Occlusion && contribution->mode == BlendMode::Multiply) ||
            (channel == Channel::Normal && contribution->mode == BlendMode::NormalRnm) ||
            (channel == Channel::Height && contribution->mode == BlendMode::HeightAdd);
        if (neutral || in_group) contribution->mode = BlendMode::Normal;
        return;
    }
}

void find_covering(StackTerms& terms, Channel channel) {
    for (LayerTerms& layer : terms) {
        auto& contribution = at(layer.channels, channel);
        if (!contribution) continue;
        const bool opaque = contribution->source != nullptr ? is_opaque(*contribution->source)
                                                            : covers(layer.children, channel);
        const bool plain =
            contribution->mode == BlendMode::Normal || contribution->mode == BlendMode::Replace;
        contribution->covers =
            plain && contribution->weight >= 1.0f && !layer.mask.varies() && opaque;
    }
}

void drop_covered(StackTerms& terms, Channel channel) {
    bool covered = false;
    for (auto layer = terms.rbegin(); layer != terms.rend(); ++layer) {
        auto& contribution = at(layer->channels, channel);
        if (covered) contribution.reset();
        covered = covered || (contribution && contribution->covers);
    }
}

StackTerms reduced_stack(const std::vector<LayerPtr>& stack, CoveredLayers covered, bool in_group);

std::optional<LayerTerms> reduced_layer(const Layer& layer, CoveredLayers covered) {
    if (!layer.visible) return std::nullopt;
    LayerTerms terms{.layer = &layer};
    const float weight = layer.opacity * reduce_mask(layer.mask, terms.mask).value_or(1.0f);
    if (!(weight > 0.0f)) return std::nullopt;
    if (const auto* const group = std::get_if<GroupContent>(&layer.content))
        terms.children = reduced_stack(group->children, covered, true);
    add_contributions(layer, weight, terms);
    return terms;
}

StackTerms reduced_stack(const std::vector<LayerPtr>& stack, CoveredLayers covered, bool in_group) {
    StackTerms terms;
    for (const LayerPtr& layer : stack)
        if (auto reduced = reduced_layer(*layer, covered)) terms.push_back(std::move(*reduced));
    for (const ChannelInfo& entry : kChannels) {
        simplify_lowest(terms, entry.channel, in_group);
        find_covering(terms, entry.channel);
        if (covered == CoveredLayers::Drop) drop_covered(terms, entry.channel);
    }
    std::erase_if(terms, [](const LayerTerms& layer) { return layer.channel_bits() == 0; });
    for (LayerTerms& layer : terms) keep_channels(layer.children, layer.channel_bits());
    return terms;
}

void add_source(Hasher& hasher, const ConstantSource& source) {
    hasher.add(source.value.x).add(source.value.y).add(source.value.z);
}

void add_transform(Hasher& hasher, const UvTransform& transform) {
    hasher.add(transform.offset.x).add(transform.offset.y);
    hasher.add(transform.scale.x).add(transform.scale.y).add(transform.rotation_degrees);
}

void add_source(Hasher& hasher, const ImageSource& source) {
    hasher.add(source.image).add(source.color_space).add(source.pick);
    hasher.add(source.invert).add(source.directx_normal).add(source.alpha_is_coverage);
    hasher.add(source.uv_set).add(source.wrap_u).add(source.wrap_v).add(source.filter);
    add_transform(hasher, source.transform);
    add_source(hasher, ConstantSource{source.multiply});
    add_source(hasher, ConstantSource{source.add});
}

void add_source(Hasher& hasher, const ProceduralSource& source) {
    hasher.add(source.kind).add(source.seed).add(source.scale).add(source.octaves);
    hasher.add(source.contrast).add(source.balance);
    add_transform(hasher, source.transform);
    hasher.add(source.ramp.size());
    for (const RampStop& stop : source.ramp) {
        hasher.add(stop.position);
        add_source(hasher, ConstantSource{stop.value});
    }
}

void add_mask(Hasher& hasher, const MaskTerm& mask) {
    hasher.add(mask.entries.size());
    if (!mask.varies()) return;
    hasher.add(mask.begin).add(mask.invert);
    for (const MaskEntry* entry : mask.entries) {
        hasher.add(source_hash(entry->source)).add(entry->combine).add(entry->opacity);
        const Levels& levels = entry->levels;
        hasher.add(entry->invert).add(levels.in_low).add(levels.in_high).add(levels.gamma);
        hasher.add(levels.out_low).add(levels.out_high);
    }
}

}  // namespace

ChannelBits LayerTerms::channel_bits() const {
    ChannelBits bits = 0;
    for (const ChannelInfo& entry : kChannels)
        if (at(channels, entry.channel)) bits |= channel_bit(entry.channel);
    return bits;
}

StackTerms stack_terms(const std::vector<LayerPtr>& stack, CoveredLayers covered) {
    return reduced_stack(stack, covered, false);
}

std::vector<const LayerTerms*> layers_of_channel(const StackTerms& terms, Channel channel) {
    std::vector<const LayerTerms*> layers;
    for (const LayerTerms& layer : terms)
        if (at(layer.channels, channel)) layers.push_back(&layer);
    return layers;
}

bool is_uniform(const StackTerms& terms, Channel channel) {
    const auto uniform = [&](const LayerTerms* layer) {
        const Source* const source = at(layer->channels, channel)->source;
        if (layer->mask.varies()) return false;
        return source == nullptr ? is_uniform(layer->children, channel)
                                 : std::holds_alternative<ConstantSource>(*source);
    };
    const auto layers = layers_of_channel(terms, channel);
    return std::all_of(layers.begin(), layers.end(), uniform);
}

Hash128 source_hash(const Source& source) {
    Hasher hasher;
    hasher.add(source.index());
    std::visit([&](const auto& kind) { add_source(hasher, kind); }, source);
    return hasher.finish();
}

Hash128 layer_hash(const LayerTerms& terms, ChannelBits channels) {
    Hasher hasher;
    add_mask(hasher, terms.mask);
    for (const ChannelInfo& entry : kChannels) {
        const auto& contribution = at(terms.channels, entry.channel);
        if (!contribution || (channels & channel_bit(entry.channel)) == 0) continue;
        hasher.add(entry.channel).add(contribution->mode).add(contribution->weight);
        if (is_color(entry.channel)) hasher.add(terms.layer->blend_space);
        if (contribution->source != nullptr) hasher.add(source_hash(*contribution->source));
    }
    for (const LayerTerms& child : terms.children)
        if ((child.channel_bits() & channels) != 0) hasher.add(layer_hash(child, channels));
    return hasher.finish();
}

}  // namespace patina
