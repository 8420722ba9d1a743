// SPDX-License-Identifier: MIT
#pragma once

/// A stack reduced to what can change the picture: the step before operations are emitted, from
/// which the bake rules read what a channel consists of.

#include <map>
#include <optional>
#include <vector>

#include "composite/operations.h"
#include "document/material.h"

namespace patina {

/// What one layer does to one channel.
struct Contribution {
    const Source* source = nullptr;  ///< null: what the children of the group accumulated
    const AdjustmentSettings* adjustment = nullptr;  ///< of what lies below, instead of a source
    BlendMode mode = BlendMode::Normal;
    float weight = 1.0f;  ///< layer opacity x mask, where that is uniform, x channel opacity
    bool covers = false;  ///< replaces all that lies below, in every texel
};

/// The entries of a mask that varies, bottom to top; empty where the mask is uniform.
struct MaskTerm {
    float begin = 1.0f;  ///< what the first entry joins
    bool invert = false;
    std::vector<const MaskEntry*> entries = {};
    bool varies() const { return !entries.empty(); }
};

struct LayerTerms {
    const Layer* layer = nullptr;
    MaskTerm mask = {};
    MaskTerm clip = {};  ///< that of the layer to which this one is clipped; multiplies the mask
    /// The content of that layer, by itself and in one channel, where it does not cover everything:
    /// what it covers multiplies the mask too.
    const LayerTerms* clip_content = nullptr;
    bool pass_through = false;  ///< of a group: the children go on from what lies below it
    /// How heights decide about the layer; null where they do not.
    const HeightBlend* height_blend = nullptr;
    const Source* height = nullptr;  ///< the layer's height for that; null: the surface, or a group
    bool reads_heights = false;  ///< what lies below decides by its heights, for mask or sources
    PerChannel<std::optional<Contribution>> channels = {};
    std::vector<LayerTerms> children = {};  ///< of a group

    ChannelBits channel_bits() const;
    /// `wanted`, and the heights that something inside the layer goes by for them.
    ChannelBits with_heights(ChannelBits wanted) const;
    /// What runs for the layer.
    ChannelBits run_bits() const { return with_heights(channel_bits()); }
    /// Whether its weight differs from texel to texel, but for its sources' coverage.
    bool has_mask() const {
        return mask.varies() || clip.varies() || clip_content != nullptr || height_blend != nullptr;
    }
};
using StackTerms = std::vector<LayerTerms>;

enum class CoveredLayers { Drop, Keep };

/// What sources read beyond themselves: the model, and each layer that is referred to, reduced as
/// if it lay alone. One to a layer that is not there, or has nothing of that kind, reads nothing.
class ReferredLayers {
  public:
    /// @param surface  as in compile_material, kept alive by the caller; null, or with UVs
    ReferredLayers(const std::vector<LayerPtr>& stack, const UvSurface* surface)
        : stack_(stack), surface_(surface) {}
    ReferredLayers(const ReferredLayers&) = delete;
    ReferredLayers& operator=(const ReferredLayers&) = delete;

    /// Null where nothing is read. A mask is what the layer then covers of Channel::Opacity.
    const LayerTerms* find(const ReferenceSource& reference);

    /// What the content of a layer covers, its mask and opacities aside: of the first channel that
    /// it lays on, since an image that is cut out may stand beside constants that are not.
    struct Content {
        bool is_nothing = false;             ///< a group that lays on nothing
        std::optional<LayerTerms> terms;     ///< of one channel; unset: it covers every texel
        std::shared_ptr<const Layer> plain;  ///< what the terms point into
    };
    const Content& content_of(const Layer& layer);
    /// What sources read of the model; null where no mesh is at hand.
    const UvSurface* surface() const { return surface_; }

  private:
    struct Found {
        std::shared_ptr<const Layer> plain;  ///< what stands for the layer where a mask is read
        std::optional<LayerTerms> terms;     ///< unset while it is being found
    };
    const std::vector<LayerPtr>& stack_;
    const UvSurface* surface_;
    std::map<std::pair<LayerId, LayerResult>, Found> found_;
    std::map<const Layer*, Content> contents_;
};

/// The layers of a stack, bottom to top, that can change the result. Hidden ones, those of no
/// weight and (unless kept, for `explain`) those that another one covers are left out. Points into
/// the layers of `stack`.
StackTerms stack_terms(const std::vector<LayerPtr>& stack, CoveredLayers covered,
                       ReferredLayers& referred);

/// The contributions to one channel at the top level, bottom to top.
std::vector<const LayerTerms*> layers_of_channel(const StackTerms& terms, Channel channel);

/// Whether no image or procedural decides the channel.
bool is_uniform(const StackTerms& terms, Channel channel);

/// The channels of layers, at any depth, about which heights decide.
ChannelBits led_by_height(const StackTerms& terms);

}  // namespace patina
