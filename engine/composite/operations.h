// SPDX-License-Identifier: MIT
#pragma once

/// What a Program consists of: small records in the order in which they run, all plain values, so
/// that a GPU can later walk the same array.
///
/// State that the operations work on, per texel: for each depth of groups an accumulator of the
/// channels (colour and, inside groups, coverage) and one mask. Depth 0 is the opaque bottom of the
/// stack.

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "composite/planes.h"
#include "composite/program.h"
#include "scene/uv_surface.h"

namespace patina {

/// One bit for each channel: `1 << Channel`.
using ChannelBits = std::uint8_t;
constexpr ChannelBits channel_bit(Channel channel) {
    return static_cast<ChannelBits>(1u << static_cast<unsigned>(channel));
}
inline constexpr ChannelBits kAllChannels = 0xff;

constexpr bool is_color(Channel channel) {
    return info(channel).kind == ChannelKind::Color;
}
constexpr int component_count(Channel channel) {
    const ChannelKind kind = info(channel).kind;
    return kind == ChannelKind::Color || kind == ChannelKind::Normal ? 3 : 1;
}

enum class OpCode : std::uint8_t {
    /// The mask of this depth := `amount` everywhere.
    MaskBegin,
    /// Joins one entry (source, mode, amount, levels, flags) to the mask of this depth. The last
    /// one finishes it; where the mask then is 0 in a whole tile, the run goes on at `jump`.
    MaskEntry,
    /// The same of an entry that is what an adjustment makes of the mask of this depth.
    MaskAdjust,
    /// Multiplies the finished mask of this depth by the share that its height gives the layer.
    MaskHeight,
    /// Recodes the accumulated colour of `channel` for the blend space of the layer to come.
    ToEncoded,
    ToLinear,
    /// Keeps the finished mask of this depth, for the next MaskClip.
    MaskKeep,
    /// Multiplies the finished mask of this depth by the kept one.
    MaskClip,
    /// Lays a source on the accumulator of `channel`, by `mode` and weight.
    Blend,
    /// Lays what an adjustment makes of the accumulator of `channel` on it, by `mode` and weight.
    Adjust,
    /// Clears the accumulators of the next depth, where the children of the group follow.
    GroupBegin,
    /// Copies the accumulators to the next depth, where the children of a group that passes them
    /// through follow.
    GroupCopy,
    /// Lays what the next depth accumulated on the accumulator of `channel`.
    BlendGroup,
    /// Runs the operations up to `jump`, of a layer that is referred to, at the next depth, with
    /// the channels of its ReferenceRecord wanted; an operation that follows reads what they leave.
    Reference,
};

/// Bits of Operation::flags.
using OperationFlags = std::uint16_t;
/// The weight is scaled by the mask of this depth.
inline constexpr OperationFlags kUsesMask = 1;
/// MaskEntry: nothing lies below; the entry is the mask. Blend: the source replaces the
/// accumulator; its coverage is the weight.
inline constexpr OperationFlags kFirst = 2;
/// MaskEntry: 1 less the entry.
inline constexpr OperationFlags kInvert = 4;
/// Colours are sRGB-encoded while this blends.
inline constexpr OperationFlags kEncoded = 8;
/// BlendGroup: the colour that the group accumulated is sRGB-encoded.
inline constexpr OperationFlags kChildEncoded = 16;
/// Of a layer that is referred to: no step of the stack that `explain` shows.
inline constexpr OperationFlags kReferred = 32;
/// MaskEntry: the mask is complete.
inline constexpr OperationFlags kLast = 64;
/// MaskEntry that is the last: 1 less the mask.
inline constexpr OperationFlags kInvertMask = 128;
/// Inside a group: the accumulator is covered in every texel, and stays so.
inline constexpr OperationFlags kOpaque = 256;

struct Operation {
    OpCode code = OpCode::Blend;
    std::uint8_t depth = 0;
    OperationFlags flags = 0;
    ChannelBits channels = 0;  ///< needed when any of these is wanted
    Channel channel = Channel::BaseColor;
    BlendMode mode = BlendMode::Normal;
    float amount = 1.0f;  ///< weight of a blend, opacity of an entry, value of MaskBegin
    /// Index into ProgramData::sources; Adjust, MaskAdjust: into adjustments; MaskHeight: into
    /// height_blends; Reference: into references.
    std::int32_t source = 0;
    std::int32_t around = -1;  ///< Adjust, MaskAdjust: index into ProgramData::around, or -1
    std::int32_t jump = 0;     ///< index of an operation
    std::int32_t layer = 0;    ///< index into ProgramData::layers
};

/// What a source is read as. Colours and scalars are held to 0..1, whatever an image has beyond;
/// heights are not.
enum class Reading : std::uint8_t { LinearColor, EncodedColor, Scalar, Height, Normal };

/// Whether it is three numbers.
constexpr bool is_vector(Reading reading) {
    return reading != Reading::Scalar && reading != Reading::Height;
}

/// A source with everything resolved that does not depend on the resolution.
struct SourceRecord {
    Source source = {};
    Reading reading = Reading::Scalar;
    std::int32_t image = -1;      ///< index into ProgramData::images, for an ImageSource
    std::int32_t around = -1;     ///< index into ProgramData::around, for a ReliefSource
    std::int32_t reference = -1;  ///< index into ProgramData::references, for a ReferenceSource
    std::int32_t levels = -1;     ///< index into ProgramData::levels, for a mask entry
    std::int32_t choice = -1;     ///< index into ProgramData::chosen_parts, for a GeometrySource
    /// The number of a ProceduralSource's pattern, before contrast and ramp, where it is wanted
    /// more than once in a tile or in those around it; else -1.
    std::int32_t pattern = -1;
    Projection projection = {};                 ///< of the coordinates that the matrix takes
    float length_per_uv = 1.0f;                 ///< of what is projected: see UvSurface
    std::array<UniformPlane, 3> constant = {};  ///< of a ConstantSource, as `reading` says
    glm::vec3 mean = glm::vec3(0.0f);           ///< procedural_mean of a ProceduralSource
    /// The rows of the matrix that takes (u, v, 1) to the source's own coordinates.
    glm::vec3 to_u = glm::vec3(1.0f, 0.0f, 0.0f);
    glm::vec3 to_v = glm::vec3(0.0f, 1.0f, 0.0f);
};

/// How heights decide about a layer.
struct HeightBlendRecord {
    HeightBlend blend = {};
    /// Index into ProgramData::sources of the layer's height; -1: 0, the surface; of a group
    /// unused.
    std::int32_t source = -1;
    bool of_children = false;  ///< the layer's height is what the next depth accumulated
    std::uint8_t below = 0;    ///< the depth at which the heights lie that it is compared with
};

/// What a reference reads.
struct ReferenceRecord {
    Channel channel = Channel::Opacity;
    bool of_mask = false;    ///< what is covered of the channel is the value
    ChannelBits needed = 0;  ///< what the operations of the layer want
};

/// What lies below a layer whose adjustment looks around, or whose mask or source reads the relief
/// there; or what the mask is before an entry that looks around in it (composite/around.h).
struct AroundRecord {
    /// Of a mask: its first operation, which needs nothing that is accumulated before. Else 0.
    std::int32_t start = 0;
    std::int32_t begin = 0;       ///< what the operations before it leave is what is read
    std::int32_t last = 0;        ///< the last operation that reads it
    bool relief = false;          ///< heights, blurred and as they are, for a ReliefSource
    bool of_mask = false;         ///< the mask of the depth is read, for `channels` of its layer
    std::int32_t adjustment = 0;  ///< index into ProgramData::adjustments
    std::uint8_t depth = 0;
    ChannelBits channels = 0;
    /// Within a reference: wanted when any of these is, of the layer that refers. Else 0.
    ChannelBits referring = 0;

