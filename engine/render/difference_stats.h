// SPDX-License-Identifier: MIT
#pragma once

/// Numbers about a difference of two pictures.

#include <span>
#include <vector>

namespace patina::render {

struct DifferenceStats {
    int pixels = 0;
    float mean = 0.0f;
    float below_95 = 0.0f;  ///< 95 % of the pixels differ by no more
    float largest = 0.0f;
    /// Shares of the pixels, 0 to 1, in equal bins from 0 to `range`; what is beyond is in the
    /// last.
    std::vector<float> shares;
};

/// @param differences  absolute ones, as Renderer::differences gives them; none: all is 0
/// @param range  above 0
DifferenceStats difference_stats(std::span<const float> differences, float range, int bins);

}  // namespace patina::render
