// SPDX-License-Identifier: MIT
#include "render/difference_stats.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace patina::render {

DifferenceStats difference_stats(std::span<const float> differences, float range, int bins) {
    assert(range > 0.0f && bins > 0);
    DifferenceStats stats;
    stats.shares.assign(static_cast<std::size_t>(bins), 0.0f);
    if (differences.empty()) return stats;
    std::vector<float> sorted(differences.begin(), differences.end());
    std::sort(sorted.begin(), sorted.end());
    const auto count = static_cast<double>(sorted.size());
    stats.pixels = static_cast<int>(sorted.size());
    stats.mean = static_cast<float>(std::accumulate(sorted.begin(), sorted.end(), 0.0) / count);
    const auto at_95 = static_cast<std::size_t>(std::ceil(0.95 * count)) - 1;
    stats.below_95 = sorted[at_95];
    stats.largest = sorted.back();
    const float bins_per_unit = static_cast<float>(bins) / range;
    for (const float difference : sorted) {
        const float place = std::min(difference * bins_per_unit, static_cast<float>(bins - 1));
        stats.shares[static_cast<std::size_t>(place)] += static_cast<float>(1.0 / count);
    }
    return stats;
}

}  // namespace patina::render
