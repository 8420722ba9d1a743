// SPDX-License-Identifier: MIT
#pragma once

/// Single channels of a stack as floats: for maps in more than 8 bits and in other packings than
/// glTF's.

#include <array>
#include <functional>

#include "composite/composite.h"

namespace patina {

struct ChannelPlanes {
    int size = 0;  ///< texels a side
    /// By channel and component, size * size floats each, row 0 at the top; empty for channels that
    /// were not asked for. Colours are linear light, normals -1..1 with the height's relief in
    /// them; the same numbers that bake_maps rounds to 8 bits.
    std::array<std::array<PixelVector<float>, 3>, kChannelCount> planes;

    const PixelVector<float>& plane(Channel channel, int component = 0) const {
        return planes[static_cast<std::size_t>(channel)][static_cast<std::size_t>(component)];
    }
};

/// Whether any texel of the channel can differ from another one, or from what a material without
/// maps has.
bool varies(const Program& program, Channel channel);

/// Channels of texels that follow each other in a row, as ChannelPlanes has them.
struct ChannelSpan {
    int x = 0;  ///< of the first texel
    int y = 0;
    int count = 0;
    std::array<std::array<const float*, 3>, kChannelCount> values = {};

    const float* plane(Channel channel, int component = 0) const {
        return values[static_cast<std::size_t>(channel)][static_cast<std::size_t>(component)];
    }
};
/// Takes a span whose channels are valid during the call; called from several threads at once, for
/// other texels.
using ChannelSink = std::function<void(const ChannelSpan& span)>;

/// Gives every texel of the wanted channels to the sink; no map is kept. Fails as bake_maps does.
Status composite_channels(const Program& program, ImageProvider& images, int size,
                          const std::vector<Channel>& wanted, const ChannelSink& sink,
                          const Progress& progress = {});

/// The same as whole planes.
Result<ChannelPlanes> bake_channels(const Program& program, ImageProvider& images, int size,
                                    const std::vector<Channel>& wanted,
                                    const Progress& progress = {});

}  // namespace patina
