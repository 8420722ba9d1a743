// SPDX-License-Identifier: MIT
#pragma once

/// What an adjustment makes of an accumulator, over the planes of one tile.

#include "composite/operations.h"

namespace patina {

/// An adjustment as the kernels read it: all plain numbers, colours in the space of the planes.
struct AdjustNumbers {
    AdjustmentKind kind = AdjustmentKind::Levels;
    Levels levels = {};
    int curve_count = 0;
    float curve[kMaxCurvePoints][3] = {};  ///< x, y, slope
    float hue_sixths = 0.0f;               ///< 0 to 6
    float saturation = 0.0f;
    float lightness = 0.0f;
    float brightness = 0.0f;
    float contrast = 0.0f;
    float steps = 4.0f;
    int stop_count = 0;
    float stops[kMaxRampStops][4] = {};  ///< position, colour
    float low = 0.0f;
    float high = 1.0f;
};

struct AdjustTask {
    const AdjustmentSettings* adjustment = nullptr;
    Channel channel = Channel::BaseColor;  ///< Normal only of those that look around
    bool encoded = false;                  ///< colours are sRGB-encoded
    int count = 0;
    const float* from[3] = {};  ///< component_count(channel) planes
    float* to[3] = {};
};
/// Any but those that look around.
void run_adjustment(const AdjustTask& task);

}  // namespace patina
