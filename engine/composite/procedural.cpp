// SPDX-License-Identifier: MIT
#include "composite/procedural.h"

#include <algorithm>
#include <cmath>

#include "composite/procedural_kernels.h"
#include "core/formulae/formulae.h"

namespace patina {
namespace {

constexpr float kMaxCells = 512.0f;
constexpr int kMaxOctaves = 10;

struct Cells {
    int columns;
    int rows;
};

int next_even(int count) {
    return count + (count & 1);
}

/// How many cells of the kind lie across the texture and down, so that it tiles. Patterns that
/// alternate have an even number.
Cells cells_of(const ProceduralSource& source) {
    const float scale = std::clamp(std::round(source.scale), 1.0f, kMaxCells);
    const int cells = static_cast<int>(scale);
    switch (source.kind) {
        case ProceduralKind::Checker:
        case ProceduralKind::Weave:
            return {next_even(cells), next_even(cells)};
        case ProceduralKind::Bricks: {
            const int rows = next_even(cells);
            const float columns = std::round(static_cast<float>(rows) / source.aspect);
            return {std::max(static_cast<int>(columns), 1), rows};
        }
        case ProceduralKind::Hexagons:
            // Rows are sqrt(3)/2 of a column's width apart.
            return {cells, std::max(2 * static_cast<int>(std::round(scale * 0.577350269f)), 2)};
        default:
            return {cells, cells};
    }
}

void set_ramp(const std::vector<RampStop>& ramp, ProceduralTask& task) {
    task.stop_count = std::clamp(static_cast<int>(ramp.size()), 1, kMaxRampStops);
    for (std::size_t i = 0; i < ramp.size() && i < kMaxRampStops; ++i) {
        task.stop_positions[i] = ramp[i].position;
        for (int k = 0; k < 3; ++k) task.stop_values[i][k] = ramp[i].value[k];
    }
}

/// The longer side of a texel in cells.
float texel_width(const SourceRecord& record, const Cells& cells, float size) {
    const auto columns = static_cast<float>(cells.columns);
    const auto rows = static_cast<float>(cells.rows);
    const auto length = [&](float u, float v) {
        return std::sqrt(u * u * columns * columns + v * v * rows * rows);
    };
    return std::max(length(record.to_u.x, record.to_v.x), length(record.to_u.y, record.to_v.y)) /
           size;
}

}  // namespace

void procedural_tile(const SourceRecord& record, const TileSpan& span, const TileCoordinates& at,
                     float* const planes[3]) {
    const auto& source = std::get<ProceduralSource>(record.source);
    const float size = static_cast<float>(span.size);
    const float v = (static_cast<float>(span.y) + 0.5f) / size;
    const Cells cells = cells_of(source);
    ProceduralTask task{.x = span.x,
                        .count = span.count,
                        .size = size,
                        .u_of_row = record.to_u.y * v + record.to_u.z,
                        .v_of_row = record.to_v.y * v + record.to_v.z,
                        .u_per_u = record.to_u.x,
                        .v_per_u = record.to_v.x,
                        .u = at.u,
                        .v = at.v,
                        .kind = source.kind,
                        .seed = source.seed,
                        .columns = cells.columns,
                        .rows = cells.rows,
                        .octaves = std::clamp(source.octaves, 1, kMaxOctaves),
                        .width = source.width,
                        .softness = source.softness,
                        .variation = source.variation,
                        .warp = source.warp,
                        .footprint = texel_width(record, cells, size) *
                                     (at.u != nullptr ? record.length_per_uv : 1.0f),
                        .contrast = source.contrast,
                        .balance = source.balance,
                        .scalar = !is_vector(record.reading),
                        .encode = record.reading == Reading::EncodedColor,
                        .normalise = record.reading == Reading::Normal};
    set_ramp(source.ramp, task);
    run_procedural(task, planes);
}

}  // namespace patina
