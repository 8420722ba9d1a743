// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace patina {

/// Of the unit square; 1 is excluded.
struct R2Point {
    double u = 0.0;
    double v = 0.0;
};

/// Point i of a sequence that is well spread for any count, the first in the middle: multiples of
/// the powers of the plastic number's inverse. Martin Roberts, "The unreasonable effectiveness of
/// quasirandom sequences", 2018.
inline R2Point r2_point(int i) {
    const auto place = [i](double step) {
        const double multiple = 0.5 + step * i;
        return multiple - std::floor(multiple);
    };
    return {place(0.7548776662466927), place(0.5698402909980532)};
}

}  // namespace patina
