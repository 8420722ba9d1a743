// SPDX-License-Identifier: MIT
#include "composite/compile.h"

#include <algorithm>
#include <map>
#include <utility>

#include "composite/bake_rules.h"
#include "composite/source_record.h"
#include "composite/stack_hash.h"
#include "composite/surface_sources.h"
#include "composite/uniform_values.h"
#include "document/worn_surface.h"

namespace patina {
namespace {

constexpr ChannelBits kColorChannels =
    channel_bit(Channel::BaseColor) | channel_bit(Channel::Emissive);

/// What is known, while operations are emitted, of the accumulators of one stack.
struct StackState {
    ChannelBits encoded = 0;
    ChannelBits touched = 0;
    ChannelBits opaque = 0;     ///< channels that are covered in every texel
    bool has_backdrop = false;  ///< of a group: it started from what lies below it
    Hash128 hash;

    /// Whether there is something of the channel that its space and coverage matter for.
    bool holds(ChannelBits bit) const { return has_backdrop || (touched & bit) != 0; }
};

class Emitter {
  public:
    Emitter(ProgramData& program, ReferredLayers& referred, UvSurfacePtr surface)
        : program_(program), referred_(referred), surface_(std::move(surface)) {}

    /// `backdrop`: the state of the stack around, for a group that passes it through.
    StackState emit_stack(const StackTerms& terms, int depth, const StackState* backdrop = nullptr);

  private:
    void emit_layer(const LayerTerms& terms, int depth, StackState& state);
    void emit_recoding(const LayerTerms& terms, const Operation& like, StackState& state);
    std::int32_t emit_masks(const LayerTerms& terms, const Operation& like);
    void note_relief(const LayerTerms& terms);
    void note_relief(const Source& source);
    void note_looking_around(const LayerTerms& terms, int depth);
    void emit_height(const LayerTerms& terms, Operation like);
    std::int32_t emit_content(const LayerTerms& content, Operation like);
    /// What is read of a layer by itself; null terms: there is nothing of it.
    struct Referred {
        const LayerTerms* terms = nullptr;
        Channel channel = Channel::Opacity;
        bool of_mask = false;  ///< what is covered of the channel, instead of its value
    };
    std::int32_t emit_reference(const ReferenceSource& source, Reading reading,
                                const Operation& like);
    std::int32_t emit_referred(const Referred& referred, Reading reading, Operation like);
    std::int32_t emit_mask(const MaskTerm& mask, Operation like);
    Operation mask_source(const MaskEntry& entry, Operation like);
    Operation mask_adjustment(const AdjustmentSettings& adjustment, std::int32_t start,
                              Operation like);
    void emit_blend(const Contribution& contribution, Channel channel, Operation like,
                    const StackState& state, const StackState& children);
    /// `like`: the operation that is going to read the source.
    std::int32_t add_source(const Source& source, Reading reading, const Operation& like);
    void read_surface(SourceRecord& record);
    std::int32_t here() const { return static_cast<std::int32_t>(program_.operations.size()); }

    /// Where the heights are that lie below a layer: what is accumulated at a depth before an
    /// operation.
    struct HeightsBelow {
        std::int32_t begin = 0;
        int depth = 0;
        ChannelBits referring = 0;
    };