    /// What is kept as a channel is: a mask is one number.
    static constexpr Channel kMaskChannel = Channel::Opacity;
    /// Whether what is read has coverage.
    bool has_coverage() const { return depth > 0 && !of_mask; }
};

/// Whose operations they are, for `explain` and for messages.
struct LayerRecord {
    LayerId id = {};
    std::string name = {};
    int depth = 0;
};

/// A place between two layers of one stack: what `hash` covers is all that was accumulated there.
struct Checkpoint {
    std::int32_t begin = 0;  ///< first operation of the stack
    std::int32_t end = 0;    ///< first operation after the layer
    std::uint8_t depth = 0;
    ChannelBits encoded = 0;  ///< colours that are accumulated sRGB-encoded here
    ChannelBits touched = 0;  ///< channels that the stack has changed so far
    Hash128 hash = {};
};

struct ProgramData {
    std::vector<Operation> operations;
    std::vector<SourceRecord> sources;
    std::vector<Levels> levels;
    std::vector<AdjustmentSettings> adjustments;
    std::vector<HeightBlendRecord> height_blends;
    std::vector<ReferenceRecord> references;
    std::vector<AroundRecord> around;  ///< in the order in which they are reached
    std::vector<Hash128> images;
    std::vector<std::vector<std::uint8_t>> chosen_parts;  ///< of each part of the surface: 1 or 0
    UvSurfacePtr surface;                                 ///< where some source reads it; else null
    std::vector<LayerRecord> layers;
    std::vector<Checkpoint> checkpoints;  ///< in the order in which they are reached
    int depths = 1;                       ///< 1 + how deep groups are nested
    PerChannel<glm::vec3> bottom;         ///< where depth 0 starts, encoded where bottom_encoded
    ChannelBits bottom_encoded = 0;
    ChannelBits top_encoded = 0;  ///< colours that are sRGB-encoded in the end
    ChannelBits touched = 0;      ///< channels that some operation changes
    /// Channels of layers about which heights decide: their texels need the height channel too.
    ChannelBits led_by_height = 0;
    float height_scale = 0.0f;
    PerChannel<Hash128> channel_hashes;
    std::array<Hash128, kSlotCount> slot_hashes;
    std::array<SlotPlan, kSlotCount> slots;

    /// `wanted` and what has to be composited for it beside.
    ChannelBits with_needed(ChannelBits wanted) const {
        const bool heights = (wanted & led_by_height) != 0;
        return heights ? wanted | channel_bit(Channel::Height) : wanted;
    }
};

}  // namespace patina
