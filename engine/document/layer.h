// SPDX-License-Identifier: MIT
#pragma once

/// A layer of a material: what it adds to each channel, where (mask) and how strongly.
///
/// Order for every channel, bottom to top: weight = layer opacity x channel opacity x mask x source
/// coverage; then source-over of blend(backdrop, source) with that weight.
/// Layers are immutable once shared; an edit makes a new one.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "document/adjustment.h"
#include "document/blend_mode.h"
#include "document/channel.h"
#include "document/height_blend.h"
#include "document/source.h"

namespace patina {

/// As LayerId.
struct MaskEntryId {
    std::uint64_t value = 0;
    auto operator<=>(const MaskEntryId&) const = default;
};

struct MaskEntry {
    MaskEntryId id = {};
    std::string name = {};
    bool visible = true;
    Source source = ConstantSource{glm::vec3(1.0f, 0.0f, 0.0f)};
    /// Set: the entry is what this makes of the mask before it. It has then no source and no levels
    /// of its own, and mostly replaces.
    std::optional<AdjustmentSettings> adjustment = {};
    /// How the entry joins what those before it made; one that combines_masks.
    BlendMode combine = BlendMode::Multiply;
    float opacity = 1.0f;  ///< 0 to 1: lerp between the mask without and with this entry
    bool invert = false;
    Levels levels = {};
    bool operator==(const MaskEntry&) const = default;
};

/// Starts at `base` everywhere, then takes each entry in order; the result is clamped to 0..1.
struct Mask {
    bool enabled = true;
    bool invert = false;
    float base = 1.0f;  ///< 1 white (the layer covers everything), 0 black
    std::vector<MaskEntry> entries = {};
    bool operator==(const Mask&) const = default;
};

struct ChannelSettings {
    /// Of a group: whether this channel of its children's result is laid on.
    bool enabled = false;
    Source source = ConstantSource{};  ///< of a group: unused, its children are the source
    /// Unset: the layer's mode where the channel is a colour, else default_blend_mode(channel).
    std::optional<BlendMode> mode = {};
    float opacity = 1.0f;  ///< 0 to 1
    bool operator==(const ChannelSettings&) const = default;
};

/// All channels off, with stack_bottom as their constant, so that one that is switched on does no
/// harm before it is given a source.
PerChannel<ChannelSettings> default_channels();

/// In which space the colours of a layer blend: physically, or as raster editors do.
enum class BlendSpace : std::uint8_t { Linear, SrgbEncoded };

struct Layer;
using LayerPtr = std::shared_ptr<const Layer>;

struct FillContent {
    bool operator==(const FillContent&) const = default;
};
/// Children bottom to top. An isolated group is composited by itself from transparent and then
/// laid on as one source; one whose mode is pass-through goes on from what lies below it.
struct GroupContent {
    std::vector<LayerPtr> children = {};
    bool open = true;  ///< unfolded in the layer list
    bool operator==(const GroupContent&) const = default;
};
/// Changes what lies below in its own stack, in the channels that are on.
struct AdjustmentContent {
    AdjustmentSettings adjustment = {};
    bool operator==(const AdjustmentContent&) const = default;
};
using LayerContent = std::variant<FillContent, GroupContent, AdjustmentContent>;

struct Layer {
    LayerId id = {};
    std::string name = {};
    bool visible = true;
    bool locked = false;
    /// Only where the next layer below that is not clipped covers: weight times that one's opacity,
    /// mask and content's cover. Hidden with it; alone at the bottom of a stack it does nothing.
    bool clipped = false;
    float opacity = 1.0f;                ///< 0 to 1
    BlendMode mode = BlendMode::Normal;  ///< of colours that state no mode of their own
    BlendSpace blend_space = BlendSpace::Linear;
    HeightBlend height_blend = {};
    Mask mask = {};
    PerChannel<ChannelSettings> channels = default_channels();
    LayerContent content = FillContent{};

    bool is_group() const { return std::holds_alternative<GroupContent>(content); }
    bool is_adjustment() const { return std::holds_alternative<AdjustmentContent>(content); }
    bool is_pass_through() const { return is_group() && mode == BlendMode::PassThrough; }
    /// Compares children by identity: equal means equal content, unequal may still be equal.
    bool operator==(const Layer&) const = default;
};

/// The mode that a channel of the layer blends with. Heights of a layer that blends by height, and
/// scalars and heights of an adjustment, replace what lies below where they state no mode.
BlendMode effective_blend_mode(const Layer& layer, Channel channel);

}  // namespace patina
