// SPDX-License-Identifier: MIT
#include "composite/procedural.h"

#include <algorithm>
#include <cmath>

#include "composite/procedural_kernels.h"
#include "core/formulae/formulae.h"
#include "core/r2_sequence.h"

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
        case ProceduralKind::ValueNoise:
        case ProceduralKind::PerlinNoise:
        case ProceduralKind::WorleyNoise:
        case ProceduralKind::SimplexNoise:
        case ProceduralKind::RidgedNoise:
        case ProceduralKind::Turbulence:
        case ProceduralKind::WorleyF2:
        case ProceduralKind::WorleyEdges:
        case ProceduralKind::Cells:
        case ProceduralKind::GradientLinear:
        case ProceduralKind::GradientRadial:
        case ProceduralKind::GradientAngular:
        case ProceduralKind::Stripes:
        case ProceduralKind::Tiles:
        case ProceduralKind::Spots:
        case ProceduralKind::Scratches:
        case ProceduralKind::Cracks:
        case ProceduralKind::WoodRings:
        case ProceduralKind::Marble:
        case ProceduralKind::Grunge:
            break;
    }
    return {cells, cells};
}

void set_ramp(const std::vector<RampStop>& ramp, ProceduralTask& task) {
    task.stop_count = std::clamp(static_cast<int>(ramp.size()), 1, kMaxRampStops);
    for (std::size_t i = 0; i < ramp.size() && i < kMaxRampStops; ++i) {
        task.stop_positions[i] = ramp[i].position;
        for (int k = 0; k < 3; ++k) task.stop_values[i][k] = ramp[i].value[k];
    }
}

/// All that is the same in every texel of every size; of a row as wide as the texture at first.
ProceduralTask task_of(const ProceduralSource& source) {
    const Cells cells = cells_of(source);
    ProceduralTask task{.kind = source.kind,
                        .seed = source.seed,
                        .columns = cells.columns,
                        .rows = cells.rows,
                        .octaves = std::clamp(source.octaves, 1, kMaxOctaves),
                        .width = source.width,
                        .softness = source.softness,
                        .variation = source.variation,
                        .warp = source.warp,
                        .contrast = source.contrast,
                        .balance = source.balance};
    set_ramp(source.ramp, task);
    return task;
}

/// The longer side of a texel in cells.
float texel_width(const SourceRecord& record, const ProceduralTask& task) {
    const auto columns = static_cast<float>(task.columns);
    const auto rows = static_cast<float>(task.rows);
    const auto length = [&](float u, float v) {
        return std::sqrt(u * u * columns * columns + v * v * rows * rows);
    };
    return std::max(length(record.to_u.x, record.to_v.x), length(record.to_u.y, record.to_v.y)) /
           task.size;
}

/// Points that lie evenly in the texture and on no grid that its cells could lie on too.
constexpr int kEvenPoints = 1024;
struct EvenPoints {
    alignas(64) float u[kEvenPoints];
    alignas(64) float v[kEvenPoints];
};
const EvenPoints& even_points() {
    static const EvenPoints points = [] {
        EvenPoints made;
        for (int i = 0; i < kEvenPoints; ++i) {
            const R2Point point = r2_point(i);
            made.u[i] = static_cast<float>(point.u);
            made.v[i] = static_cast<float>(point.v);
        }
        return made;
    }();
    return points;
}

}  // namespace

glm::vec3 procedural_mean(const ProceduralSource& source, bool scalar) {
    ProceduralTask task = task_of(source);
    task.count = kEvenPoints;
    task.u = even_points().u;
    task.v = even_points().v;
    task.scalar = scalar;
    alignas(64) float values[3][kEvenPoints] = {};
    float* const planes[3] = {values[0], values[1], values[2]};
    run_pattern(task, planes[0]);
    run_ramp(task, planes[0], planes);
    glm::dvec3 sum(0.0);
    for (int i = 0; i < kEvenPoints; ++i)
        sum += glm::dvec3(values[0][i], values[1][i], values[2][i]);
    return glm::vec3(sum / double{kEvenPoints});
}

void procedural_tile(const SourceRecord& record, const TileSpan& span, const TileCoordinates& at,
                     float* const planes[3], PatternPlanes& patterns) {
    ProceduralTask task = task_of(std::get<ProceduralSource>(record.source));
    task.x = span.x;
    task.count = span.count;
    task.size = static_cast<float>(span.size);
    const float v = (static_cast<float>(span.y) + 0.5f) / task.size;
    task.u_of_row = record.to_u.y * v + record.to_u.z;
    task.v_of_row = record.to_v.y * v + record.to_v.z;
    task.u_per_u = record.to_u.x;
    task.v_per_u = record.to_v.x;
    task.u = at.u;
    task.v = at.v;
    task.footprint = texel_width(record, task) * (at.u != nullptr ? record.length_per_uv : 1.0f);
    for (int k = 0; k < 3; ++k) task.mean[k] = record.mean[k];
    task.scalar = !is_vector(record.reading);
    task.encode = record.reading == Reading::EncodedColor;
    task.normalise = record.reading == Reading::Normal;
    float* pattern = planes[0];
    bool is_filled = false;
    if (record.pattern >= 0 && at.u == nullptr)
        pattern = patterns.at(record.pattern, span, is_filled);
    if (!is_filled) run_pattern(task, pattern);
    run_ramp(task, pattern, planes);
}

}  // namespace patina
