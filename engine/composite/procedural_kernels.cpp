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

/// The noise, with contrast, at lane_count() texels from `x` on, before the ramp.
HWY_INLINE Real noise_at(const ProceduralTask& task, int x) {
    const formulae::Int column(hn::Iota(formulae::IntLanes(), x));
    const Real u = (Real(column) + 0.5f) / task.size;
    const float cells = static_cast<float>(task.period);
    const Real2 position((u * task.u_per_u + task.u_of_row) * cells,
                         (u * task.v_per_u + task.v_of_row) * cells);
    const Real noise = formulae::fbm(task.kind, position, task.period, task.seed, task.octaves,
                                     task.gain, task.footprint);
    if (task.contrast == 0.0f) return noise;
    return formulae::contrasted(noise, task.contrast, task.balance);
}

HWY_NOINLINE HWY_FLATTEN void scalar_run(const ProceduralTask& task, float* plane) {
    const formulae::Ramp ramp = ramp_of(task);
    for (int i = 0; i < task.count; i += static_cast<int>(lane_count()))
        store(formulae::ramp_scalar(ramp, noise_at(task, task.x + i)), plane + i);
}

HWY_NOINLINE HWY_FLATTEN void vector_run(const ProceduralTask& task, float* const* planes) {
    const formulae::Ramp ramp = ramp_of(task);
    for (int i = 0; i < task.count; i += static_cast<int>(lane_count())) {
        Real3 value = formulae::ramp_color(ramp, noise_at(task, task.x + i));
        if (task.encode) value = formulae::srgb_from_linear(value);
        if (task.normalise) value = formulae::unit_normal(value);
        store(value.x, planes[0] + i);
        store(value.y, planes[1] + i);
        store(value.z, planes[2] + i);
    }
}

void run(const ProceduralTask& task, float* const* planes) {
    task.scalar ? scalar_run(task, planes[0]) : vector_run(task, planes);
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
