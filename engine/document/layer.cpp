// SPDX-License-Identifier: MIT
#include "document/layer.h"

#include "document/material.h"

namespace patina {

PerChannel<ChannelSettings> default_channels() {
    PerChannel<ChannelSettings> channels;
    for (const ChannelInfo& entry : kChannels)
        at(channels, entry.channel).source = ConstantSource{stack_bottom(entry.channel)};
    return channels;
}

BlendMode effective_blend_mode(const Layer& layer, Channel channel) {
    const std::optional<BlendMode>& own = at(layer.channels, channel).mode;
    if (own && applies_to(*own, channel)) return *own;
    // What an adjustment gives is the channel itself, changed: it replaces what was there.
    if (layer.is_adjustment() && info(channel).kind != ChannelKind::Color) return BlendMode::Normal;
    // Where heights decide who is seen, they go over to the layer's as all else does.
    if (layer.height_blend.enabled && channel == Channel::Height) return BlendMode::Normal;
    const bool follows_layer = info(channel).kind == ChannelKind::Color;
    if (follows_layer && applies_to(layer.mode, channel)) return layer.mode;
    return default_blend_mode(channel);
}

}  // namespace patina
