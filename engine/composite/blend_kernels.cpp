// SPDX-License-Identifier: MIT
#include "composite/blend_kernels.h"

#include "composite/kernel_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "composite/blend_kernels.cpp"
#include <hwy/foreach_target.h>

#include "core/formulae/formulae-inl.h"

HWY_BEFORE_NAMESPACE();
namespace patina::HWY_NAMESPACE {
namespace {

using formulae::lane_count;
using formulae::load;
using formulae::Real;
using formulae::Real3;
using formulae::store;

HWY_INLINE Real load(const ReadPlane& plane, std::size_t i) {
    return load(plane.data + i * plane.step);
}

HWY_INLINE Real weight_at(const BlendTask& task, std::size_t i) {
    return load(task.weight, i) * task.amount;
}

/// Lays one component over an accumulator that has coverage.
HWY_INLINE Real over_covered(Real backdrop, Real coverage, Real source, Real blended, Real weight) {
    const Real laid = formulae::over_premultiplied(backdrop, coverage, source, blended, weight);
    return formulae::unpremultiplied(laid, formulae::over_coverage(coverage, weight));
}

/// The pixel loop of the modes that take each component by itself.
template <class Mode, int kComponents, bool kCovered>
HWY_NOINLINE HWY_FLATTEN void blend_components(const BlendTask& task) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(task.count); i += lane_count()) {
        const Real weight = weight_at(task, i);
        const Real coverage = kCovered ? load(task.target_coverage + i) : Real(1.0f);
        for (int k = 0; k < kComponents; ++k) {
            const Real backdrop = load(task.target[k] + i);
            const Real source = load(task.source[k], i);
            const Real blended = Mode::blend(backdrop, source);
            store(kCovered ? over_covered(backdrop, coverage, source, blended, weight)
                           : formulae::over_opaque(backdrop, blended, weight),
                  task.target[k] + i);
        }
        if (kCovered) store(formulae::over_coverage(coverage, weight), task.target_coverage + i);
    }
}

template <class Mode>
void blend_separable(const BlendTask& task) {
    const bool covered = task.target_coverage != nullptr;
    if (component_count(task.channel) == 3)
        covered ? blend_components<Mode, 3, true>(task) : blend_components<Mode, 3, false>(task);
    else
        covered ? blend_components<Mode, 1, true>(task) : blend_components<Mode, 1, false>(task);
}

/// The pixel loop of the modes of normals. Relief modes lay the source, faded to flat by the
/// weight, on what is below; in a group, where nothing is below the source stands by itself.
template <class Mode, bool kCovered>
HWY_NOINLINE HWY_FLATTEN void blend_directions(const BlendTask& task) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(task.count); i += lane_count()) {
        const Real weight = weight_at(task, i);
        const Real3 backdrop(load(task.target[0] + i), load(task.target[1] + i),
                             load(task.target[2] + i));
        const Real3 source(load(task.source[0], i), load(task.source[1], i),
                           load(task.source[2], i));
        Real3 result = Mode::laid(backdrop, source, weight);
        if (kCovered) {
            const Real coverage = load(task.target_coverage + i);
            result =
                formulae::unit_normal(result * coverage + source * (weight * (1.0f - coverage)));
            store(formulae::over_coverage(coverage, weight), task.target_coverage + i);
        }
        store(result.x, task.target[0] + i);
        store(result.y, task.target[1] + i);
        store(result.z, task.target[2] + i);
    }
}

template <class Mode>
void blend_normals(const BlendTask& task) {
    task.target_coverage != nullptr ? blend_directions<Mode, true>(task)
                                    : blend_directions<Mode, false>(task);
}

#define PATINA_SEPARABLE_MODE(NAME, FORMULA)                 \
    struct NAME {                                            \
        static HWY_INLINE Real blend(Real below, Real own) { \
            return formulae::FORMULA(below, own);            \
        }                                                    \
    };
PATINA_SEPARABLE_MODE(NormalMode, blend_normal)
PATINA_SEPARABLE_MODE(Darken, blend_darken)
PATINA_SEPARABLE_MODE(Multiply, blend_multiply)
PATINA_SEPARABLE_MODE(Lighten, blend_lighten)
PATINA_SEPARABLE_MODE(Screen, blend_screen)
PATINA_SEPARABLE_MODE(Add, blend_add)
PATINA_SEPARABLE_MODE(Overlay, blend_overlay)
PATINA_SEPARABLE_MODE(SoftLightW3c, blend_soft_light_w3c)
PATINA_SEPARABLE_MODE(Difference, blend_difference)
PATINA_SEPARABLE_MODE(Subtract, blend_subtract)
PATINA_SEPARABLE_MODE(HeightAdd, height_add)
PATINA_SEPARABLE_MODE(HeightMax, height_max)
#undef PATINA_SEPARABLE_MODE

