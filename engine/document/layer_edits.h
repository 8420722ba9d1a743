// SPDX-License-Identifier: MIT
#pragma once

/// Edits of the layer stack: layers made, moved, removed, and what each says of itself and of its
/// channels. See edits.h for what holds for all edits.

#include <optional>
#include <string>
#include <vector>

#include "document/edit.h"
#include "document/parameters.h"

namespace patina {

/// Where a layer goes. "Top" is the end of a list: what is drawn last.
struct LayerPlace {
    enum class Kind { TopOfStack, Above, Below, TopOfGroup };
    Kind kind = Kind::TopOfStack;
    LayerId anchor;  ///< the layer above or below which, or the group in which
    bool operator==(const LayerPlace&) const = default;
};
constexpr LayerPlace top_of_stack() {
    return {};
}
constexpr LayerPlace above(LayerId layer) {
    return {LayerPlace::Kind::Above, layer};
}
constexpr LayerPlace below(LayerId layer) {
    return {LayerPlace::Kind::Below, layer};
}
constexpr LayerPlace top_of_group(LayerId group) {
    return {LayerPlace::Kind::TopOfGroup, group};
}

/// The most layers of one material, groups and their children counted.
inline constexpr int kMaxLayers = 1024;
/// The deepest nesting of groups: a layer at the top of the stack is at depth 1.
inline constexpr int kMaxLayerDepth = 64;
/// The longest name of a layer, mask entry or material.
inline constexpr std::size_t kMaxNameBytes = 256;

/// New layers for add_layer, named for what they are; their ids are given when they are added.
/// A fill of one value per channel: base colour, metalness and roughness on, at the values of an
/// empty stack.
Layer value_layer();
/// A fill whose base colour is an image, read as the file says. Named for the image.
Layer image_layer(const ImageAsset& image);
/// A fill whose base colour is a noise from black to white.
Layer procedural_layer(ProceduralKind kind);
/// An adjustment of the colours below, which changes nothing yet; blends in sRGB-encoded values, as
/// raster editors adjust.
Layer adjustment_layer(AdjustmentKind kind);
/// An empty isolated group that lays on all channels of its children.
Layer group_layer();

/// The id that the next layer added to `document` gets (its children and mask entries get the ids
/// that follow), for a panel that selects what it adds.
LayerId next_layer_id(const Document& document);

/// Adds a copy of `layer` with fresh ids for it, its children and all mask entries.
Edit add_layer(const Material& material, const Layer& layer, LayerPlace place);
/// Adds several, the first one lowest, in one step.
Edit add_layers(const Material& material, std::vector<LayerPtr> layers, LayerPlace place,
                std::string label);
Edit remove_layer(const Material& material, const Layer& layer);
/// Adds a copy right above, unlocked, with fresh ids throughout and " copy" after its name.
Edit duplicate_layer(const Material& material, const Layer& layer);
/// Moves a layer with all its children; their ids stay. A group cannot go into itself.
Edit move_layer(const Material& material, const Layer& layer, LayerPlace place);
/// Puts layers of one list (siblings) into a new group in the place of the highest of them.
Edit group_layers(const Material& material, const std::vector<LayerPtr>& layers);
/// Replaces a group by its children.
Edit ungroup_layer(const Material& material, const Layer& group);
/// Puts `layers` (fresh ids throughout) in the place of the whole stack, lowest first.
Edit replace_stack(const Material& material, std::vector<LayerPtr> layers, std::string label);

/// 1 to kMaxNameBytes bytes of UTF-8 without control characters.
Edit rename_layer(const Material& material, const Layer& layer, std::string name);
/// Allowed on locked layers too.
Edit set_layer_visible(const Material& material, const Layer& layer, bool visible);
/// Allowed on locked layers, naturally; not on a layer inside a locked group.
Edit set_layer_locked(const Material& material, const Layer& layer, bool locked);
/// 0 to 1.
Edit set_layer_opacity(const Material& material, const Layer& layer, float opacity);
/// Clips a layer to the next one below that is not clipped.
Edit set_layer_clipped(const Material& material, const Layer& layer, bool clipped);
/// Puts a whole adjustment in the place of the layer's. `parameter`: what is being changed, for the
/// label; drags of one parameter merge. Normals go off where the kind cannot adjust them.
Edit set_adjustment(const Material& material, const Layer& layer,
                    const AdjustmentSettings& adjustment, Parameter parameter);
/// A mode that applies to colours; for a group pass-through as well.
Edit set_layer_mode(const Material& material, const Layer& layer, BlendMode mode);
Edit set_layer_blend_space(const Material& material, const Layer& layer, BlendSpace space);
/// `parameter`: what is being changed, for the label; drags of one parameter merge.
Edit set_layer_height_blend(const Material& material, const Layer& layer, const HeightBlend& blend,
                            Parameter parameter);
/// Folds and unfolds a group in the layer list. Allowed on locked layers.
Edit set_group_open(const Material& material, const Layer& group, bool open);

Edit set_channel_enabled(const Material& material, const Layer& layer, Channel channel,
                         bool enabled);
/// A mode that applies to the channel, or unset for the layer's or the channel's own default.
Edit set_channel_mode(const Material& material, const Layer& layer, Channel channel,
                      std::optional<BlendMode> mode);
/// 0 to 1.
Edit set_channel_opacity(const Material& material, const Layer& layer, Channel channel,
                         float opacity);

}  // namespace patina
