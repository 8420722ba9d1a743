// SPDX-License-Identifier: MIT
#pragma once

/// The knobs of a preset: what an artist is meant to turn, each of which moves one or several
/// numbers of its layers.

#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "document/layer.h"

namespace patina {

/// A number of the layers that a knob moves. The number is `from` at 0 and `to` at 1.
struct KnobTarget {
    std::string path;  ///< a JSON pointer below the preset's layers: "/3/mask/entries/0/opacity"
    float from = 0.0f;
    float to = 1.0f;
    bool operator==(const KnobTarget&) const = default;
};

struct PresetKnob {
    std::string id;                   ///< "wear": lower-case letters, digits and hyphens
    std::string name;                 ///< "Wear"
    float value = 0.5f;               ///< where it stands in the preset as it is, 0 to 1
    std::vector<KnobTarget> targets;  ///< 1 to kMaxKnobTargets
    bool operator==(const PresetKnob&) const = default;
};
inline constexpr std::size_t kMaxKnobs = 16;
inline constexpr std::size_t kMaxKnobTargets = 32;

/// A knob turned to a place, 0 to 1.
struct KnobSetting {
    std::string id;
    float value = 0.5f;
};

struct Preset;

/// The layers of the preset with those knobs turned; the others stay as the layers have them. A
/// knob that the preset has not, a place outside 0 to 1, and a target that is no number of the
/// layers are failures.
Result<std::vector<LayerPtr>> turned_layers(const Preset& preset,
                                            const std::vector<KnobSetting>& settings);

}  // namespace patina
