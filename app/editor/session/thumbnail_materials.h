// SPDX-License-Identifier: MIT
#pragma once

/// Small materials whose base colour is a thumbnail: of a layer alone, of a mask, of one source.

#include "document/document.h"
#include "document/preset.h"

namespace patina::editor {

/// The layer by itself, everywhere: without its mask, opacity and place in the stack. Where it has
/// no base colour, its first other channel is shown as a grey or a colour.
Material layer_thumbnail(const Layer& layer);
/// Whether something of the mask is made of other layers, so that it needs their stack to be shown.
bool reads_other_layers(const Mask& mask);
/// White where a mask lets the layer through, on black.
Material mask_thumbnail(const Mask& mask, const std::vector<LayerPtr>& stack, LayerId layer);
/// A mask of that entry alone; what an adjustment makes of a gradient.
Mask only_entry(const MaskEntry& entry);
/// Of a channel: a number is shown as a grey, a direction as its usual colour.
Material source_thumbnail(const Source& source, Channel channel);
Material preset_thumbnail(const Preset& preset);

/// What is shown instead of `material` while a layer is shown alone or its mask is viewed.
Material with_only_layer(const Material& material, LayerId layer);
Material with_mask_shown(const Material& material, LayerId layer);

}  // namespace patina::editor
