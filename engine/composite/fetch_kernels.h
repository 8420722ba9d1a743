// SPDX-License-Identifier: MIT
#pragma once

/// From the bytes of an image to planes of floats, over one tile.

#include <glm/glm.hpp>

#include "composite/operations.h"
#include "scene/image.h"

namespace patina {

/// Which components of a texel are read, by index; alike where grey stands for a colour.
struct Components {
    int count = 1;      ///< 1 or 3
    int index[3] = {};  ///< -1: the image has none, and it reads 1 (alpha)
};
/// What `pick` means in an image of `channels` channels.
Components picked_components(ChannelPick pick, int channels);

/// A run of texels as stored: 0..1 for integers, or in linear light.
struct ReadTask {
    const std::byte* texels = nullptr;
    std::size_t row_bytes = 0;  ///< from a row of the image to the next
    SampleType type = SampleType::U8;
    int channels = 4;
    Components components = {};
    bool decode = false;  ///< sRGB to linear; bytes alone, which a table knows
    int count = 0;
    float* planes[3] = {};  ///< components.count of them
};
void read_tile(const ReadTask& task);

/// From stored numbers to the values that a source gives. Steps that are off cost nothing.
struct Adjustment {
    bool invert = false;  ///< 1 - x
    bool decode = false;  ///< sRGB to linear
    bool unpack = false;  ///< 0..1 to -1..1
    bool flip_y = false;  ///< after unpacking
    bool scale = false;   ///< x multiply + add
    bool normalise = false;
    bool luminance = false;  ///< three components become one, in planes[0]
    bool hold = false;       ///< to 0..1, and then
    bool encode = false;     ///< linear to sRGB
    glm::vec3 multiply = glm::vec3(1.0f);
    glm::vec3 add = glm::vec3(0.0f);
    bool is_identity() const {
        return !(invert || decode || unpack || scale || normalise || luminance || hold || encode);
    }
};
/// In place, on `components` (1 or 3) planes.
void adjust_tile(const Adjustment& adjustment, int components, float* const planes[3], int count);

}  // namespace patina
