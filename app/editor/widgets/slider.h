// SPDX-License-Identifier: MIT
#pragma once

/// The number field of Patina: label left, value right, the filled part behind them and a level
/// line below. Drag over the full width for the range, Shift for a tenth of the speed; double-click
/// or Ctrl-click types (sums allowed); Ctrl and the wheel take one step; a right click resets,
/// copies and pastes.

#include <optional>
#include <string>
#include <string_view>

#include "document/parameters.h"
#include "editor/widgets/ui.h"

namespace patina::editor {

struct NumberSpec {
    std::string_view label;
    std::string_view shown_label = {};  ///< within the field; empty: none
    double minimum = 0.0;
    double maximum = 1.0;
    double standard = 0.0;  ///< what a reset sets
    double step = 0.01;
    double display_scale = 1.0;  ///< shown = stored * this
    int decimals = 2;
    std::string_view unit = {};
    bool always_signed = false;
    bool whole = false;  ///< only whole numbers
    bool level = true;   ///< shows the filled part; off for numbers without a meaningful range
    SliderCurve curve = SliderCurve::Linear;
    std::string_view tooltip = {};
    std::string_view key = {};
    bool enabled = true;
    /// Of a field without a level: how much one pixel at scale 1 changes.
    double drag_per_pixel = 0.0;
};

/// As the table of parameters describes it, with the label shown.
NumberSpec number_spec(Parameter parameter);
/// The same without label or unit, for a narrow column.
NumberSpec compact_number_spec(Parameter parameter);

/// Returns the new value in every frame in which it changes.
std::optional<double> number_field(Ui& ui, const Rect& rect, const NumberSpec& spec, double value);

/// Where `value` lies in the width of a slider, 0 to 1, and back.
double slider_share(const NumberSpec& spec, double value);
double slider_value(const NumberSpec& spec, double share);

}  // namespace patina::editor
