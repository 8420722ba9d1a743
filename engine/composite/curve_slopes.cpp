// SPDX-License-Identifier: MIT
#include "composite/curve_slopes.h"

namespace patina {

std::vector<float> curve_slopes(const std::vector<CurvePoint>& points) {
    const std::size_t count = points.size();
    std::vector<float> chords;
    for (std::size_t i = 0; i + 1 < count; ++i)
        chords.push_back((points[i + 1].y - points[i].y) / (points[i + 1].x - points[i].x));
    std::vector<float> slopes(count, 0.0f);
    slopes.front() = chords.front();
    slopes.back() = chords.back();
    for (std::size_t i = 1; i + 1 < count; ++i) {
        const float before = chords[i - 1];
        const float after = chords[i];
        if (!(before * after > 0.0f)) continue;  // a peak or a flat part: level there
        // The harmonic mean, weighted by the other side's width.
        const float width_before = points[i].x - points[i - 1].x;
        const float width_after = points[i + 1].x - points[i].x;
        const float share =
            (width_before + 2.0f * width_after) / (3.0f * (width_before + width_after));
        slopes[i] = before * after / (share * after + (1.0f - share) * before);
    }
    return slopes;
}

}  // namespace patina
