// SPDX-License-Identifier: MIT
#pragma once

/// Noises and patterns, and contrast and ramp on them, over the planes of one tile.

#include <cstdint>

#include "document/source.h"

namespace patina {

/// A procedural source at one run of texels of a row: all that is uniform there.
struct ProceduralTask {
    int x = 0;          ///< the first texel
    int count = 0;      ///< of texels
    float size = 1.0f;  ///< texels a side
    /// Coordinates of the source at u = 0 in this row, and their change with u.
    float u_of_row = 0.0f;
    float v_of_row = 0.0f;
    float u_per_u = 1.0f;
    float v_per_u = 0.0f;
    /// Coordinates of each texel, where they are not those; else null.
    const float* u = nullptr;
    const float* v = nullptr;

    ProceduralKind kind = ProceduralKind::PerlinNoise;
    std::uint32_t seed = 0;
    int columns = 1;  ///< cells across the texture
    int rows = 1;     ///< and down
    int octaves = 1;
    float width = 0.5f;
    float softness = 0.1f;
    float variation = 0.5f;
    float warp = 0.0f;
    float footprint = 0.0f;  ///< width of a texel in cells
    float contrast = 0.0f;
    float balance = 0.5f;

    int stop_count = 1;
    float stop_positions[kMaxRampStops] = {};
    float stop_values[kMaxRampStops][3] = {};
    /// Of what contrast and ramp make of the whole pattern, linear: see procedural_mean.
    float mean[3] = {};

    bool scalar = true;      ///< one plane, else three
    bool encode = false;     ///< colours become sRGB-encoded
    bool normalise = false;  ///< normals become unit vectors
};
/// The pattern of a task: a formulae::Pattern, of which there is one for each width of lanes.
template <class Pattern>
Pattern pattern_of(const ProceduralTask& task) {
    return {static_cast<int>(task.kind),
            task.columns,
            task.rows,
            task.seed,
            task.octaves,
            task.width,
            task.softness,
            task.variation,
            task.warp,
            task.footprint};
}

/// The pattern before contrast and ramp, which asks for nothing of a task beyond `footprint`.
void run_pattern(const ProceduralTask& task, float* plane);
/// What contrast and ramp make of it; `pattern` may be planes[0].
void run_ramp(const ProceduralTask& task, const float* pattern, float* const planes[3]);

}  // namespace patina
