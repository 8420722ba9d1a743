// SPDX-License-Identifier: MIT
#include "composite/mask_kernels.h"

#include "composite/kernel_targets.h"
#include "composite/scalar_modes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "composite/mask_kernels.cpp"
#include <hwy/foreach_target.h>

#include "composite/texel_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace patina::HWY_NAMESPACE {
namespace {

HWY_INLINE Real entry_of(const MaskTask& task, Real value) {
    if (task.invert) value = formulae::inverted(value);
    if (task.levels == nullptr) return value;
    return formulae::levels(value, task.levels->in_low, task.levels->in_high, task.levels->gamma,
                            task.levels->out_low, task.levels->out_high);
}

/// Lays the entry on lane_count() texels of the mask and returns what is there then.
template <class Combine, bool kWhole, class Source>
HWY_INLINE Real joined_lanes(const MaskTask& task, const Source& from, std::size_t i) {
    Real value;
    from.load(i, &value);
    value = Combine::template joined<kWhole>(task.mask + i, entry_of(task, value), task.opacity);
    if (task.last) value = formulae::finished_mask(value, task.invert_mask);
    store(value, task.mask + i);
    return value;
}

/// The bits of `value` beside those of `seen`: all 0 but for signs where all numbers were 0.
HWY_INLINE Real seen_beside(Real seen, Real value) {
    return Real(hn::Or(seen.lanes, value.lanes));
}

/// The texels from `i` on; those beyond `count` hold anything and do not count.
HWY_INLINE Real counted(Real value, std::size_t i, std::size_t count) {
    return Real(hn::IfThenElseZero(hn::FirstN(RealLanes(), count - i), value.lanes));
}

/// What reads the entry from a plane; FromTexels reads texels as they are stored.
struct FromPlane {
    static HWY_INLINE PlaneReader<1> of(const MaskTask& task) {
        return PlaneReader<1>(&task.source);
    }
};

/// Works on a copy of the task: no float that is stored can be a part of it.
template <class Combine, class Source, bool kWhole>
HWY_NOINLINE HWY_FLATTEN TileBlocks join(const MaskTask& given) {
    const MaskTask task = given;
    const auto from = Source::of(task);
    const auto count = static_cast<std::size_t>(task.count);
    // What is multiplied stays 0 where it is 0.
    const bool keeps_zero = Combine::kKeepsZero && !(task.last && task.invert_mask);
    const TileBlocks joined = keeps_zero ? task.blocks : all_blocks(task.count);
    TileBlocks filled = 0;
    for (TileBlocks left = joined; left != 0; left &= left - 1) {
        const auto block = static_cast<std::size_t>(__builtin_ctz(left));
        const std::size_t begin = block * kBlockTexels;
        const std::size_t past = begin + kBlockTexels;
        Real seen = 0.0f;
        if (past <= count)
            for (std::size_t i = begin; i < past; i += lane_count())
                seen = seen_beside(seen, joined_lanes<Combine, kWhole>(task, from, i));
        else
            for (std::size_t i = begin; i < count; i += lane_count())
                seen = seen_beside(seen,
                                   counted(joined_lanes<Combine, kWhole>(task, from, i), i, count));
        const auto empty = hn::Eq(hn::Abs(seen.lanes), hn::Zero(RealLanes()));
        if (!hn::AllTrue(RealLanes(), empty)) filled |= left & -left;
    }
    return filled;
}

/// Nothing lies below: the entry is the mask.
struct First {
    static constexpr bool kKeepsZero = false;
    static constexpr bool kReadsStored = true;
    template <bool kWhole>
    static HWY_INLINE Real joined(const float*, Real entry, float) {
        return entry;
    }
};

/// Of a mode, at an opacity; kWhole: at 1, where that is known. The same numbers either way.
#define PATINA_COMBINE(NAME, FORMULA)                                                    \
    struct NAME {                                                                        \
        static constexpr bool kKeepsZero = BlendMode::NAME == BlendMode::Multiply;       \
        static constexpr bool kReadsStored = reads_stored(BlendMode::NAME);              \
        template <bool kWhole>                                                           \
        static HWY_INLINE Real joined(const float* mask, Real entry, float opacity) {    \
            const Real below = load(mask);                                               \
            const Real blended = formulae::FORMULA(below, entry);                        \
            if (kWhole) return blended;                                                  \
            return select(Real(opacity) >= 1.0f, blended, mix(below, blended, opacity)); \
        }                                                                                \
    };
PATINA_COMBINE(Replace, blend_normal)
PATINA_SCALAR_MODES(PATINA_COMBINE)
#undef PATINA_COMBINE

template <class Combine>
MaskKernel joining(const MaskTask& task) {
    if constexpr (Combine::kReadsStored) {
        const bool whole = task.opacity >= 1.0f;
        if (task.stored.texels != nullptr && task.stored.channels == 1)
            return whole ? join<Combine, FromTexels<1, 0, 1>, true>
                         : join<Combine, FromTexels<1, 0, 1>, false>;
        if (task.stored.texels != nullptr)
            return whole ? join<Combine, FromTexels<4, 3, 1>, true>
                         : join<Combine, FromTexels<4, 3, 1>, false>;
    }
    return join<Combine, FromPlane, false>;
}

/// Of modes that join no masks.
TileBlocks join_nothing(const MaskTask& task) {
    return all_blocks(task.count);
}

MaskKernel kernel_for(const MaskTask& task) {
    if (task.first) return joining<First>(task);
    switch (task.combine) {
        case BlendMode::Replace:
            return joining<Replace>(task);
#define PATINA_JOIN_CASE(NAME, FORMULA) \
    case BlendMode::NAME:               \
        return joining<NAME>(task);
            PATINA_SCALAR_MODES(PATINA_JOIN_CASE)
#undef PATINA_JOIN_CASE
        case BlendMode::Normal:
        case BlendMode::HueW3c:
        case BlendMode::SaturationW3c:
        case BlendMode::ColorW3c:
        case BlendMode::LuminosityW3c:
        case BlendMode::TintHsv:
        case BlendMode::SaturationHsv:
        case BlendMode::ColorHsv:
        case BlendMode::ValueHsv:
        case BlendMode::NormalRnm:
        case BlendMode::NormalUdn:
        case BlendMode::NormalWhiteout:
        case BlendMode::NormalPartial:
        case BlendMode::HeightAdd:
        case BlendMode::HeightMax:
        case BlendMode::HeightMin:
        case BlendMode::HeightSubtract:
        case BlendMode::PassThrough:
            break;
    }
    return join_nothing;
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

HWY_EXPORT(kernel_for);
HWY_EXPORT(share_by_height);
HWY_EXPORT(fill);
HWY_EXPORT(copy);

MaskKernel mask_kernel(const MaskTask& task) {
    return HWY_DYNAMIC_DISPATCH(kernel_for)(task);
}

bool mask_reads_stored(BlendMode combine, const StoredTexels& texels) {
    if (texels.decode || !reads_stored(combine)) return false;
    return texels.channels == 1 || (texels.channels == 4 && texels.first == 3);
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
