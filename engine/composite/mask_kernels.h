// SPDX-License-Identifier: MIT
#pragma once

/// The mask of a layer, over the plane of one tile.

#include "composite/blend_kernels.h"

namespace patina {

struct MaskTask {
    float* mask = nullptr;
    TileBlocks blocks = 0;  ///< outside of which the mask is 0, as it is so far
    ReadPlane source = {};
    StoredTexels stored = {};  ///< in place of `source`, where mask_reads_stored() allows it
    BlendMode combine = BlendMode::Multiply;  ///< one that combines_masks
    float opacity = 1.0f;
    bool first = false;              ///< nothing lies below: the entry is the mask
    bool invert = false;             ///< of the entry, before its levels
    const Levels* levels = nullptr;  ///< null: the identity
    bool last = false;               ///< the mask is complete: it is held to 0..1 and then
    bool invert_mask = false;        ///< inverted
    int count = 0;
};
/// Joins one entry to the mask, for such tasks, which are alike but for amounts, places and counts.
/// Returns the blocks outside of which the mask is 0.
using MaskKernel = TileBlocks (*)(const MaskTask&);
MaskKernel mask_kernel(const MaskTask& task);
inline TileBlocks join_mask_tile(const MaskTask& task) {
    return mask_kernel(task)(task);
}

/// Whether texels are joined as they are stored: by the modes that masks mostly have, for which
/// there are loops of their own.
constexpr bool reads_stored(BlendMode combine) {
    return combine == BlendMode::Replace || combine == BlendMode::Multiply ||
           combine == BlendMode::Add || combine == BlendMode::Subtract ||
           combine == BlendMode::Lighten || combine == BlendMode::Darken;
}
/// Whether a MaskKernel reads such texels by itself.
bool mask_reads_stored(BlendMode combine, const StoredTexels& texels);

/// Where the heights of a layer and of what lies below it are, and how they decide.
struct HeightShareTask {
    float* mask = nullptr;
    ReadPlane below = {};
    ReadPlane below_coverage = {};  ///< heights count by what covers: 0 is the surface
    ReadPlane own = {};
    ReadPlane own_coverage = {};
    HeightBlend blend = {};
    int count = 0;
};
/// Multiplies the mask by the layer's share.
void share_by_height_tile(const HeightShareTask& task);

void fill_tile(float* plane, float value, int count);
void copy_tile(const float* from, float* to, int count);

}  // namespace patina
