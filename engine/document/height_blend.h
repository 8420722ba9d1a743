// SPDX-License-Identifier: MIT
#pragma once

namespace patina {

/// Where heights decide what a layer covers: it shows where it is higher than what lies below it in
/// its own stack, in all of its channels alike, times its mask and opacity. The formula is
/// height_share of shaders/shared/height.glsl. What the layer's height is, its height channel says,
/// before opacity; 0, the surface, where that is off. A group's is what its layers make.
struct HeightBlend {
    bool enabled = false;
    float offset = 0.0f;    ///< -1 to 1: raises the layer before heights are compared
    float radius = 0.1f;    ///< 0 to 1: the difference of heights within which both are seen
    float contrast = 0.0f;  ///< 0 to 1: hardens the change-over; 1 is an edge
    bool operator==(const HeightBlend&) const = default;
};

}  // namespace patina
