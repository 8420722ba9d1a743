// SPDX-License-Identifier: MIT
#pragma once

namespace patina {

/// in_low..in_high is stretched to 0..1, raised to 1/gamma, and put into out_low..out_high.
struct Levels {
    float in_low = 0.0f;
    float in_high = 1.0f;
    float gamma = 1.0f;  ///< 0.1 to 10
    float out_low = 0.0f;
    float out_high = 1.0f;
    bool operator==(const Levels&) const = default;
};

}  // namespace patina
