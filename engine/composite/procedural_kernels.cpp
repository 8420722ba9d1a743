// SPDX-License-Identifier: MIT
#include "composite/procedural_kernels.h"

#include "composite/kernel_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "composite/procedural_kernels.cpp"
#include <hwy/foreach_target.h>

#include "core/formulae/formulae-inl.h"

HWY_BEFORE_NAMESPACE();
namespace patina::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using formulae::lane_count;
using formulae::load;
using formulae::Real;
using formulae::Real2;
using formulae::Real3;
using formulae::store;

formulae::Ramp ramp_of(const ProceduralTask& task) {
    formulae::Ramp ramp;
    ramp.count = task.stop_count;
    for (int i = 0; i < task.stop_count; ++i) {
        const float* const value = task.stop_values[i];
        ramp.stops[i] = {task.stop_positions[i], value[0], value[1], value[2]};
    }
    return ramp;
}

/// Where texels from number `i` on lie, in cells.
HWY_INLINE Real2 position_at(const ProceduralTask& task, int i) {
    if (task.u != nullptr)
        return Real2(load(task.u + i) * static_cast<float>(task.columns),
                     load(task.v + i) * static_cast<float>(task.rows));
    const formulae::Int column(hn::Iota(formulae::IntLanes(), task.x + i));
    const Real u = (Real(column) + 0.5f) / task.size;
    return Real2((u * task.u_per_u + task.u_of_row) * static_cast<float>(task.columns),
                 (u * task.v_per_u + task.v_of_row) * static_cast<float>(task.rows));
}

/// The pattern of one kind, before contrast and ramp. One copy for each kind, so that no lane asks
/// which it is.
template <int kKind>
HWY_NOINLINE HWY_FLATTEN void pattern_run(const ProceduralTask& task, float* plane) {
    const formulae::Pattern pattern = {kKind,        task.columns,  task.rows,     task.seed,
                                       task.octaves, task.width,    task.softness, task.variation,
                                       task.warp,    task.footprint};
    for (int i = 0; i < task.count; i += static_cast<int>(lane_count()))
        store(formulae::pattern_value(pattern, position_at(task, i)), plane + i);
}

void pattern_by_kind(const ProceduralTask& task, float* plane) {
    switch (task.kind) {
        case ProceduralKind::ValueNoise:
            return pattern_run<formulae::NOISE_VALUE>(task, plane);
        case ProceduralKind::PerlinNoise:
            return pattern_run<formulae::NOISE_PERLIN>(task, plane);
        case ProceduralKind::WorleyNoise:
            return pattern_run<formulae::NOISE_WORLEY>(task, plane);
        case ProceduralKind::SimplexNoise:
            return pattern_run<formulae::NOISE_SIMPLEX>(task, plane);
        case ProceduralKind::RidgedNoise:
            return pattern_run<formulae::NOISE_RIDGED>(task, plane);
        case ProceduralKind::Turbulence:
            return pattern_run<formulae::NOISE_TURBULENCE>(task, plane);
        case ProceduralKind::WorleyF2:
            return pattern_run<formulae::NOISE_WORLEY_F2>(task, plane);
        case ProceduralKind::WorleyEdges:
            return pattern_run<formulae::NOISE_WORLEY_EDGES>(task, plane);
        case ProceduralKind::Cells:
            return pattern_run<formulae::NOISE_CELLS>(task, plane);
        case ProceduralKind::GradientLinear:
            return pattern_run<formulae::PATTERN_GRADIENT_LINEAR>(task, plane);
        case ProceduralKind::GradientRadial:
            return pattern_run<formulae::PATTERN_GRADIENT_RADIAL>(task, plane);
        case ProceduralKind::GradientAngular:
            return pattern_run<formulae::PATTERN_GRADIENT_ANGULAR>(task, plane);
        case ProceduralKind::Checker:
            return pattern_run<formulae::PATTERN_CHECKER>(task, plane);
        case ProceduralKind::Stripes:
            return pattern_run<formulae::PATTERN_STRIPES>(task, plane);
        case ProceduralKind::Bricks:
            return pattern_run<formulae::PATTERN_BRICKS>(task, plane);
        case ProceduralKind::Tiles:
            return pattern_run<formulae::PATTERN_TILES>(task, plane);
        case ProceduralKind::Hexagons:
            return pattern_run<formulae::PATTERN_HEXAGONS>(task, plane);
        case ProceduralKind::Weave:
            return pattern_run<formulae::PATTERN_WEAVE>(task, plane);
        case ProceduralKind::Spots:
            return pattern_run<formulae::PATTERN_SPOTS>(task, plane);
        case ProceduralKind::Scratches:
            return pattern_run<formulae::PATTERN_SCRATCHES>(task, plane);
        case ProceduralKind::Cracks:
            return pattern_run<formulae::PATTERN_CRACKS>(task, plane);
        case ProceduralKind::WoodRings:
            return pattern_run<formulae::PATTERN_WOOD_RINGS>(task, plane);
        case ProceduralKind::Marble:
            return pattern_run<formulae::PATTERN_MARBLE>(task, plane);
        case ProceduralKind::Grunge:
            return pattern_run<formulae::PATTERN_GRUNGE>(task, plane);
    }
}

HWY_INLINE Real contrasted_at(const ProceduralTask& task, const float* plane, int i) {
    const Real value = load(plane + i);
    if (task.contrast == 0.0f) return value;
    return formulae::contrasted(value, task.contrast, task.balance);
}

HWY_NOINLINE HWY_FLATTEN void scalar_ramp(const ProceduralTask& task, float* plane) {
    const formulae::Ramp ramp = ramp_of(task);
    for (int i = 0; i < task.count; i += static_cast<int>(lane_count()))
        store(formulae::ramp_scalar(ramp, contrasted_at(task, plane, i)), plane + i);
}

/// From the pattern in planes[0].
HWY_NOINLINE HWY_FLATTEN void vector_ramp(const ProceduralTask& task, float* const* planes) {
    const formulae::Ramp ramp = ramp_of(task);
    for (int i = 0; i < task.count; i += static_cast<int>(lane_count())) {
        Real3 value = formulae::ramp_color(ramp, contrasted_at(task, planes[0], i));
        if (task.encode) value = formulae::srgb_from_linear(value);
        if (task.normalise) value = formulae::unit_normal(value);
        store(value.x, planes[0] + i);
        store(value.y, planes[1] + i);
        store(value.z, planes[2] + i);
    }
}

void run(const ProceduralTask& task, float* const* planes) {
    pattern_by_kind(task, planes[0]);
    task.scalar ? scalar_ramp(task, planes[0]) : vector_ramp(task, planes);
}

}  // namespace

}  // namespace patina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace patina {

HWY_EXPORT(run);

void run_procedural(const ProceduralTask& task, float* const planes[3]) {
    HWY_DYNAMIC_DISPATCH(run)(task, planes);
}

}  // namespace patina
#endif