#define PATINA_RELIEF_MODE(NAME, FORMULA)                                         \
    struct NAME {                                                                 \
        static HWY_INLINE Real3 laid(Real3 below, Real3 own, Real weight) {       \
            return formulae::FORMULA(below, formulae::normal_faded(own, weight)); \
        }                                                                         \
    };
PATINA_RELIEF_MODE(NormalRnm, normal_blend_rnm)
PATINA_RELIEF_MODE(NormalUdn, normal_blend_udn)
PATINA_RELIEF_MODE(NormalWhiteout, normal_blend_whiteout)
#undef PATINA_RELIEF_MODE

/// Normal mode on directions: from the backdrop to the source, kept unit.
struct NormalLerp {
    static HWY_INLINE Real3 laid(Real3 below, Real3 own, Real weight) {
        return formulae::normal_over(below, own, weight);
    }
};

void replace(const BlendTask& task) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(task.count); i += lane_count()) {
        for (int k = 0; k < component_count(task.channel); ++k)
            store(load(task.source[k], i), task.target[k] + i);
        if (task.target_coverage != nullptr) store(weight_at(task, i), task.target_coverage + i);
    }
}

void blend_by_mode(const BlendTask& task) {
    if (task.first) return replace(task);
    switch (task.mode) {
        case BlendMode::Normal:
            return task.channel == Channel::Normal ? blend_normals<NormalLerp>(task)
                                                   : blend_separable<NormalMode>(task);
        case BlendMode::Darken:
            return blend_separable<Darken>(task);
        case BlendMode::Multiply:
            return blend_separable<Multiply>(task);
        case BlendMode::Lighten:
            return blend_separable<Lighten>(task);
        case BlendMode::Screen:
            return blend_separable<Screen>(task);
        case BlendMode::Add:
            return blend_separable<Add>(task);
        case BlendMode::Overlay:
            return blend_separable<Overlay>(task);
        case BlendMode::SoftLightW3c:
            return blend_separable<SoftLightW3c>(task);
        case BlendMode::Difference:
            return blend_separable<Difference>(task);
        case BlendMode::Subtract:
            return blend_separable<Subtract>(task);
        case BlendMode::NormalRnm:
            return blend_normals<NormalRnm>(task);
        case BlendMode::NormalUdn:
            return blend_normals<NormalUdn>(task);
        case BlendMode::NormalWhiteout:
            return blend_normals<NormalWhiteout>(task);
        case BlendMode::HeightAdd:
            return blend_separable<HeightAdd>(task);
        case BlendMode::HeightMax:
            return blend_separable<HeightMax>(task);
    }
}

HWY_FLATTEN void multiply_planes(const ReadPlane& a, const ReadPlane& b, float* product,
                                 int count) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); i += lane_count())
        store(load(a, i) * load(b, i), product + i);
}

HWY_FLATTEN void encode_planes(float* const* planes, int count) {
    for (int k = 0; k < 3; ++k)
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); i += lane_count())
            store(formulae::srgb_from_linear(load(planes[k] + i)), planes[k] + i);
}

HWY_FLATTEN void decode_planes(float* const* planes, int count) {
    for (int k = 0; k < 3; ++k)
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); i += lane_count())
            store(formulae::linear_from_srgb(load(planes[k] + i)), planes[k] + i);
}

}  // namespace

}  // namespace patina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace patina {

HWY_EXPORT(blend_by_mode);
HWY_EXPORT(multiply_planes);
HWY_EXPORT(encode_planes);
HWY_EXPORT(decode_planes);

void blend_tile(const BlendTask& task) {
    HWY_DYNAMIC_DISPATCH(blend_by_mode)(task);
}

void multiply_tile(const ReadPlane& a, const ReadPlane& b, float* product, int count) {
    HWY_DYNAMIC_DISPATCH(multiply_planes)(a, b, product, count);
}

void encode_tile(float* const planes[3], int count) {
    HWY_DYNAMIC_DISPATCH(encode_planes)(planes, count);
}

void decode_tile(float* const planes[3], int count) {
    HWY_DYNAMIC_DISPATCH(decode_planes)(planes, count);
}

}  // namespace patina
#endif
