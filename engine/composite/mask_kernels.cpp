// SPDX-License-Identifier: MIT
#include "composite/mask_kernels.h"

#include "composite/kernel_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "composite/mask_kernels.cpp"
#include <hwy/foreach_target.h>

#include "core/formulae/formulae-inl.h"

HWY_BEFORE_NAMESPACE();
namespace patina::HWY_NAMESPACE {
namespace {

using formulae::lane_count;
using formulae::load;
using formulae::Real;
using formulae::store;

HWY_INLINE Real load(const ReadPlane& plane, std::size_t i) {
    return load(plane.data + i * plane.step);
}

HWY_INLINE Real entry_at(const MaskTask& task, std::size_t i) {
    Real value = load(task.source, i);
    if (task.invert) value = formulae::inverted(value);
    if (task.levels == nullptr) return value;
    return formulae::levels(value, task.levels->in_low, task.levels->in_high, task.levels->gamma,
                            task.levels->out_low, task.levels->out_high);
}

template <class Combine>
HWY_NOINLINE HWY_FLATTEN void join(const MaskTask& task) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(task.count); i += lane_count()) {
        const Real below = load(task.mask + i);
        const Real joined = Combine::joined(below, entry_at(task, i));
        store(mix(below, joined, task.opacity), task.mask + i);
    }
}

HWY_NOINLINE HWY_FLATTEN void begin_with_entry(const MaskTask& task) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(task.count); i += lane_count())
        store(entry_at(task, i), task.mask + i);
}

#define PATINA_COMBINE(NAME, FORMULA)                           \
    struct NAME {                                               \
        static HWY_INLINE Real joined(Real below, Real entry) { \
            return formulae::FORMULA(below, entry);             \
        }                                                       \
    };
PATINA_COMBINE(Replace, mask_replace)
PATINA_COMBINE(Multiply, mask_multiply)
PATINA_COMBINE(Add, mask_add)
PATINA_COMBINE(Subtract, mask_subtract)
PATINA_COMBINE(Lighten, mask_lighten)
PATINA_COMBINE(Darken, mask_darken)
#undef PATINA_COMBINE

void join_by_combine(const MaskTask& task) {
    if (task.first) return begin_with_entry(task);
    switch (task.combine) {
        case MaskCombine::Replace:
            return join<Replace>(task);
        case MaskCombine::Multiply:
            return join<Multiply>(task);
        case MaskCombine::Add:
            return join<Add>(task);
        case MaskCombine::Subtract:
            return join<Subtract>(task);
        case MaskCombine::Lighten:
            return join<Lighten>(task);
        case MaskCombine::Darken:
            return join<Darken>(task);
    }
}

HWY_FLATTEN bool finish(float* mask, bool invert, int count) {
    namespace hn = hwy::HWY_NAMESPACE;
    const std::size_t end = static_cast<std::size_t>(count);
    Real most = 0.0f;
    for (std::size_t i = 0; i < end; i += lane_count()) {
        Real value = clamp(load(mask + i), 0.0f, 1.0f);
        if (invert) value = formulae::inverted(value);
        store(value, mask + i);
        // Lanes beyond the last texel hold anything and must not count.
        const auto inside = hn::FirstN(formulae::RealLanes(), end - i);
        most = max(most, Real(hn::IfThenElseZero(inside, value.lanes)));
    }
    return !hn::AllTrue(formulae::RealLanes(), (most <= 0.0f).mask);
}

HWY_FLATTEN void share_by_height(const HeightShareTask& task) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(task.count); i += lane_count()) {
        const Real below = load(task.below, i) * load(task.below_coverage, i);
        const Real own = load(task.own, i) * load(task.own_coverage, i);
        const Real share = formulae::height_share(below, own, task.blend.offset, task.blend.radius,
                                                  task.blend.contrast);
        store(load(task.mask + i) * share, task.mask + i);
    }
}

HWY_FLATTEN void fill(float* plane, float value, int count) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); i += lane_count())
        store(Real(value), plane + i);
}

HWY_FLATTEN void copy(const float* from, float* to, int count) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); i += lane_count())
        store(load(from + i), to + i);
}

}  // namespace

}  // namespace patina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace patina {

HWY_EXPORT(join_by_combine);
HWY_EXPORT(finish);
HWY_EXPORT(share_by_height);
HWY_EXPORT(fill);
HWY_EXPORT(copy);

void join_mask_tile(const MaskTask& task) {
    HWY_DYNAMIC_DISPATCH(join_by_combine)(task);
}

bool finish_mask_tile(float* mask, bool invert, int count) {
    return HWY_DYNAMIC_DISPATCH(finish)(mask, invert, count);
}

void share_by_height_tile(const HeightShareTask& task) {
    HWY_DYNAMIC_DISPATCH(share_by_height)(task);
}

void fill_tile(float* plane, float value, int count) {
    HWY_DYNAMIC_DISPATCH(fill)(plane, value, count);
}

void copy_tile(const float* from, float* to, int count) {
    HWY_DYNAMIC_DISPATCH(copy)(from, to, count);
}

}  // namespace patina
#endif
