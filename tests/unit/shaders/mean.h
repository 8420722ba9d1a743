// SPDX-License-Identifier: MIT
#pragma once

/// The mean of what a picture of noise or of a pattern holds.

#include <numeric>
#include <vector>

namespace patina {

inline double mean(const std::vector<float>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace patina
