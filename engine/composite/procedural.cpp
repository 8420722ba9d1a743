// SPDX-License-Identifier: MIT
#include "composite/procedural.h"

#include <algorithm>
#include <cmath>

#include "composite/procedural_kernels.h"
#include "core/formulae/formulae.h"

namespace patina {
namespace {

constexpr float kOctaveGain = 0.5f;
constexpr float kMaxCells = 512.0f;
constexpr int kMaxOctaves = 10;

int noise_kind(ProceduralKind kind) {
    switch (kind) {
        case ProceduralKind::ValueNoise:
            return formulae::NOISE_VALUE;
        case ProceduralKind::PerlinNoise:
            return formulae::NOISE_PERLIN;
        case ProceduralKind::WorleyNoise:
            return formulae::NOISE_WORLEY;
    }
    return formulae::NOISE_VALUE;
}

void set_ramp(const std::vector<RampStop>& ramp, ProceduralTask& task) {
    task.stop_count = std::clamp(static_cast<int>(ramp.size()), 1, kMaxRampStops);
    for (std::size_t i = 0; i < ramp.size() && i < kMaxRampStops; ++i) {
        task.stop_positions[i] = ramp[i].position;
        for (int k = 0; k < 3; ++k) task.stop_values[i][k] = ramp[i].value[k];
    }
}

/// The longer side of a texel in units of the source's coordinates.
float texel_width(const SourceRecord& record, float size) {
    const float along_u = std::sqrt(record.to_u.x * record.to_u.x + record.to_v.x * record.to_v.x);
    const float along_v = std::sqrt(record.to_u.y * record.to_u.y + record.to_v.y * record.to_v.y);
    return std::max(along_u, along_v) / size;
}

}  // namespace

void procedural_tile(const SourceRecord& record, const TileSpan& span, float* const planes[3]) {
    const auto& source = std::get<ProceduralSource>(record.source);
    const float size = static_cast<float>(span.size);
    const float v = (static_cast<float>(span.y) + 0.5f) / size;
    const float cells = std::clamp(std::round(source.scale), 1.0f, kMaxCells);
    ProceduralTask task{.x = span.x,
                        .count = span.count,
                        .size = size,
                        .u_of_row = record.to_u.y * v + record.to_u.z,
                        .v_of_row = record.to_v.y * v + record.to_v.z,
                        .u_per_u = record.to_u.x,
                        .v_per_u = record.to_v.x,
                        .kind = noise_kind(source.kind),
                        .seed = source.seed,
                        .period = static_cast<int>(cells),
                        .octaves = std::clamp(source.octaves, 1, kMaxOctaves),
                        .gain = kOctaveGain,
                        .footprint = cells * texel_width(record, size),
                        .contrast = source.contrast,
                        .balance = source.balance,
                        .scalar = !is_vector(record.reading),
                        .encode = record.reading == Reading::EncodedColor,
                        .normalise = record.reading == Reading::Normal};
    set_ramp(source.ramp, task);
    run_procedural(task, planes);
}

}  // namespace patina
