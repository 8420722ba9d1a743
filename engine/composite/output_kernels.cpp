// SPDX-License-Identifier: MIT
#include "composite/output_kernels.h"

#include <hwy/cache_control.h>

#include "composite/kernel_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "composite/output_kernels.cpp"
#include <hwy/foreach_target.h>

#include "composite/plane_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace patina::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using formulae::Uint;
using formulae::UintLanes;

/// 0..1 to the nearest of 0..255; what is outside is held.
HWY_INLINE Uint byte_of(Real value) {
    return Uint(formulae::Int(clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f));
}

template <OutputEncoding kEncoding>
HWY_INLINE Real3 encoded(Real3 value) {
    if constexpr (kEncoding == OutputEncoding::LinearColor)
        return formulae::srgb_from_linear(value);
    else if constexpr (kEncoding == OutputEncoding::Normal)
        return formulae::encoded_from_signed(value);
    else
        return value;
}

template <OutputEncoding kEncoding>
HWY_INLINE Uint rgba_at(const OutputTask& task, std::size_t i) {
    const Real3 color = encoded<kEncoding>(load(task.components, i));
    return byte_of(color.x) | (byte_of(color.y) << 8) | (byte_of(color.z) << 16) |
           (byte_of(load(task.components[3], i)) << 24);
}

template <OutputEncoding kEncoding, bool kToMemory>
HWY_NOINLINE HWY_FLATTEN void write_rgba(const OutputTask& task) {
    const std::size_t count = static_cast<std::size_t>(task.count);
    auto* const texels = reinterpret_cast<std::uint32_t*>(task.rgba);
    std::size_t i = 0;
    for (; i + lane_count() <= count; i += lane_count()) {
        const Uint rgba = rgba_at<kEncoding>(task, i);
        if constexpr (kToMemory)
            hn::Stream(rgba.lanes, UintLanes(), texels + i);
        else
            hn::StoreU(rgba.lanes, UintLanes(), texels + i);
    }
    if (kToMemory) hwy::FlushStream();
    if (i == count) return;
    alignas(64) std::uint32_t last[16];
    hn::StoreU(rgba_at<kEncoding>(task, i).lanes, UintLanes(), last);
    __builtin_memcpy(texels + i, last, (count - i) * sizeof(std::uint32_t));
}

template <OutputEncoding kEncoding>
void write_encoded(const OutputTask& task) {
    const bool aligned = reinterpret_cast<std::uintptr_t>(task.rgba) % 64 == 0;
    if (task.to_memory && aligned) return write_rgba<kEncoding, true>(task);
    write_rgba<kEncoding, false>(task);
}

void write_by_encoding(const OutputTask& task) {
    switch (task.encoding) {
        case OutputEncoding::AsIs:
            return write_encoded<OutputEncoding::AsIs>(task);
        case OutputEncoding::LinearColor:
            return write_encoded<OutputEncoding::LinearColor>(task);
        case OutputEncoding::Normal:
            return write_encoded<OutputEncoding::Normal>(task);
    }
}

HWY_INLINE Real3 relief_normal(const ReliefTask& task, std::size_t i) {
    const Real nw = load(task.above + i), n = load(task.above + i + 1),
               ne = load(task.above + i + 2);
    const Real w = load(task.here + i), e = load(task.here + i + 2);
    const Real sw = load(task.below + i), s = load(task.below + i + 1),
               se = load(task.below + i + 2);
    const Real right = formulae::height_slope(nw, w, sw, ne, e, se);
    const Real up = formulae::height_slope(sw, s, se, nw, n, ne);
    return formulae::height_normal(right * task.depth_texels, up * task.depth_texels);
}

HWY_NOINLINE HWY_FLATTEN void add_relief(const ReliefTask& task) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(task.count); i += lane_count()) {
        const Real3 detail = load(task.normal, i);
        store(formulae::normal_blend_rnm(relief_normal(task, i), detail), task.normal, i);
    }
}

}  // namespace

}  // namespace patina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace patina {

HWY_EXPORT(write_by_encoding);
HWY_EXPORT(add_relief);

void write_tile(const OutputTask& task) {
    HWY_DYNAMIC_DISPATCH(write_by_encoding)(task);
}

void add_relief_tile(const ReliefTask& task) {
    HWY_DYNAMIC_DISPATCH(add_relief)(task);
}

}  // namespace patina
#endif
