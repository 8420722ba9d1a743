// SPDX-License-Identifier: MIT
#pragma once

/// What the probes of probes.glsl are, and the inputs that they are run over.

#include <array>
#include <cstddef>
#include <vector>

namespace patina {

struct Probe {
    const char* name;
    /// How far a GPU may be off, relative to max(1, |value|): GLSL lets it fuse and reorder.
    float gpu_tolerance;
};

inline constexpr Probe kProbes[] = {
    {"blend: normal, multiply, screen, add", 1e-6f},
    {"blend: hard light, overlay, soft light, subtract", 1e-6f},
    {"blend: darken, lighten, difference; over_coverage", 1e-6f},
    {"over_premultiplied, unpremultiplied, over_opaque", 1e-6f},
};
inline constexpr int kProbeCount = static_cast<int>(std::size(kProbes));

/// The inputs a and b of the probes as eight planes (a.x ... b.w) of kProbeInputs floats in 0..1:
/// every second value is 0, 1 or a branch point of some formula, the rest are random, always the
/// same.
inline constexpr std::size_t kProbeInputs = 64 * 64;
using ProbeInputs = std::array<std::vector<float>, 8>;
const ProbeInputs& probe_inputs();

}  // namespace patina
