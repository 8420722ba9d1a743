// SPDX-License-Identifier: MIT
#include "composite/blend_kernels.h"

#include "composite/kernel_targets.h"
#include "composite/scalar_modes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "composite/blend_kernels.cpp"
#include <hwy/foreach_target.h>

#include "composite/texel_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace patina::HWY_NAMESPACE {
namespace {

/// What reads the source of a task from planes; FromTexels reads texels as they are stored.
template <int kComponents>
struct FromPlanes {
    static HWY_INLINE PlaneReader<kComponents> of(const BlendTask& task) {
        return PlaneReader<kComponents>(task.source);
    }
};

/// What `choose` gives for that which reads the colours of the source.
template <class Choose>
BlendKernel for_colors(const BlendTask& task, const Choose& choose) {
    const StoredTexels& stored = task.stored;
    if (stored.texels == nullptr) return choose(FromPlanes<3>());
    if (stored.channels == 3)
        return stored.decode ? choose(FromTexels<3, 0, 3, Decoded>())
                             : choose(FromTexels<3, 0, 3>());
    return stored.decode ? choose(FromTexels<4, 0, 3, Decoded>()) : choose(FromTexels<4, 0, 3>());
}

/// Calls `at(i)` for lanes of the blocks in which the weight may be more than 0.
template <class At>
HWY_INLINE void for_each_lanes(const BlendTask& task, const At& at) {
    for (TileBlocks left = task.blocks; left != 0;) {
        const TexelRun run = take_run(left, task.count);
        for (std::size_t i = run.begin; i < run.end; i += lane_count()) at(i);
    }
}

HWY_INLINE Real weight_at(const BlendTask& task, std::size_t i) {
    return load(task.weight, i) * task.amount;
}

/// Lays one component over an accumulator that has coverage.
HWY_INLINE Real over_covered(Real backdrop, Real coverage, Real source, Real blended, Real weight) {
    const Real laid = formulae::over_premultiplied(backdrop, coverage, source, blended, weight);
    const Real color = formulae::unpremultiplied(laid, formulae::over_coverage(coverage, weight));
    return select(weight > 0.0f, color, backdrop);
}

/// The pixel loop of the modes that take each component by itself. It works on a copy of the task:
/// no float that is stored can be a part of it.
template <class Mode, int kComponents, bool kCovered, class Source>
HWY_NOINLINE HWY_FLATTEN void blend_components(const BlendTask& given) {
    const BlendTask task = given;
    const auto from = Source::of(task);
    for_each_lanes(task, [&](std::size_t i) {
        const Real weight = weight_at(task, i);
        const Real coverage = kCovered ? load(task.target_coverage + i) : Real(1.0f);
        Real source[kComponents];
        from.load(i, source);
        for (int k = 0; k < kComponents; ++k) {
            const Real backdrop = load(task.target[k] + i);
            const Real blended = Mode::blend(backdrop, source[k]);
            store(kCovered ? over_covered(backdrop, coverage, source[k], blended, weight)
                           : formulae::over_opaque(backdrop, blended, weight),
                  task.target[k] + i);
        }
        if (kCovered) store(formulae::over_coverage(coverage, weight), task.target_coverage + i);
    });
}

template <class Mode>
BlendKernel separable(const BlendTask& task) {
    const bool color = component_count(task.channel) == 3;
    if (task.target_coverage != nullptr)
        return color ? blend_components<Mode, 3, true, FromPlanes<3>>
                     : blend_components<Mode, 1, true, FromPlanes<1>>;
    if (color)
        return for_colors(task, []<class Source>(Source) -> BlendKernel {
            return blend_components<Mode, 3, false, Source>;
        });
    return task.stored.texels == nullptr ? blend_components<Mode, 1, false, FromPlanes<1>>
                                         : blend_components<Mode, 1, false, FromTexels<1, 0, 1>>;
}

/// The pixel loop of the modes of normals. Relief modes lay the source, faded to flat by the
/// weight, on what is below; in a group, where nothing is below the source stands by itself.
template <class Mode, bool kCovered>
HWY_NOINLINE HWY_FLATTEN void blend_directions(const BlendTask& task) {
    for_each_lanes(task, [&](std::size_t i) {
        const Real weight = weight_at(task, i);
        const Real3 backdrop = load(task.target, i);
        const Real3 source = load(task.source, i);
        Real3 result = Mode::laid(backdrop, source, weight);
        if (kCovered) {
            const Real coverage = load(task.target_coverage + i);
            result = formulae::normal_in_group(result, coverage, source, weight);
            store(formulae::over_coverage(coverage, weight), task.target_coverage + i);
        }
        store(select(weight > 0.0f, result, backdrop), task.target, i);
    });
}

template <class Mode>
BlendKernel of_normals(const BlendTask& task) {
    return task.target_coverage != nullptr ? blend_directions<Mode, true>
                                           : blend_directions<Mode, false>;
}

/// The pixel loop of the modes that look at a colour as a whole.
template <class Mode, bool kCovered, class Source>
HWY_NOINLINE HWY_FLATTEN void blend_whole_colors(const BlendTask& given) {
    const BlendTask task = given;
    const auto from = Source::of(task);
    for_each_lanes(task, [&](std::size_t i) {
        const Real weight = weight_at(task, i);
        const Real coverage = kCovered ? load(task.target_coverage + i) : Real(1.0f);
        const Real3 backdrop = load(task.target, i);
        Real values[3];
        from.load(i, values);
        const Real3 source(values[0], values[1], values[2]);
        const Real3 blended = Mode::blend(backdrop, source);
        const auto laid = [&](Real below, Real own, Real mixed) {
            return kCovered ? over_covered(below, coverage, own, mixed, weight)
                            : formulae::over_opaque(below, mixed, weight);
        };
        store(Real3(laid(backdrop.x, source.x, blended.x), laid(backdrop.y, source.y, blended.y),
                    laid(backdrop.z, source.z, blended.z)),
              task.target, i);
        if (kCovered) store(formulae::over_coverage(coverage, weight), task.target_coverage + i);
    });
}

template <class Mode>
BlendKernel of_colors(const BlendTask& task) {
    if (task.target_coverage != nullptr) return blend_whole_colors<Mode, true, FromPlanes<3>>;
    return for_colors(task, []<class Source>(Source) -> BlendKernel {
        return blend_whole_colors<Mode, false, Source>;
    });
}

/// The source takes the place of the accumulator, its clear parts included; an accumulator that is
/// opaque stays so, and keeps its value where nothing at all is left.
HWY_INLINE void replace_lanes(const BlendTask& task, std::size_t i) {
    const Real weight = weight_at(task, i);
    const Real own = load(task.source_coverage, i);
    const Real coverage =
        task.target_coverage != nullptr ? load(task.target_coverage + i) : Real(1.0f);
    const Real left = formulae::replaced_coverage(coverage, own, weight);
    const int components = component_count(task.channel);
    Real backdrop[3];
    Real values[3] = {0.0f, 0.0f, 0.0f};
    for (int k = 0; k < components; ++k) {
        backdrop[k] = load(task.target[k] + i);
        const Real laid = formulae::replaced_premultiplied(backdrop[k], coverage,
                                                           load(task.source[k], i), own, weight);
        values[k] = select(left > 0.0f, formulae::unpremultiplied(laid, left), backdrop[k]);
    }
    if (task.channel == Channel::Normal) {
        const Real3 unit = formulae::unit_normal(Real3(values[0], values[1], values[2]));
        values[0] = unit.x;
        values[1] = unit.y;
        values[2] = unit.z;
    }
    const auto changes = weight > 0.0f;
    for (int k = 0; k < components; ++k)
        store(select(changes, values[k], backdrop[k]), task.target[k] + i);
    if (task.target_coverage != nullptr)
        store(select(changes, left, coverage), task.target_coverage + i);
}

HWY_NOINLINE HWY_FLATTEN void blend_replacing(const BlendTask& task) {
    for_each_lanes(task, [&](std::size_t i) { replace_lanes(task, i); });
}

#define PATINA_SEPARABLE_MODE(NAME, FORMULA)                 \
    struct NAME {                                            \
        static HWY_INLINE Real blend(Real below, Real own) { \
            return formulae::FORMULA(below, own);            \
        }                                                    \
    };
PATINA_SEPARABLE_MODE(NormalMode, blend_normal)
PATINA_SCALAR_MODES(PATINA_SEPARABLE_MODE)
PATINA_SEPARABLE_MODE(HeightAdd, height_add)
PATINA_SEPARABLE_MODE(HeightMax, height_max)
PATINA_SEPARABLE_MODE(HeightMin, height_min)
PATINA_SEPARABLE_MODE(HeightSubtract, height_subtract)
#undef PATINA_SEPARABLE_MODE

#define PATINA_COLOR_MODE(NAME, FORMULA)                        \
    struct NAME {                                               \
        static HWY_INLINE Real3 blend(Real3 below, Real3 own) { \
            return formulae::FORMULA(below, own);               \
        }                                                       \
    };
PATINA_COLOR_MODE(HueW3c, blend_hue_w3c)
PATINA_COLOR_MODE(SaturationW3c, blend_saturation_w3c)
PATINA_COLOR_MODE(ColorW3c, blend_color_w3c)
PATINA_COLOR_MODE(LuminosityW3c, blend_luminosity_w3c)
PATINA_COLOR_MODE(TintHsv, blend_tint_hsv)
PATINA_COLOR_MODE(SaturationHsv, blend_saturation_hsv)
PATINA_COLOR_MODE(ColorHsv, blend_color_hsv)
PATINA_COLOR_MODE(ValueHsv, blend_value_hsv)
#undef PATINA_COLOR_MODE

#define PATINA_RELIEF_MODE(NAME, FORMULA)                                         \
    struct NAME {                                                                 \
        static HWY_INLINE Real3 laid(Real3 below, Real3 own, Real weight) {       \
            return formulae::FORMULA(below, formulae::normal_faded(own, weight)); \
        }                                                                         \
    };
PATINA_RELIEF_MODE(NormalRnm, normal_blend_rnm)
PATINA_RELIEF_MODE(NormalUdn, normal_blend_udn)
PATINA_RELIEF_MODE(NormalWhiteout, normal_blend_whiteout)
PATINA_RELIEF_MODE(NormalPartial, normal_blend_partial_derivative)
#undef PATINA_RELIEF_MODE

/// Normal mode on directions: from the backdrop to the source, kept unit.
struct NormalLerp {
    static HWY_INLINE Real3 laid(Real3 below, Real3 own, Real weight) {
        return formulae::normal_over(below, own, weight);
    }
};

void replace(const BlendTask& task) {
    const auto count = static_cast<std::size_t>(task.count);
    for (int k = 0; k < component_count(task.channel); ++k) {
        if (task.source[k].data == task.target[k]) continue;
        for (std::size_t i = 0; i < count; i += lane_count())
            store(load(task.source[k], i), task.target[k] + i);
    }
    if (task.target_coverage == nullptr) return;
    for (std::size_t i = 0; i < count; i += lane_count())
        store(weight_at(task, i), task.target_coverage + i);
}

BlendKernel kernel_for(const BlendTask& task) {
    if (task.first) return replace;
    switch (task.mode) {
        case BlendMode::Normal:
            return task.channel == Channel::Normal ? of_normals<NormalLerp>(task)
                                                   : separable<NormalMode>(task);
        case BlendMode::PassThrough:  // its layers are on the accumulator already: they replace it
        case BlendMode::Replace:
            return blend_replacing;
#define PATINA_BLEND_CASE(NAME, FORMULA) \
    case BlendMode::NAME:                \
        return separable<NAME>(task);
            PATINA_SCALAR_MODES(PATINA_BLEND_CASE)
#undef PATINA_BLEND_CASE
        case BlendMode::HueW3c:
            return of_colors<HueW3c>(task);
        case BlendMode::SaturationW3c:
            return of_colors<SaturationW3c>(task);
        case BlendMode::ColorW3c:
            return of_colors<ColorW3c>(task);
        case BlendMode::LuminosityW3c:
            return of_colors<LuminosityW3c>(task);
        case BlendMode::TintHsv:
            return of_colors<TintHsv>(task);
        case BlendMode::SaturationHsv:
            return of_colors<SaturationHsv>(task);
        case BlendMode::ColorHsv:
            return of_colors<ColorHsv>(task);
        case BlendMode::ValueHsv:
            return of_colors<ValueHsv>(task);
        case BlendMode::NormalRnm:
            return of_normals<NormalRnm>(task);
        case BlendMode::NormalUdn:
            return of_normals<NormalUdn>(task);
        case BlendMode::NormalWhiteout:
            return of_normals<NormalWhiteout>(task);
        case BlendMode::NormalPartial:
            return of_normals<NormalPartial>(task);
        case BlendMode::HeightAdd:
            return separable<HeightAdd>(task);
        case BlendMode::HeightMax:
            return separable<HeightMax>(task);
        case BlendMode::HeightMin:
            return separable<HeightMin>(task);
        case BlendMode::HeightSubtract:
            return separable<HeightSubtract>(task);
    }
    return replace;  // of no mode that there is
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

HWY_EXPORT(kernel_for);
HWY_EXPORT(multiply_planes);
HWY_EXPORT(encode_planes);
HWY_EXPORT(decode_planes);

BlendKernel blend_kernel(const BlendTask& task) {
    return HWY_DYNAMIC_DISPATCH(kernel_for)(task);
}

bool blends_stored(Channel channel, BlendMode mode, const StoredTexels& texels) {
    if (mode == BlendMode::Replace || mode == BlendMode::PassThrough) return false;
    switch (info(channel).kind) {
        case ChannelKind::Color:
            return texels.channels >= 3 && texels.first == 0;
        case ChannelKind::Scalar:
        case ChannelKind::Height:
            return texels.channels == 1 && !texels.decode;
        case ChannelKind::Normal:
            return false;
    }
    return false;
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
