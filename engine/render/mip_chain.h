// SPDX-License-Identifier: MIT
#pragma once

/// Textures as the GPU takes them, with their mips, made on the CPU: four numbers a texel, sRGB
/// averaged in linear light, and beside normals how much they vary within a texel. A change of some
/// texels is carried through the levels by itself.

#include <cstdint>
#include <vector>

#include "composite/composite.h"
#include "scene/image.h"

namespace patina::render {

/// 8-bit images stay 8-bit (stored as they are); others become linear floats.
enum class TexelStorage { Rgba8, RgbaFloat };

/// What the numbers are, which is how they are averaged.
enum class TexelMeaning {
    Linear,
    Srgb,
    /// Red, green and blue are n * 0.5 + 0.5; alpha, whatever it was, becomes the deviation within
    /// the texel: sqrt(1 - |mean of n|^2) of unit normals, 0 in the first level. After Marc
    /// Olano and Dan Baker, "LEAN mapping", 2010.
    Normals,
};

struct MipLevel {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> bytes;  ///< TexelStorage::Rgba8: width * height * 4
    std::vector<float> floats;        ///< TexelStorage::RgbaFloat: width * height * 4
};

struct MipChain {
    TexelStorage storage = TexelStorage::Rgba8;
    TexelMeaning meaning = TexelMeaning::Linear;  ///< of bytes; floats of sRGB images are linear
    std::vector<MipLevel> levels;  ///< down to 1 x 1, each half of the one before, rounded down
};

/// Grey images fill red, green and blue; missing alpha is 1. Floats of sRGB images are decoded.
MipChain mip_chain(const Image& image, TexelMeaning meaning);

/// Takes the texels inside `rect` from `image`, which has the size and type that the chain was made
/// from. Returns the rectangle of each level that has changed.
std::vector<TexelRect> update_mip_chain(MipChain& chain, const Image& image, const TexelRect& rect);

}  // namespace patina::render
