// SPDX-License-Identifier: MIT
#include "composite/stack_hash.h"

#include "composite/surface_sources.h"
#include "document/worn_surface.h"

namespace patina {
namespace {

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

void add_ramp(Hasher& hasher, const std::vector<RampStop>& ramp) {
    hasher.add(ramp.size());
    for (const RampStop& stop : ramp) {
        hasher.add(stop.position);
        add_source(hasher, ConstantSource{stop.value});
    }
}

void add_source(Hasher& hasher, const ProceduralSource& source) {
    hasher.add(pattern_hash(source)).add(source.contrast).add(source.balance);
    add_ramp(hasher, source.ramp);
}

void add_source(Hasher& hasher, const ReliefSource& source) {
    hasher.add(source.kind).add(source.radius_permille).add(source.strength);
}

void add_source(Hasher& hasher, const GeometrySource& source) {
    for (const auto* names : {&source.meshes, &source.materials}) {
        hasher.add(names->size());
        for (const std::string& name : *names) hasher.add(name);
    }
}

void add_levels(Hasher& hasher, const Levels& levels) {
    hasher.add(levels.in_low).add(levels.in_high).add(levels.gamma);
    hasher.add(levels.out_low).add(levels.out_high);
}

void add_adjustment(Hasher& hasher, const AdjustmentSettings& adjustment) {
    hasher.add(adjustment.kind);
    add_levels(hasher, adjustment.levels);
    hasher.add(adjustment.curve.size());
    for (const CurvePoint& point : adjustment.curve) hasher.add(point.x).add(point.y);
    hasher.add(adjustment.hue_degrees).add(adjustment.saturation).add(adjustment.lightness);
    hasher.add(adjustment.brightness).add(adjustment.contrast).add(adjustment.steps);
    add_ramp(hasher, adjustment.gradient);
    hasher.add(adjustment.low).add(adjustment.high);
    hasher.add(adjustment.radius_permille).add(adjustment.amount);
    hasher.add(adjustment.distance_permille).add(adjustment.scale);
    hasher.add(adjustment.octaves).add(adjustment.seed);
}

/// What a source reads of the model decides what it gives; where none is at hand, it reads nothing.
void add_surface(Hasher& hasher, const Source& source, const UvSurface* surface) {
    if (surface == nullptr) return;
    if (const auto* const geometry = std::get_if<GeometrySource>(&source)) {
        hasher.add(surface->hash());
        for (const std::uint8_t chosen : chosen_parts(*geometry, *surface)) hasher.add(chosen);
    }
    if (const auto projection = projection_of(source))
        hasher.add(surface->hash())
            .add(projection->kind)
            .add(projection->axis)
            .add(projection->blend);
}

Hash128 source_hash(const Source& given, ReferredLayers& referred) {
    const Source& source = resolved_source(given, referred.surface());
    Hasher hasher;
    add_surface(hasher, source, referred.surface());
    hasher.add(source.index());
    std::visit(
        [&](const auto& kind) {
            if constexpr (!std::is_same_v<std::decay_t<decltype(kind)>, ReferenceSource>)
                add_source(hasher, kind);
            else if (const LayerTerms* const terms = referred.find(kind))
                hasher.add(kind.result).add(layer_hash(*terms, kAllChannels, referred));
        },
        source);
    return hasher.finish();
}

void add_mask(Hasher& hasher, const MaskTerm& mask, ReferredLayers& referred) {
    hasher.add(mask.entries.size());
    if (!mask.varies()) return;
    hasher.add(mask.begin).add(mask.invert);
    for (const MaskEntry* entry : mask.entries) {
        hasher.add(entry->combine).add(entry->opacity).add(entry->invert);
        hasher.add(entry->adjustment.has_value());
        if (entry->adjustment) {
            add_adjustment(hasher, *entry->adjustment);
        } else {
            hasher.add(source_hash(entry->source, referred));
            add_levels(hasher, entry->levels);
        }
    }
}

}  // namespace

Hash128 pattern_hash(const ProceduralSource& source) {
    Hasher hasher;
    hasher.add(source.kind).add(source.seed).add(source.scale).add(source.octaves);
    hasher.add(source.width).add(source.softness).add(source.variation);
    hasher.add(source.aspect).add(source.warp);
    add_transform(hasher, source.transform);
    return hasher.finish();
}

Hash128 layer_hash(const LayerTerms& terms, ChannelBits channels, ReferredLayers& referred) {
    Hasher hasher;
    add_mask(hasher, terms.mask, referred);
    add_mask(hasher, terms.clip, referred);
    if (terms.clip_content != nullptr)
        hasher.add(layer_hash(*terms.clip_content, kAllChannels, referred));
    hasher.add(terms.pass_through).add(terms.height_blend != nullptr);
    if (terms.height_blend != nullptr) {
        const HeightBlend& blend = *terms.height_blend;
        hasher.add(blend.offset).add(blend.radius).add(blend.contrast);
        hasher.add(terms.height != nullptr ? source_hash(*terms.height, referred) : Hash128{});
    }
    for (const ChannelInfo& entry : kChannels) {
        const auto& contribution = at(terms.channels, entry.channel);
        if (!contribution || (channels & channel_bit(entry.channel)) == 0) continue;
        hasher.add(entry.channel).add(contribution->mode).add(contribution->weight);
        if (is_color(entry.channel)) hasher.add(terms.layer->blend_space);
        if (contribution->source != nullptr)
            hasher.add(source_hash(*contribution->source, referred));
        if (contribution->adjustment != nullptr) add_adjustment(hasher, *contribution->adjustment);
    }
    const ChannelBits inside = terms.with_heights(channels);
    for (const LayerTerms& child : terms.children)
        if ((child.channel_bits() & inside) != 0) hasher.add(layer_hash(child, inside, referred));
    return hasher.finish();
}

}  // namespace patina