    ProgramData& program_;
    ReferredLayers& referred_;
    UvSurfacePtr surface_;
    HeightsBelow below_;         ///< the layer that is being emitted
    bool alone_ = false;         ///< the next layer is emitted by itself: `below_` stays as it is
    ChannelBits referring_ = 0;  ///< within a reference: the channels that it is wanted for
    /// Which of ProgramData::around a relief source reads. A layer that is clipped to another goes
    /// by the relief that that one's mask went by.
    std::map<const Source*, std::int32_t> relief_;
};

Reading reading_of(Channel channel, bool encoded) {
    switch (info(channel).kind) {
        case ChannelKind::Color:
            return encoded ? Reading::EncodedColor : Reading::LinearColor;
        case ChannelKind::Normal:
            return Reading::Normal;
        case ChannelKind::Scalar:
            return Reading::Scalar;
        case ChannelKind::Height:
            return Reading::Height;
    }
    return Reading::Scalar;
}

bool is_identity(const Levels& levels) {
    return levels == Levels{};
}

/// Whether the contribution may leave clear what was covered.
bool may_clear(const Contribution& contribution, ChannelBits bit, const StackState& children) {
    if (contribution.mode != BlendMode::Replace || contribution.covers) return false;
    return (children.opaque & bit) == 0;
}

StackState Emitter::emit_stack(const StackTerms& terms, int depth, const StackState* backdrop) {
    StackState state;
    Hasher start;
    start.add(std::string_view(depth == 0 ? "stack" : "group"));
    if (depth == 0) state.opaque = kAllChannels;
    if (backdrop != nullptr) {
        state.encoded = backdrop->encoded;
        state.opaque = backdrop->opaque;
        state.has_backdrop = true;
        start.add(backdrop->hash);
    }
    state.hash = start.finish();
    program_.depths = std::max(program_.depths, depth + 1);
    const std::int32_t begin = here();
    for (const LayerTerms& layer : terms) {
        emit_layer(layer, depth, state);
        // What is referred to is read where it is wanted, and not as a stack.
        if (referring_ != 0) continue;
        state.hash =
            Hasher().add(state.hash).add(layer_hash(layer, kAllChannels, referred_)).finish();
        program_.checkpoints.push_back({.begin = begin,
                                        .end = here(),
                                        .depth = static_cast<std::uint8_t>(depth),
                                        .encoded = state.encoded,
                                        .touched = state.touched,
                                        .hash = state.hash});
    }
    return state;
}

void Emitter::emit_layer(const LayerTerms& terms, int depth, StackState& state) {
    StackState children;
    const HeightsBelow outer = below_;
    if (!std::exchange(alone_, false)) below_ = {here(), depth, referring_};
    Operation like{.depth = static_cast<std::uint8_t>(depth), .channels = terms.channel_bits()};
    if (referring_ != 0) like.flags |= kReferred;
    like.layer = static_cast<std::int32_t>(program_.layers.size());
    program_.layers.push_back({terms.layer->id, terms.layer->name, depth});
    if (terms.reads_heights) note_relief(terms);
    emit_recoding(terms, like, state);
    const std::int32_t last_entry = emit_masks(terms, like);
    if (terms.has_mask()) like.flags |= kUsesMask;
    if (!terms.children.empty()) {
        Operation begin = like;
        begin.code = terms.pass_through ? OpCode::GroupCopy : OpCode::GroupBegin;
        begin.channels = terms.run_bits();
        program_.operations.push_back(begin);
        children = emit_stack(terms.children, depth + 1, terms.pass_through ? &state : nullptr);
    }
    if (terms.height_blend != nullptr) emit_height(terms, like);
    note_looking_around(terms, depth);
    const auto lay_on = [&](Channel channel) {
        const auto& contribution = at(terms.channels, channel);
        if (!contribution) return;
        const ChannelBits bit = channel_bit(channel);
        if (contribution->covers) state.opaque |= bit;
        if (may_clear(*contribution, bit, children)) state.opaque &= static_cast<ChannelBits>(~bit);
        emit_blend(*contribution, channel, like, state, children);
        state.touched |= bit;
    };
    for (const ChannelInfo& entry : kChannels)
        if (entry.channel != Channel::Height) lay_on(entry.channel);
    // Last, since others may go by the heights below.
    lay_on(Channel::Height);
    if (last_entry >= 0) program_.operations[static_cast<std::size_t>(last_entry)].jump = here();
    below_ = outer;
}

/// Brings the colours that the layer blends (a group that passes through is faded in in its own
/// space, too) into the space in which it blends them. Where nothing
/// is accumulated yet, the space is only noted.
void Emitter::emit_recoding(const LayerTerms& terms, const Operation& like, StackState& state) {
    const bool encoded = terms.layer->blend_space == BlendSpace::SrgbEncoded;
    for (const Channel channel : {Channel::BaseColor, Channel::Emissive}) {
        const auto& contribution = at(terms.channels, channel);
        const ChannelBits bit = channel_bit(channel);
        if (!contribution || ((state.encoded & bit) != 0) == encoded) continue;
        state.encoded ^= bit;
        if (!state.holds(bit) || contribution->covers) continue;
        Operation recoding = like;
        recoding.code = encoded ? OpCode::ToEncoded : OpCode::ToLinear;
        recoding.channel = channel;
        recoding.channels = bit;
        program_.operations.push_back(recoding);
    }
}

/// The mask of the layer times that of what it is clipped to and what the content there covers; 1
/// where there is none and heights make one. Returns what emit_mask does, of the last one; -1 where
/// there is none.
std::int32_t Emitter::emit_masks(const LayerTerms& terms, const Operation& like) {
    std::int32_t end = -1;
    const auto join = [&](const auto& emit) {
        const bool first = end < 0;
        Operation step = like;
        if (!first) {
            // Past it: a mask alone is nothing to leave out.
            program_.operations[static_cast<std::size_t>(end)].jump = end + 1;
            step.code = OpCode::MaskKeep;
            program_.operations.push_back(step);
        }
        end = emit();
        if (first) return;
        step.code = OpCode::MaskClip;
        program_.operations.push_back(step);
    };
    if (terms.clip_content != nullptr)
        join([&] { return emit_content(*terms.clip_content, like); });
    if (terms.clip.varies()) join([&] { return emit_mask(terms.clip, like); });
    if (terms.mask.varies()) join([&] { return emit_mask(terms.mask, like); });
    if (end < 0 && terms.height_blend != nullptr) {
        Operation begin = like;
        begin.code = OpCode::MaskBegin;
        program_.operations.push_back(begin);
    }
    return end;
}

/// What a layer's content covers of its one channel, as a mask of one entry.
std::int32_t Emitter::emit_content(const LayerTerms& content, Operation like) {
    const auto covered = std::find_if(kChannels.begin(), kChannels.end(), [&](const auto& entry) {
        return at(content.channels, entry.channel).has_value();
    });
    SourceRecord record = source_record(ReferenceSource{}, Reading::Scalar);
    record.reference = emit_referred(
        {.terms = &content, .channel = covered->channel, .of_mask = true}, Reading::Scalar, like);
    program_.sources.push_back(std::move(record));
    like.code = OpCode::MaskEntry;
    like.mode = BlendMode::Replace;
    like.amount = 1.0f;
    like.flags |= kFirst | kLast;
    like.source = static_cast<std::int32_t>(program_.sources.size()) - 1;
    program_.operations.push_back(like);
    return here() - 1;
}

void Emitter::note_relief(const Source& source) {
    const auto* const relief = std::get_if<ReliefSource>(&source);
    if (relief == nullptr) return;
    relief_[&source] = static_cast<std::int32_t>(program_.around.size());
    program_.around.push_back({.begin = below_.begin,
                               .relief = true,
                               .adjustment = static_cast<std::int32_t>(program_.adjustments.size()),
                               .depth = static_cast<std::uint8_t>(below_.depth),
                               .channels = channel_bit(Channel::Height),
                               .referring = below_.referring});
    program_.adjustments.push_back(
        {.kind = AdjustmentKind::Blur, .radius_permille = relief->radius_permille});
}

/// Notes the sources of a layer that read the relief below it, before any of its operations.
void Emitter::note_relief(const LayerTerms& terms) {
    for (const MaskEntry* entry : terms.mask.entries) note_relief(entry->source);
    for (const MaskEntry* entry : terms.clip.entries)
        if (!relief_.contains(&entry->source)) note_relief(entry->source);
    for (const auto& contribution : terms.channels)
        if (contribution && contribution->source) note_relief(*contribution->source);
}

/// Notes a layer whose operations, which follow, look around.
void Emitter::note_looking_around(const LayerTerms& terms, int depth) {
    const auto* const content = std::get_if<AdjustmentContent>(&terms.layer->content);
    if (content == nullptr || !looks_around(content->adjustment.kind)) return;
    program_.around.push_back({.begin = here(),
                               .adjustment = static_cast<std::int32_t>(program_.adjustments.size()),
                               .depth = static_cast<std::uint8_t>(depth),
                               .channels = terms.channel_bits(),
                               .referring = referring_});
}

/// Before anything of the layer is laid on, its heights included.
void Emitter::emit_height(const LayerTerms& terms, Operation like) {
    HeightBlendRecord record{.blend = *terms.height_blend,
                             .of_children = !terms.children.empty(),
                             .below = static_cast<std::uint8_t>(below_.depth)};
    if (terms.height != nullptr) record.source = add_source(*terms.height, Reading::Height, like);
    like.code = OpCode::MaskHeight;
    like.source = static_cast<std::int32_t>(program_.height_blends.size());
    program_.height_blends.push_back(record);
    program_.operations.push_back(like);
}

/// Returns the index of the last entry, whose jump is set when the layer is complete.
std::int32_t Emitter::emit_mask(const MaskTerm& mask, Operation like) {
    const std::int32_t start = here();
    const MaskEntry& lowest = *mask.entries.front();
    const bool whole = lowest.opacity >= 1.0f;
    const bool first = whole && (lowest.combine == BlendMode::Replace ||
                                 (lowest.combine == BlendMode::Multiply && mask.begin == 1.0f));
    if (!first) {
        Operation begin = like;
        begin.code = OpCode::MaskBegin;
        begin.amount = mask.begin;
        program_.operations.push_back(begin);
    }
    for (const MaskEntry* entry : mask.entries) {
        Operation join = entry->adjustment ? mask_adjustment(*entry->adjustment, start, like)
                                           : mask_source(*entry, like);
        join.mode = entry->combine;
        join.amount = entry->opacity;
        if (entry->invert) join.flags |= kInvert;
        if (first && entry == &lowest) join.flags |= kFirst;
        if (entry == mask.entries.back()) {
            join.flags |= kLast;
            if (mask.invert) join.flags |= kInvertMask;
        }
        program_.operations.push_back(join);
    }
    return here() - 1;
}

/// Notes what the operation that follows, an entry of a mask, reads.
Operation Emitter::mask_source(const MaskEntry& entry, Operation like) {
    const std::int32_t source = add_source(entry.source, Reading::Scalar, like);
    like.code = OpCode::MaskEntry;
    like.source = source;
    if (is_identity(entry.levels)) return like;
    program_.sources.back().levels = static_cast<std::int32_t>(program_.levels.size());
    program_.levels.push_back(entry.levels);
    return like;
}

/// The same of an entry that is an adjustment. `start`: the first operation of the mask.
Operation Emitter::mask_adjustment(const AdjustmentSettings& adjustment, std::int32_t start,
                                   Operation like) {
    like.code = OpCode::MaskAdjust;
    like.source = static_cast<std::int32_t>(program_.adjustments.size());
    program_.adjustments.push_back(adjustment);
    if (!looks_around(adjustment.kind)) return like;
    like.around = static_cast<std::int32_t>(program_.around.size());
    program_.around.push_back({.start = start,
                               .begin = here(),
                               .last = here(),
                               .of_mask = true,
                               .adjustment = like.source,
                               .depth = like.depth,
                               .channels = like.channels,
                               .referring = referring_});
    return like;
}

void Emitter::emit_blend(const Contribution& contribution, Channel channel, Operation like,
                         const StackState& state, const StackState& children) {
    const ChannelBits bit = channel_bit(channel);
    const bool encoded = (state.encoded & bit) != 0;
    like.channel = channel;
    like.channels = bit;
    like.mode = contribution.mode;
    like.amount = contribution.weight;
    if (encoded) like.flags |= kEncoded;
    if (contribution.covers || (like.depth > 0 && !state.holds(bit)))
        like.flags |= kFirst;
    else if (like.depth > 0 && (state.opaque & bit) != 0)
        like.flags |= kOpaque;
    if (contribution.adjustment != nullptr) {
        like.code = OpCode::Adjust;
        like.source = static_cast<std::int32_t>(program_.adjustments.size());
        const bool around = looks_around(contribution.adjustment->kind);
        if (around) program_.around.back().last = here();
        if (around) like.around = static_cast<std::int32_t>(program_.around.size()) - 1;
        program_.adjustments.push_back(*contribution.adjustment);
    } else if (contribution.source != nullptr) {
        like.code = OpCode::Blend;
        like.source = add_source(*contribution.source, reading_of(channel, encoded), like);
    } else {
        like.code = OpCode::BlendGroup;
        if ((children.encoded & bit) != 0) like.flags |= kChildEncoded;
    }
    program_.operations.push_back(like);
}

std::int32_t Emitter::emit_reference(const ReferenceSource& source, Reading reading,
                                     const Operation& like) {
    return emit_referred({.terms = referred_.find(source),
                          .channel = channel_of(source.result).value_or(Channel::Opacity),
                          .of_mask = source.result == LayerResult::Mask},
                         reading, like);
}

/// Emits a layer by itself at the next depth, where what reads it finds it.
std::int32_t Emitter::emit_referred(const Referred& referred, Reading reading, Operation like) {
    const LayerTerms* const terms = referred.terms;
    const Channel channel = referred.channel;
    const auto index = static_cast<std::int32_t>(program_.references.size());
    const int depth = like.depth + 1;
    program_.references.push_back(
        {.channel = channel,
         .of_mask = referred.of_mask,
         .needed = terms != nullptr ? terms->run_bits() : channel_bit(channel)});
    program_.depths = std::max(program_.depths, depth + 1);
    like.code = OpCode::Reference;
    like.source = index;
    const auto begin = static_cast<std::size_t>(here());
    program_.operations.push_back(like);
    if (terms != nullptr) {
        const ChannelBits outer = referring_;
        if (outer == 0) referring_ = like.channels;
        // What it is clipped to reads the heights that it reads itself.
        auto relief = std::exchange(relief_, {});
        StackState state;
        alone_ = true;
        emit_layer(*terms, depth, state);
        const bool encoded = (state.encoded & channel_bit(channel)) != 0;
        if (is_color(channel) && encoded != (reading == Reading::EncodedColor))
            program_.operations.push_back({.code = encoded ? OpCode::ToLinear : OpCode::ToEncoded,
                                           .depth = static_cast<std::uint8_t>(depth),
                                           .flags = kReferred,
                                           .channels = channel_bit(channel),
                                           .channel = channel});
        relief_ = std::move(relief);
        referring_ = outer;
    }
    program_.operations[begin].jump = here();
    return index;
}

/// Notes what the source reads of the model.
void Emitter::read_surface(SourceRecord& record) {
    const auto* const geometry = std::get_if<GeometrySource>(&record.source);
    const std::optional<Projection> projection = projection_of(record.source);
    if (geometry == nullptr && !projection) return;
    program_.surface = surface_;
    if (projection) {
        record.projection = *projection;
        record.length_per_uv = surface_->length_per_uv();
    }
    if (geometry != nullptr) {
        record.choice = static_cast<std::int32_t>(program_.chosen_parts.size());
        program_.chosen_parts.push_back(chosen_parts(*geometry, *surface_));
    }
}

std::int32_t Emitter::add_source(const Source& source, Reading reading, const Operation& like) {
    SourceRecord record = source_record(resolved_source(source, surface_.get()), reading);
    if (surface_ != nullptr) read_surface(record);
    if (const auto* const reference = std::get_if<ReferenceSource>(&source))
        record.reference = emit_reference(*reference, reading, like);
    if (const auto* const image = std::get_if<ImageSource>(&source)) {
        const auto found = std::find(program_.images.begin(), program_.images.end(), image->image);
        record.image = static_cast<std::int32_t>(found - program_.images.begin());
        if (found == program_.images.end()) program_.images.push_back(image->image);
    }
    if (const auto relief = relief_.find(&source); relief != relief_.end()) {
        record.around = relief->second;
        program_.around[static_cast<std::size_t>(relief->second)].last = here();
    }
    program_.sources.push_back(std::move(record));
    return static_cast<std::int32_t>(program_.sources.size()) - 1;
}

/// The space in which the lowest layer blends decides in which one the bottom is given.
ChannelBits encoded_at_bottom(const StackTerms& terms) {
    ChannelBits bits = 0;
    for (const Channel channel : {Channel::BaseColor, Channel::Emissive}) {
        const auto layers = layers_of_channel(terms, channel);
        if (!layers.empty() && layers.front()->layer->blend_space == BlendSpace::SrgbEncoded)
            bits |= channel_bit(channel);
    }
    return bits;
}

void set_bottom(const StackTerms& terms, ProgramData& program) {
    program.bottom_encoded = encoded_at_bottom(terms);
    for (const ChannelInfo& entry : kChannels) {
        const bool encoded = (program.bottom_encoded & channel_bit(entry.channel)) != 0;
        const glm::vec3 bottom = stack_bottom(entry.channel);
        at(program.bottom, entry.channel) = encoded ? encoded_color(bottom) : bottom;
    }
}

Hash128 channel_hash(const StackTerms& terms, Channel channel, ReferredLayers& referred) {
    Hasher hasher;
    hasher.add(channel);
    for (const LayerTerms* layer : layers_of_channel(terms, channel))
        hasher.add(layer_hash(*layer, channel_bit(channel), referred));
    const bool led = (led_by_height(terms) & channel_bit(channel)) != 0;
    if (led && channel != Channel::Height)
        hasher.add(channel_hash(terms, Channel::Height, referred));
    return hasher.finish();
}

Hash128 slot_hash(const ProgramData& program, const StackTerms& terms, Slot slot) {
    const auto of = [&](Channel channel) { return at(program.channel_hashes, channel); };
    switch (slot) {
        case Slot::BaseColor:
            return Hasher().add(of(Channel::BaseColor)).add(of(Channel::Opacity)).finish();
        case Slot::MetallicRoughness:
            return Hasher().add(of(Channel::Metalness)).add(of(Channel::Roughness)).finish();
        case Slot::Normal: {
            Hasher hasher;
            hasher.add(of(Channel::Normal));
            if (!is_uniform(terms, Channel::Height))
                hasher.add(of(Channel::Height)).add(program.height_scale);
            return hasher.finish();
        }
        case Slot::Occlusion:
            return of(Channel::Occlusion);
        case Slot::Emissive:
            return of(Channel::Emissive);
    }
    return {};
}

}  // namespace

ProgramData compile_material(const Material& material, const UvSurfacePtr& worn,
                             CoveredLayers covered) {
    const UvSurfacePtr surface = worn != nullptr && worn->has_uvs() ? worn : nullptr;
    ReferredLayers referred(material.stack, surface.get());
    const StackTerms terms = stack_terms(material.stack, covered, referred);
    ProgramData program;
    set_bottom(terms, program);
    program.height_scale = material.height_scale;
    const StackState top = Emitter(program, referred, surface).emit_stack(terms, 0);
    program.top_encoded = top.touched & top.encoded & kColorChannels;
    program.touched = top.touched;
    number_patterns(program);
    program.led_by_height = led_by_height(terms);
    for (const ChannelInfo& entry : kChannels)
        at(program.channel_hashes, entry.channel) = channel_hash(terms, entry.channel, referred);
    for (int slot = 0; slot < kSlotCount; ++slot)
        program.slot_hashes[static_cast<std::size_t>(slot)] =
            slot_hash(program, terms, static_cast<Slot>(slot));
    program.slots = planned_slots(material, terms, program);
    return program;
}

}  // namespace patina
