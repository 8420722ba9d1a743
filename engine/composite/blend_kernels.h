// SPDX-License-Identifier: MIT
#pragma once

/// Laying a source on an accumulator, over the planes of one tile, for the instruction set of this
/// machine. The formulae are those of shaders/shared.

#include "composite/operations.h"
#include "composite/planes.h"

namespace patina {

struct BlendTask {
    Channel channel = Channel::BaseColor;
    BlendMode mode = BlendMode::Normal;
    bool first = false;  ///< the source replaces the accumulator, whose coverage becomes the weight
    int count = 0;
    TileBlocks blocks = 0;  ///< outside of which the weight is 0: they are left as they are
    float* target[3] = {};  ///< the accumulator: component_count(channel) planes
    float* target_coverage = nullptr;  ///< null where the accumulator is opaque
    ReadPlane source[3] = {};
    StoredTexels stored = {};  ///< in place of `source`, where blends_stored() allows it
    ReadPlane weight = {};     ///< mask and coverage of the source; scaled by `amount`
    /// Replace alone: the coverage of the source, which is then no part of the weight.
    ReadPlane source_coverage = {};
    float amount = 1.0f;
};
/// The loop over the texels of such tasks, which are alike but for amounts, places and counts.
/// Texels whose weight is 0 keep their bits.
using BlendKernel = void (*)(const BlendTask&);
BlendKernel blend_kernel(const BlendTask& task);
inline void blend_tile(const BlendTask& task) {
    blend_kernel(task)(task);
}

/// Whether blend_tile reads such texels by itself, where the accumulator is opaque.
bool blends_stored(Channel channel, BlendMode mode, const StoredTexels& texels);

/// The product of two planes.
void multiply_tile(const ReadPlane& a, const ReadPlane& b, float* product, int count);

/// Recodes three planes of colour in place: linear light to sRGB-encoded and back.
void encode_tile(float* const planes[3], int count);
void decode_tile(float* const planes[3], int count);

}  // namespace patina
