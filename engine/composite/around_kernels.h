// SPDX-License-Identifier: MIT
#pragma once

/// What adjustments that look around do to rows of texels, for the instruction set of this machine.
/// The formulae are those of shaders/shared/neighbourhood.glsl.

#include <cstdint>

#include "composite/planes.h"

namespace patina {

/// The sums of a blur along a line, weights[0] being that of the texel itself and weights[j] that
/// of both that are j texels away, up to `reach`.
struct BlurTask {
    const float* weights = nullptr;
    int reach = 0;
    /// 2 `reach` + 1 runs of texels, the first the farthest before: of a row, each begins one texel
    /// after the last; across rows, each is in the next row.
    const float* const* lines = nullptr;
    int count = 0;
    float* sums = nullptr;  ///< may be none of the lines
};
void blur_tile(const BlurTask& task);

/// From sums of colour times coverage to the colour that is left; where nothing covers, `own`.
/// In place, on `sums`.
void divide_by_coverage_tile(float* sums, const float* coverage_sums, const float* own, int count);

/// From a blur to what is sharper than `own`, in place; `hold`: to 0..1.
void sharpen_tile(float* blurred, const float* own, float amount, bool hold, int count);

/// Takes three planes to unit length.
void normalise_tile(float* const planes[3], int count);

/// From the mean around heights to what a relief source of a kind RELIEF_... gives, in place.
void relief_tile(int kind, const float* own, float strength, float* around, int count);

/// Where a warp takes texels [x, x + count) of row y from: how many texels further right and down.
struct WarpTask {
    int x = 0;
    int y = 0;
    int count = 0;
    float size = 1.0f;             ///< texels a side
    float distance_texels = 0.0f;  ///< the farthest
    int cells = 1;                 ///< of the noise, across the texture
    int octaves = 1;
    std::uint32_t seed = 0;
    float* right = nullptr;
    float* down = nullptr;
};
void warp_tile(const WarpTask& task);

}  // namespace patina
