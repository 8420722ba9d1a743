// SPDX-License-Identifier: MIT
#pragma once

/// From the planes of a tile to the bytes of a map.

#include <cstdint>

#include "composite/planes.h"

namespace patina {

enum class OutputEncoding : std::uint8_t {
    AsIs,         ///< 0..1 as it stands
    LinearColor,  ///< linear light, to be sRGB-encoded; alpha stays
    Normal,       ///< a unit vector, to be put into 0..1
};

struct OutputTask {
    OutputEncoding encoding = OutputEncoding::AsIs;
    ReadPlane components[4] = {};  ///< red, green, blue, alpha
    int count = 0;
    bool to_memory = false;        ///< past the caches: nobody reads it back from there
    std::uint8_t* rgba = nullptr;  ///< 4 `count` bytes; each value is held to 0..1 and rounded
};
void write_tile(const OutputTask& task);

/// Bends normals by a height field: the normal of the heights with the given one laid on by RNM.
struct ReliefTask {
    /// Heights of the rows above, here and below, from the texel before the first to the one after
    /// the last: `count` + 2 floats each.
    const float* above = nullptr;
    const float* here = nullptr;
    const float* below = nullptr;
    float depth_texels = 0.0f;  ///< height 1, in texels
    int count = 0;
    float* normal[3] = {};
};
void add_relief_tile(const ReliefTask& task);

}  // namespace patina
