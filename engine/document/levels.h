// SPDX-License-Identifier: MIT
#pragma once

namespace patina {

/// in_low..in_high is stretched to 0..1 and held there, raised to 1/gamma, and put into
/// out_low..out_high. All but gamma are 0 to 1.
struct Levels {
    float in_low = 0.0f;  ///< at most in_high; where they are equal, a threshold
    float in_high = 1.0f;
    float gamma = 1.0f;  ///< 0.1 to 10
    float out_low = 0.0f;
    float out_high = 1.0f;  ///< below out_low: inverted
    bool operator==(const Levels&) const = default;
};

}  // namespace patina
