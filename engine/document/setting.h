// SPDX-License-Identifier: MIT
#pragma once

/// One value of a document set by its name: what `--set MATERIAL/LAYER/PATH=VALUE` does. Layers are
/// addressed as their JSON has them (document/layer_json.h), with short cuts:
///
///   Body/Rust/opacity=0.5                    the layer's own
///   Body/Rust/mode=multiply
///   Body/Rust/height-blend/radius=0.2        blends by height, unless it is told not to
///   Body/Rust/roughness/opacity=0.5          of a channel
///   Body/Rust/opacity/source=0.5             of the channel "opacity"
///   Body/Rust/base-color=#8a3b12             its value: sRGB, [r, g, b] in linear light, a number
///   Body/Rust/roughness/scale=24             of its source (roughness/source/scale)
///   Body/Rust/mask/base=0                    of the mask
///   Body/Rust/mask/Edges/levels/gamma=2      of the mask's entry "Edges"
///   Body/resolution=1024                     the material's own
///
/// "*" stands for every material. A "/" in a name is written "\/".

#include <string>
#include <string_view>
#include <vector>

#include "document/edit.h"

namespace patina {

struct Setting {
    std::string material;           ///< "*": every one
    std::vector<std::string> path;  ///< a layer and a place in it, or a parameter of the material
    std::string value;
    std::string text;  ///< as it was typed, for messages
};

/// Splits "MATERIAL/LAYER/PATH=VALUE". Whether there are such things is found when it is applied.
Result<Setting> setting_from_text(std::string_view text);

/// Sets the value in every material and layer of those names. Checked as a file is: what is not
/// there, of the wrong kind or out of range is a failure, and nothing is clamped.
Result<Document> with_setting(const Document& before, const Setting& setting);

}  // namespace patina
