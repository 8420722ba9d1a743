// SPDX-License-Identifier: MIT
#include "document/preset_knobs.h"

#include <algorithm>
#include <cmath>

#include "document/layer_json.h"
#include "document/preset.h"

namespace patina {
namespace {

std::string known_knobs(const Preset& preset) {
    std::string ids;
    for (const PresetKnob& knob : preset.knobs) ids += (ids.empty() ? "" : ", ") + knob.id;
    return ids.empty() ? "none" : ids;
}

/// Sets the number that the pointer names. It may be one that is left out because it is the
/// standard, but what holds it has to be there.
Status set_number(Json& layers, const KnobTarget& target, float value) {
    const std::size_t last = target.path.rfind('/');
    const std::string holder = last == std::string::npos ? "" : target.path.substr(0, last);
    Json* parent = nullptr;
    try {
        parent = &layers.at(Json::json_pointer(holder));
    } catch (const Json::exception&) {
        return failure("a knob moves {}, but the layers have no {}",
                       quoted_for_message(target.path), quoted_for_message(holder));
    }
    const std::string key = target.path.substr(last + 1);
    if (parent->is_object() && (!parent->contains(key) || (*parent)[key].is_number())) {
        (*parent)[key] = json_of(value);
        return {};
    }
    const bool index = !key.empty() && std::all_of(key.begin(), key.end(),
                                                   [](char c) { return c >= '0' && c <= '9'; });
    if (parent->is_array() && index && key.size() < 4) {
        const auto at = static_cast<std::size_t>(std::stoul(key));
        if (at < parent->size() && (*parent)[at].is_number()) {
            (*parent)[at] = json_of(value);
            return {};
        }
    }
    return failure("a knob moves {}, which is no number", quoted_for_message(target.path));
}

/// The number of a target at `value`, to a millionth: decimals that people wrote stay short.
float turned_number(const KnobTarget& target, float value) {
    const double from = static_cast<double>(target.from);
    const double to = static_cast<double>(target.to);
    const double moved = from + (to - from) * static_cast<double>(value);
    return static_cast<float>(std::round(moved * 1e6) * 1e-6);
}

Status turn(Json& layers, const PresetKnob& knob, float value) {
    for (const KnobTarget& target : knob.targets)
        if (Status status = set_number(layers, target, turned_number(target, value)); !status)
            return status;
    return {};
}

}  // namespace

Result<std::vector<LayerPtr>> turned_layers(const Preset& preset,
                                            const std::vector<KnobSetting>& settings) {
    if (settings.empty()) return preset.layers;
    Json layers = layers_to_json(preset.layers, JsonIds::LeftOut);
    for (const KnobSetting& setting : settings) {
        const auto knob =
            std::find_if(preset.knobs.begin(), preset.knobs.end(),
                         [&](const PresetKnob& each) { return each.id == setting.id; });
        if (knob == preset.knobs.end())
            return failure("the preset {} has no knob {}; there are: {}", preset.id,
                           quoted_for_message(setting.id), known_knobs(preset));
        if (!(setting.value >= 0.0f && setting.value <= 1.0f))
            return failure("knob {} must be 0 to 1, got {}", setting.id, setting.value);
        if (Status status = turn(layers, *knob, setting.value); !status) return passed_on(status);
    }
    JsonFaults faults;
    std::vector<LayerPtr> turned = layers_from_json(layers, "/layers", faults);
    if (faults.any()) return passed_on(faults.status());
    IssuedIds issued{.taken = {}, .next = largest_id(turned) + 1};
    return with_unique_ids(turned, issued);
}

}  // namespace patina
