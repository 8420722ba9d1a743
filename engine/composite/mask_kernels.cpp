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
template <class Combine, class Source>
HWY_INLINE Real joined_lanes(const MaskTask& task, const Source& from, std::size_t i) {
    Real value;
    from.load(i, &value);
    value = Combine::joined(task.mask + i, entry_of(task, value), task.opacity);
    if (task.last) value = formulae::finished_mask(value, task.invert_mask);
    store(value, task.mask + i);
    return value;
}

/// How far the texels from `i` on are from 0; those beyond `count` hold anything and do not count.
HWY_INLINE Real counted(Real value, std::size_t i, std::size_t count) {
    const auto inside = hn::FirstN(RealLanes(), count - i);
    return Real(hn::Abs(hn::IfThenElseZero(inside, value.lanes)));
}

/// Takes the task by value: no float that is stored can be a part of it.
template <class Combine, class Source>
HWY_NOINLINE HWY_FLATTEN TileBlocks join(const MaskTask task, const Source from) {
    const auto count = static_cast<std::size_t>(task.count);
    // What is multiplied stays 0 where it is 0.
    const bool keeps_zero = Combine::kKeepsZero && !(task.last && task.invert_mask);
    const TileBlocks joined = keeps_zero ? task.blocks : all_blocks(task.count);
    TileBlocks filled = 0;
    for (TileBlocks left = joined; left != 0; left &= left - 1) {
        const auto block = static_cast<std::size_t>(__builtin_ctz(left));
        const std::size_t begin = block * kBlockTexels;
        const std::size_t past = begin + kBlockTexels;
        const std::size_t end = past < count ? past : count;
        Real most = 0.0f;
        for (std::size_t i = begin; i < end; i += lane_count())
            most = max(most, counted(joined_lanes<Combine>(task, from, i), i, count));
        if (!hn::AllTrue(RealLanes(), (most <= 0.0f).mask)) filled |= left & -left;
    }
    return filled;
}

/// Nothing lies below: the entry is the mask.
struct First {
    static constexpr bool kKeepsZero = false;
    static constexpr bool kReadsStored = true;
    static HWY_INLINE Real joined(const float*, Real entry, float) { return entry; }
};

#define PATINA_COMBINE(NAME, FORMULA)                                                 \
    struct NAME {                                                                     \
        static constexpr bool kKeepsZero = BlendMode::NAME == BlendMode::Multiply;    \
        static constexpr bool kReadsStored = reads_stored(BlendMode::NAME);           \
        static HWY_INLINE Real joined(const float* mask, Real entry, float opacity) { \
            const Real below = load(mask);                                            \
            return mix(below, formulae::FORMULA(below, entry), opacity);              \
        }                                                                             \
    };
PATINA_COMBINE(Replace, blend_normal)
PATINA_SCALAR_MODES(PATINA_COMBINE)
#undef PATINA_COMBINE

template <class Combine>
TileBlocks join_source(const MaskTask& task) {
    const StoredTexels& stored = task.stored;
    if constexpr (Combine::kReadsStored) {
        if (stored.texels != nullptr && stored.channels == 1)
            return join<Combine>(task, TexelReader<std::uint8_t, 1, 0, 1>(
                                           stored.texels, stored.row_bytes, task.count));
        if (stored.texels != nullptr)
            return join<Combine>(task, TexelReader<std::uint8_t, 4, 3, 1>(
                                           stored.texels, stored.row_bytes, task.count));
    }
    return join<Combine>(task, PlaneReader<1>(&task.source));
}

TileBlocks join_by_combine(const MaskTask& task) {
    if (task.first) return join_source<First>(task);
    switch (task.combine) {
        case BlendMode::Replace:
            return join_source<Replace>(task);
#define PATINA_JOIN_CASE(NAME, FORMULA) \
    case BlendMode::NAME:               \
        return join_source<NAME>(task);
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
            break;  // these join no masks
    }
    return all_blocks(task.count);
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
HWY_EXPORT(share_by_height);
HWY_EXPORT(fill);
HWY_EXPORT(copy);

TileBlocks join_mask_tile(const MaskTask& task) {
    return HWY_DYNAMIC_DISPATCH(join_by_combine)(task);
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
