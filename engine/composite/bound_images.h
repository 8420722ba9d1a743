// SPDX-License-Identifier: MIT
#pragma once

/// The images of a program, fetched and fitted to one resolution before the tiles run.

#include <string>
#include <vector>

#include "composite/fetch_kernels.h"
#include "composite/image_provider.h"
#include "composite/operations.h"
#include "composite/reduced_images.h"
#include "scene/uv_map.h"

namespace patina {

/// What a source makes of an image's texels: the same in every tile.
struct ImageReading {
    Components components = {};
    bool decode = false;         ///< sRGB to linear while reading: each tap, or each byte
    Adjustment adjustment = {};  ///< of what lies in planes then
    bool as_stored = false;      ///< the texels lie on those of the map, as bytes, and need no more
};

/// How one image source is read.
struct BoundImage {
    ImagePtr image;  ///< the original or a smaller copy; null for other sources
    ImageReading reading = {};
    bool texel_for_texel = false;  ///< it lies on the texels of the map: rows are read as they are
    bool placeholder = false;      ///< the pixels are not there, or not needed
};

struct BoundImages {
    std::vector<BoundImage> sources;    ///< one for each of ProgramData::sources
    std::vector<std::string> failures;  ///< of images that are not there
    UvMapPtr surface_map;               ///< of ProgramData::surface; null where there is none
};

/// Binds the images that the channels in `wanted` need at `size` texels a side. Those that are not
/// there become a grey checker.
BoundImages bind_images(const ProgramData& program, ChannelBits wanted, int size,
                        ImageProvider& images, ReducedImages& reduced);

/// The same for a bake. A `size` that is not 1 to 16384 and an image that is not there are
/// failures.
Result<BoundImages> images_for_bake(const ProgramData& program, ChannelBits wanted, int size,
                                    ImageProvider& images);

}  // namespace patina
