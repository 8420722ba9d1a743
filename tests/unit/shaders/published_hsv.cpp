// SPDX-License-Identifier: MIT
#include "shaders/published_hsv.h"

#include <algorithm>
#include <cmath>

namespace patina::test_support {

glm::dvec3 hsv_from_rgb(const glm::dvec3& c) {
    const double value = std::max({c.r, c.g, c.b}), chroma = value - std::min({c.r, c.g, c.b});
    double hue = 0;
    if (chroma > 0) {
        if (value == c.r)
            hue = (c.g - c.b) / chroma + (c.g < c.b ? 6 : 0);
        else if (value == c.g)
            hue = (c.b - c.r) / chroma + 2;
        else
            hue = (c.r - c.g) / chroma + 4;
    }
    return {hue, value > 0 ? chroma / value : 0, value};
}

glm::dvec3 rgb_from_hsv(double hue, double saturation, double value) {
    const auto part = [&](double offset) {
        const double at = std::fmod(offset + hue + 12, 6.0);
        return value - value * saturation * std::max(0.0, std::min({at, 4 - at, 1.0}));
    };
    return {part(5), part(3), part(1)};
}

}  // namespace patina::test_support
