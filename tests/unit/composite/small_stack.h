// SPDX-License-Identifier: MIT
#pragma once

/// Stacks of a few layers, and a channel of what they come to.

#include <utility>
#include <vector>

#include "composite/bake_channels.h"
#include "composite/image_table.h"
#include "document/material.h"
#include "document/small_layers.h"

namespace patina {

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

inline Source constant(float x, float y = 0.0f, float z = 0.0f) {
    return ConstantSource{glm::vec3(x, y, z)};
}

/// A component of the channel, `size` texels a side.
inline PixelVector<float> plane(const Material& material, ImageTable& images, Channel channel,
                                int size, int component = 0) {
    return bake_channels(Program::compile(material), images, size, {channel})
        ->plane(channel, component);
}
/// The first component, where there are no images.
inline PixelVector<float> plane(const Material& material, Channel channel, int size) {
    ImageTable images;
    return plane(material, images, channel, size);
}

}  // namespace patina
