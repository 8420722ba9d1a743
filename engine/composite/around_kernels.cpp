// SPDX-License-Identifier: MIT
#include "composite/around_kernels.h"

#include "composite/kernel_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "composite/around_kernels.cpp"
#include <hwy/foreach_target.h>

#include "composite/plane_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace patina::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using formulae::Real2;

/// Four runs of lanes at once, whose sums do not wait for each other.
HWY_FLATTEN void blur(const BlurTask& task) {
    const float* const* const middle = task.lines + task.reach;
    const std::size_t lanes = lane_count();
    for (std::size_t i = 0; i < static_cast<std::size_t>(task.count); i += 4 * lanes) {
        Real sums[4];
        for (std::size_t k = 0; k < 4; ++k)
            sums[k] = load(middle[0] + i + k * lanes) * task.weights[0];
        for (int j = 1; j <= task.reach; ++j)
            for (std::size_t k = 0; k < 4; ++k) {
                const std::size_t at = i + k * lanes;
                const Real both = load(middle[-j] + at) + load(middle[j] + at);
                sums[k] = sums[k] + both * task.weights[j];
            }
        for (std::size_t k = 0; k < 4; ++k) store(sums[k], task.sums + i + k * lanes);
    }
}

HWY_FLATTEN void divide_by_coverage(float* sums, const float* coverage_sums, const float* own,
                                    int count) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); i += lane_count()) {
        const Real coverage = load(coverage_sums + i);
        store(select(coverage > 0.0f, formulae::unpremultiplied(load(sums + i), coverage),
                     load(own + i)),
              sums + i);
    }
}

HWY_FLATTEN void sharpen(float* blurred, const float* own, float amount, bool hold, int count) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); i += lane_count()) {
        const Real sharp = formulae::sharpened(load(own + i), load(blurred + i), amount);
        store(hold ? clamp(sharp, 0.0f, 1.0f) : sharp, blurred + i);
    }
}

HWY_FLATTEN void normalise(float* const* planes, int count) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); i += lane_count())
        store(formulae::unit_normal(load(planes, i)), planes, i);
}

HWY_FLATTEN void relief(int kind, const float* own, float strength, float* around, int count) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); i += lane_count())
        store(formulae::relief_value(kind, load(own + i), load(around + i), strength), around + i);
}

HWY_FLATTEN void warp(const WarpTask& task) {
    const float cells = static_cast<float>(task.cells);
    const float row = (static_cast<float>(task.y) + 0.5f) / task.size * cells;
    for (int i = 0; i < task.count; i += static_cast<int>(lane_count())) {
        const formulae::Int column(hn::Iota(formulae::IntLanes(), task.x + i));
        const Real2 position((Real(column) + 0.5f) / task.size * cells, Real(row));
        const Real2 direction = formulae::warp_direction(position, task.cells, task.seed,
                                                         task.octaves, cells / task.size);
        store(direction.x * task.distance_texels, task.right + i);
        store(direction.y * task.distance_texels, task.down + i);
    }
}

}  // namespace

}  // namespace patina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace patina {

HWY_EXPORT(blur);
HWY_EXPORT(divide_by_coverage);
HWY_EXPORT(sharpen);
HWY_EXPORT(normalise);
HWY_EXPORT(relief);
HWY_EXPORT(warp);

void blur_tile(const BlurTask& task) {
    HWY_DYNAMIC_DISPATCH(blur)(task);
}

void divide_by_coverage_tile(float* sums, const float* coverage_sums, const float* own, int count) {
    HWY_DYNAMIC_DISPATCH(divide_by_coverage)(sums, coverage_sums, own, count);
}

void sharpen_tile(float* blurred, const float* own, float amount, bool hold, int count) {
    HWY_DYNAMIC_DISPATCH(sharpen)(blurred, own, amount, hold, count);
}

void normalise_tile(float* const planes[3], int count) {
    HWY_DYNAMIC_DISPATCH(normalise)(planes, count);
}

void relief_tile(int kind, const float* own, float strength, float* around, int count) {
    HWY_DYNAMIC_DISPATCH(relief)(kind, own, strength, around, count);
}

void warp_tile(const WarpTask& task) {
    HWY_DYNAMIC_DISPATCH(warp)(task);
}

}  // namespace patina
#endif
