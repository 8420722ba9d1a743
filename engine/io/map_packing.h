// SPDX-License-Identifier: MIT
#pragma once

/// How other programs want the channels of a material in files: one table.

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "document/channel.h"

namespace patina::io {

/// What one channel of a file holds.
struct PackedValue {
    std::optional<Channel> channel = {};  ///< unset: `constant`
    int component = 0;
    bool invert = false;  ///< 1 - value; of a normal's component, -value
    float constant = 1.0f;
};

/// One file: 1, 3 or 4 channels. Three that come from a colour are sRGB-encoded in integers and
/// linear in floats; normals are n * 0.5 + 0.5, heights too.
struct PackedMap {
    std::string_view id;  ///< behind the material's name in the file's name
    int channels = 1;
    std::array<PackedValue, 4> values = {};

    /// Whether the first three channels are a colour.
    bool is_color() const;
    bool has_normals() const;
    /// Whether the fourth channel is opacity, as which files know it.
    bool has_opacity() const { return channels == 4 && values[3].channel == Channel::Opacity; }
};

struct MapPacking {
    std::string_view id;  ///< on the command line
    std::string_view description;
    std::span<const PackedMap> maps;
};

std::span<const MapPacking> map_packings();
/// "gltf", the first of them.
const MapPacking& default_packing();

}  // namespace patina::io
