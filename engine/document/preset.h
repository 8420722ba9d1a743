// SPDX-License-Identifier: MIT
#pragma once

/// A preset: a material to lay on, as one JSON file that people read, diff and share. See
/// presets/schema.json for the format; it is valid against that.

#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "document/layer.h"
#include "document/preset_knobs.h"

namespace patina {

/// An image that a preset's layers read.
struct PresetImage {
    std::string file;  ///< beside the preset file, a plain name without any folder
    Hash128 hash;      ///< content_hash of the decoded pixels
    bool operator==(const PresetImage&) const = default;
};

struct Preset {
    std::string id;        ///< "rusted-iron": lower-case letters, digits and hyphens
    int version = 1;       ///< of this preset; grows when its look changes
    std::string name;      ///< "Rusted iron"
    std::string category;  ///< "Metal"
    std::vector<std::string> tags;
    std::string author;
    std::string licence;      ///< an SPDX identifier, such as "CC0-1.0"
    std::string description;  ///< a sentence
    std::vector<PresetKnob> knobs;
    std::vector<PresetImage> images;
    std::vector<LayerPtr> layers;  ///< bottom to top; ids are fresh within the preset, from 1
};

/// Reads a preset. Everything is checked; the message names `origin` (the file) and the JSON
/// pointer.
Result<Preset> preset_from_json(std::string_view text, std::string_view origin);

/// Indented text, keys in a fixed order, numbers as short as they can be: equal presets, equal
/// bytes.
std::string preset_to_json(const Preset& preset);

}  // namespace patina
