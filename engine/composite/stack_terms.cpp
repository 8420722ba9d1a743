// SPDX-License-Identifier: MIT
#include "composite/stack_terms.h"

#include <algorithm>

#include "composite/surface_sources.h"
#include "composite/uniform_values.h"
#include "core/formulae/formulae.h"

namespace patina {
namespace {

/// Whether the source has a value of full weight in every texel.
bool is_opaque(const Source& source) {
    if (std::holds_alternative<ReferenceSource>(source)) return false;
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

/// What the entry's source or adjustment gives, where that is the same in every texel. `below`:
/// what the entries before it come to.
std::optional<float> uniform_value(const MaskEntry& entry, const MaskTerm& below,
                                   const UvSurface* surface) {
    if (below.varies()) return std::nullopt;
    if (entry.adjustment) return adjusted_mask_value(*entry.adjustment, below.begin);
    const auto* const constant =
        std::get_if<ConstantSource>(&resolved_source(entry.source, surface));
    return constant != nullptr ? std::optional(constant->value.x) : std::nullopt;
}

/// Folds what is uniform from the bottom of the mask up: the first entry that is left is no
/// adjustment. Returns its value where all of it is.
std::optional<float> reduce_mask(const Mask& mask, const UvSurface* surface, MaskTerm& term) {
    if (!mask.enabled) return 1.0f;
    term.begin = mask.base;
    term.invert = mask.invert;
    for (const MaskEntry& entry : mask.entries) {
        if (!entry.visible || entry.opacity <= 0.0f) continue;
        if (const auto value = uniform_value(entry, term, surface)) {
            term.begin = joined_mask_value(term.begin, entry, *value);
        } else {
            const bool covers = entry.combine == BlendMode::Replace && entry.opacity >= 1.0f;
            if (covers && !entry.adjustment) term.entries.clear();
            term.entries.push_back(&entry);
        }
    }
    if (term.varies()) return std::nullopt;
    return formulae::finished_mask(term.begin, mask.invert);
}

void add_contributions(const Layer& layer, float weight, const UvSurface* surface,
                       LayerTerms& terms) {
    for (const ChannelInfo& entry : kChannels) {
        const Channel channel = entry.channel;
        const ChannelSettings& settings = at(layer.channels, channel);
        if (!settings.enabled || settings.opacity <= 0.0f) continue;
        Contribution contribution{.mode = effective_blend_mode(layer, channel),
                                  .weight = weight * settings.opacity};
        if (const auto* const content = std::get_if<AdjustmentContent>(&layer.content))
            contribution.adjustment = &content->adjustment;
        else if (!layer.is_group())
            contribution.source = &resolved_source(settings.source, surface);
        // What a group passes through takes the place of what it started from.
        if (terms.pass_through) contribution.mode = BlendMode::Replace;
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

/// What the lowest layer of a stack lies on.
enum class Below { Bottom, Nothing, Backdrop };

/// The lowest contribution lies on a bottom that is neutral for some modes, or, in a group, on
/// nothing: there its mode is the same as normal, and there is nothing to adjust.
void simplify_lowest(StackTerms& terms, Channel channel, Below below) {
    if (below == Below::Backdrop) return;
    for (LayerTerms& layer : terms) {
        auto& contribution = at(layer.channels, channel);
        if (!contribution) continue;
        if (contribution->adjustment != nullptr && below == Below::Nothing) {
            contribution.reset();
            continue;
        }
        // What passes through mixes with what it started from.
        if (contribution->adjustment != nullptr || layer.pass_through) return;
        const bool neutral =
            (channel == Channel::Occlusion && contribution->mode == BlendMode::Multiply) ||
            (channel == Channel::Normal && contribution->mode == BlendMode::NormalRnm) ||
            (channel == Channel::Height && contribution->mode == BlendMode::HeightAdd);
        if (neutral || below == Below::Nothing) contribution->mode = BlendMode::Normal;
        return;
    }
}

void find_covering(StackTerms& terms, Channel channel) {
    for (LayerTerms& layer : terms) {
        auto& contribution = at(layer.channels, channel);
        if (!contribution) continue;
        if (contribution->adjustment != nullptr) continue;
        const bool opaque = contribution->source != nullptr ? is_opaque(*contribution->source)
                                                            : covers(layer.children, channel);
        const bool plain =
            contribution->mode == BlendMode::Normal || contribution->mode == BlendMode::Replace;
        contribution->covers = plain && contribution->weight >= 1.0f && !layer.has_mask() && opaque;
    }
}

/// Whether heights below decide what is seen of the layer or of one that it passes them through to.
bool reads_height_below(const LayerTerms& layer) {
    return layer.reads_heights ||
           (layer.pass_through &&
            std::any_of(layer.children.begin(), layer.children.end(), reads_height_below));
}

void drop_covered(StackTerms& terms, Channel channel) {
    bool covered = false;
    for (auto layer = terms.rbegin(); layer != terms.rend(); ++layer) {
        auto& contribution = at(layer->channels, channel);
        if (covered) contribution.reset();
        covered = covered || (contribution && contribution->covers);
        if (channel == Channel::Height && reads_height_below(*layer)) covered = false;
    }
}

/// How a stack is reduced: what does not change on the way down into groups.
struct Reduction {
    CoveredLayers covered;
    ReferredLayers& referred;
};
StackTerms reduced_stack(const std::vector<LayerPtr>& stack, const Reduction& how, Below below);

/// What the layer covers, as far as it is the same in every texel; the rest goes into `mask`.
float uniform_weight(const Layer& layer, const UvSurface* surface, MaskTerm& mask) {
    if (!layer.visible) return 0.0f;
    return layer.opacity * reduce_mask(layer.mask, surface, mask).value_or(1.0f);
}

/// Whether a group that passes through does no more than its children would in its place.
bool is_transparent(const LayerTerms& terms, float weight) {
    const auto& channels = terms.layer->channels;
    return terms.pass_through && weight >= 1.0f && !terms.has_mask() &&
           !terms.layer->height_blend.enabled &&
           std::all_of(channels.begin(), channels.end(), [](const ChannelSettings& settings) {
               return settings.enabled && settings.opacity >= 1.0f;
           });
}

/// Whether the source is made of the heights below the layer, be it by what it refers to.
bool reads_heights(const Source& source, ReferredLayers& referred) {
    if (const auto* const reference = std::get_if<ReferenceSource>(&source)) {
        const LayerTerms* const terms = referred.find(*reference);
        return terms != nullptr && terms->reads_heights;
    }
    return std::holds_alternative<ReliefSource>(source);
}

/// Whether the mask or a source of the layer is made of the heights below it.
bool reads_heights(const LayerTerms& terms, ReferredLayers& referred) {
    const auto in_mask = [&](const MaskTerm& mask) {
        return std::any_of(mask.entries.begin(), mask.entries.end(), [&](const MaskEntry* entry) {
            return reads_heights(entry->source, referred);
        });
    };
    const auto in_channel = [&](const std::optional<Contribution>& contribution) {
        return contribution && contribution->source &&
               reads_heights(*contribution->source, referred);
    };
    return in_mask(terms.mask) || in_mask(terms.clip) ||
           (terms.clip_content != nullptr && terms.clip_content->reads_heights) ||
           std::any_of(terms.channels.begin(), terms.channels.end(), in_channel);
}

/// Adds the terms of a layer, if it can change anything. `base`: what it is clipped to, or null.
void add_reduced(const Layer& layer, const Layer* base, const Reduction& how, Below below,
                 StackTerms& stack) {
    LayerTerms terms{.layer = &layer};
    const UvSurface* const surface = how.referred.surface();
    float weight = uniform_weight(layer, surface, terms.mask);
    if (base != nullptr) {
        weight *= uniform_weight(*base, surface, terms.clip);
        const ReferredLayers::Content& content = how.referred.content_of(*base);
        if (content.is_nothing) return;
        if (content.terms) terms.clip_content = &*content.terms;
    }
    if (!(weight > 0.0f)) return;
    terms.pass_through = layer.is_pass_through();
    if (const auto* const group = std::get_if<GroupContent>(&layer.content)) {
        const bool whole = is_transparent(terms, weight);
        const bool on_backdrop = below != Below::Nothing || !stack.empty();
        const Below inside = terms.pass_through && on_backdrop ? Below::Backdrop : Below::Nothing;
        terms.children = reduced_stack(group->children, how, inside);
        if (whole) {
            for (LayerTerms& child : terms.children) stack.push_back(std::move(child));
            return;
        }
    }
    add_contributions(layer, weight, surface, terms);
    if (layer.height_blend.enabled) {
        terms.height_blend = &layer.height_blend;
        const ChannelSettings& height = at(layer.channels, Channel::Height);
        const bool own = height.enabled && std::holds_alternative<FillContent>(layer.content);
        if (own) terms.height = &height.source;
    }
    terms.reads_heights = terms.height_blend != nullptr || reads_heights(terms, how.referred);
    stack.push_back(std::move(terms));
}

/// What the terms of the layers of one stack say of each other.
StackTerms simplified(StackTerms terms, Below below, CoveredLayers covered) {
    for (const ChannelInfo& entry : kChannels) {
        simplify_lowest(terms, entry.channel, below);
        find_covering(terms, entry.channel);
        if (covered == CoveredLayers::Drop) drop_covered(terms, entry.channel);
    }
    std::erase_if(terms, [](const LayerTerms& layer) { return layer.channel_bits() == 0; });
    for (LayerTerms& layer : terms) keep_channels(layer.children, layer.run_bits());
    return terms;
}

StackTerms reduced_stack(const std::vector<LayerPtr>& stack, const Reduction& how, Below below) {
    StackTerms terms;
    const Layer* base = nullptr;
    for (const LayerPtr& layer : stack) {
        add_reduced(*layer, layer->clipped ? base : nullptr, how, below, terms);
        if (!layer->clipped) base = layer.get();
    }
    return simplified(std::move(terms), below, how.covered);
}

/// A layer and what it is clipped to, or nulls.
struct Place {
    const Layer* layer = nullptr;
    const Layer* base = nullptr;
};

Place place_of(const std::vector<LayerPtr>& stack, LayerId id) {
    const Layer* base = nullptr;
    for (const LayerPtr& layer : stack) {
        if (layer->id == id) return {layer.get(), layer->clipped ? base : nullptr};
        if (!layer->clipped) base = layer.get();
        if (const auto* group = std::get_if<GroupContent>(&layer->content))
            if (const Place place = place_of(group->children, id); place.layer != nullptr)
                return place;
    }
    return {};
}

/// The layer with nothing but what is read of it, by itself: shown, and passing nothing through. A
/// mask is what a fill with that mask covers.
LayerPtr as_read(const Layer& layer, LayerResult result) {
    Layer copy = layer;
    copy.visible = true;
    if (copy.is_pass_through()) copy.mode = BlendMode::Normal;
    if (result == LayerResult::Mask) {
        copy.height_blend.enabled = layer.height_blend.enabled && !layer.is_group();
        copy.content = FillContent{};
        copy.channels = default_channels();
        at(copy.channels, Channel::Opacity).enabled = true;
    } else {
        for (const ChannelInfo& entry : kChannels)
            if (result_of(entry.channel) != result)
                at(copy.channels, entry.channel).enabled = false;
    }
    return std::make_shared<const Layer>(std::move(copy));
}

/// The layer with nothing but its content.
LayerPtr content_alone(const Layer& layer) {
    Layer copy = layer;
    copy.visible = true;
    copy.opacity = 1.0f;
    copy.mask = {};
    copy.height_blend.enabled = false;
    if (copy.is_pass_through()) copy.mode = BlendMode::Normal;
    for (ChannelSettings& settings : copy.channels)
        if (settings.opacity > 0.0f) settings.opacity = 1.0f;
    return std::make_shared<const Layer>(std::move(copy));
}

/// Whether the layer gives the channel a value, and does not only adjust one.
bool lays_on(const LayerTerms& layer, Channel channel) {
    const auto& contribution = at(layer.channels, channel);
    if (!contribution || contribution->adjustment != nullptr) return false;
    return contribution->source != nullptr ||
           std::any_of(layer.children.begin(), layer.children.end(),
                       [&](const LayerTerms& child) { return lays_on(child, channel); });
}

/// Leaves one channel of a layer.
void keep_channel(LayerTerms& terms, Channel channel) {
    for (const ChannelInfo& entry : kChannels)
        if (entry.channel != channel) at(terms.channels, entry.channel).reset();
    keep_channels(terms.children, terms.run_bits());
}

}  // namespace

ChannelBits LayerTerms::channel_bits() const {
    ChannelBits bits = 0;
    for (const ChannelInfo& entry : kChannels)
        if (at(channels, entry.channel)) bits |= channel_bit(entry.channel);
    return bits;
}

ChannelBits LayerTerms::with_heights(ChannelBits wanted) const {
    const bool heights = reads_heights || (led_by_height(children) & wanted) != 0;
    return heights ? wanted | channel_bit(Channel::Height) : wanted;
}

ChannelBits led_by_height(const StackTerms& terms) {
    ChannelBits bits = 0;
    for (const LayerTerms& layer : terms)
        bits |= layer.reads_heights ? layer.channel_bits() : led_by_height(layer.children);
    return bits;
}

StackTerms stack_terms(const std::vector<LayerPtr>& stack, CoveredLayers covered,
                       ReferredLayers& referred) {
    return reduced_stack(stack, {covered, referred}, Below::Bottom);
}

const LayerTerms* ReferredLayers::find(const ReferenceSource& reference) {
    const auto [place, is_new] = found_.try_emplace({reference.layer, reference.result});
    Found& found = place->second;
    if (is_new) {
        const Place of = place_of(stack_, reference.layer);
        if (of.layer == nullptr) return nullptr;
        found.plain = as_read(*of.layer, reference.result);
        StackTerms terms;
        add_reduced(*found.plain, of.base, {CoveredLayers::Drop, *this}, Below::Nothing, terms);
        terms = simplified(std::move(terms), Below::Nothing, CoveredLayers::Drop);
        if (terms.empty()) return nullptr;
        // Its height decides, be it read or not.
        const ChannelSettings& height = at(of.layer->channels, Channel::Height);
        if (terms.front().height_blend != nullptr && height.enabled && !of.layer->is_group())
            terms.front().height = &height.source;
        found.terms = std::move(terms.front());
    }
    return found.terms ? &*found.terms : nullptr;
}

const ReferredLayers::Content& ReferredLayers::content_of(const Layer& layer) {
    const auto [place, is_new] = contents_.try_emplace(&layer);
    Content& content = place->second;
    // What an adjustment covers is what lies below it.
    if (!is_new || layer.is_adjustment()) return content;
    content.plain = content_alone(layer);
    StackTerms terms;
    add_reduced(*content.plain, nullptr, {CoveredLayers::Drop, *this}, Below::Nothing, terms);
    terms = simplified(std::move(terms), Below::Nothing, CoveredLayers::Drop);
    const auto first =
        std::find_if(kChannels.begin(), kChannels.end(), [&](const ChannelInfo& entry) {
            return !terms.empty() && lays_on(terms.front(), entry.channel);
        });
    content.is_nothing = first == kChannels.end() && layer.is_group();
    // A fill of no channel is there for its mask.
    if (first == kChannels.end() || at(terms.front().channels, first->channel)->covers)
        return content;
    keep_channel(terms.front(), first->channel);
    content.terms = std::move(terms.front());
    return content;
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
        if (layer->has_mask()) return false;
        if (at(layer->channels, channel)->adjustment != nullptr) return true;
        return source == nullptr ? is_uniform(layer->children, channel)
                                 : std::holds_alternative<ConstantSource>(*source);
    };
    const auto layers = layers_of_channel(terms, channel);
    return std::all_of(layers.begin(), layers.end(), uniform);
}

}  // namespace patina
