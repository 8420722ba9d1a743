// SPDX-License-Identifier: MIT
#pragma once

/// Stacks of a few layers, and a channel of what they come to.

#include <memory>
#include <utility>
#include <vector>

#include "composite/bake_channels.h"
#include "composite/image_table.h"
#include "document/material.h"

namespace patina {

inline LayerPtr shared(Layer layer) {
    return std::make_shared<const Layer>(std::move(layer));
}

/// Turns the channel on and gives it that source.
inline void set(Layer& layer, Channel channel, Source source) {
    at(layer.channels, channel).enabled = true;
    at(layer.channels, channel).source = std::move(source);
}

inline Material stack_of(std::vector<LayerPtr> stack) {
    Material material;
    material.stack = std::move(stack);
    return material;
}

/// The channel's first component, `size` texels a side.
inline PixelVector<float> plane(const Material& material, Channel channel, int size) {
    ImageTable images;
    return bake_channels(Program::compile(material), images, size, {channel})->plane(channel);
}

}  // namespace patina
