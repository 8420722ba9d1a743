// SPDX-License-Identifier: MIT
#pragma once

/// What is promised of Patina's speed: ratios of two benchmarks of one run. Milliseconds differ
/// from machine to machine and from hour to hour; ratios of what ran interleaved hardly do.

#include <array>
#include <string_view>

namespace patina::bench {

struct Ratio {
    std::string_view numerator;
    std::string_view denominator;
    double target = 0.0;
    bool at_least = false;  ///< else at most
};

inline constexpr std::array kRatios = {
    Ratio{"composite/stack10/1024", "touch/stack10/1024", 2.0},
    Ratio{"composite/stack10/2048", "touch/stack10/2048", 2.0},
    Ratio{"composite/stack10/4096", "touch/stack10/4096", 2.0},
    Ratio{"composite-linear/stack10/2048", "composite/stack10/2048", 1.5},
    Ratio{"naive/stack10/2048", "composite/stack10/2048", 15.0, true},
    Ratio{"edit/layer5of10/2048", "composite/stack10/2048", 0.7},
    Ratio{"edit/layer9of10/2048", "composite/stack10/2048", 0.35},
    Ratio{"edit/tile256/2048", "composite/stack10/2048", 0.05},
    Ratio{"preview/1024of2048", "composite/stack10/2048", 0.3},
    Ratio{"png/oiio/2048", "png/encode/2048", 20.0, true},
    Ratio{"png/libpng1/2048", "png/encode/2048", 4.0, true},
    Ratio{"png/encode/2048", "png/isal/2048", 1.5},
    Ratio{"frame/1280x720", "frame/bare/1280x720", 1.3},
    Ratio{"frame/moving/1280x720", "frame/1280x720", 0.4},
    Ratio{"ibl/first", "ibl/finished", 0.35},
};

}  // namespace patina::bench
