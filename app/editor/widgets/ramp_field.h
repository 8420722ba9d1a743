// SPDX-License-Identifier: MIT
#pragma once

/// The ramp of a procedural: a bar of what the noise becomes, with its stops below. Click the bar
/// to add a stop, drag a stop to move it, click it to change its value, drag it off or right-click
/// to remove it.

#include <optional>
#include <string_view>
#include <vector>

#include "document/source.h"
#include "editor/widgets/ui.h"

namespace patina::editor {

struct RampSpec {
    std::string_view label;
    bool color = true;  ///< stops are colours; else numbers between minimum and maximum
    float minimum = 0.0f;
    float maximum = 1.0f;
};
/// `rect` is the bar with the stops' 8 px below. Returns all stops when something changed.
std::optional<std::vector<RampStop>> ramp_field(Ui& ui, const Rect& rect, const RampSpec& spec,
                                                const std::vector<RampStop>& stops);

}  // namespace patina::editor
