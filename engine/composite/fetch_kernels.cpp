// SPDX-License-Identifier: MIT
#include "composite/fetch_kernels.h"

#include <hwy/cache_control.h>

#include <array>

#include "composite/kernel_targets.h"
#include "core/formulae/formulae.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "composite/fetch_kernels.cpp"
#include <hwy/foreach_target.h>

#include "core/formulae/formulae-inl.h"

HWY_BEFORE_NAMESPACE();
namespace patina::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using formulae::lane_count;
using formulae::load;
using formulae::Real;
using formulae::Real3;
using formulae::RealLanes;
using formulae::store;
using formulae::UintLanes;

/// One component of lane_count() RGBA8 texels, which are one 32-bit number each.
template <int kIndex>
HWY_INLINE hn::Vec<formulae::IntLanes> byte_of(hn::Vec<UintLanes> texels) {
    const auto byte = hn::And(hn::ShiftRight<8 * kIndex>(texels), hn::Set(UintLanes(), 0xffu));
    return hn::BitCast(formulae::IntLanes(), byte);
}

/// Lanes of stored numbers as floats in 0..1.
HWY_INLINE Real unit(hn::Vec<hn::Rebind<std::uint8_t, RealLanes>> stored) {
    const auto wide = hn::PromoteTo(formulae::IntLanes(), stored);
    return Real(hn::ConvertTo(RealLanes(), wide)) * (1.0f / 255.0f);
}
HWY_INLINE Real unit(hn::Vec<hn::Rebind<std::uint16_t, RealLanes>> stored) {
    const auto wide = hn::PromoteTo(formulae::IntLanes(), stored);
    return Real(hn::ConvertTo(RealLanes(), wide)) * (1.0f / 65535.0f);
}
HWY_INLINE Real unit(hn::Vec<RealLanes> stored) {
    return Real(stored);
}

/// The linear light of each byte.
HWY_INLINE const float* decoded_bytes() {
    static const auto table = [] {
        std::array<float, 256> decoded{};
        for (std::size_t byte = 0; byte < decoded.size(); ++byte)
            decoded[byte] =
                patina::formulae::linear_from_srgb(static_cast<float>(byte) * (1.0f / 255.0f));
        return decoded;
    }();
    return table.data();
}

/// How stored numbers become values.
struct AsStored {
    static HWY_INLINE AsStored make() { return {}; }
    template <typename Stored>
    HWY_INLINE Real operator()(Stored stored) const {
        return unit(stored);
    }
    HWY_INLINE Real of_byte(hn::Vec<formulae::IntLanes> byte) const {
        return Real(hn::ConvertTo(RealLanes(), byte)) * (1.0f / 255.0f);
    }
};
struct Decoded {
    const float* table;
    static HWY_INLINE Decoded make() { return {decoded_bytes()}; }
    HWY_INLINE Real operator()(hn::Vec<hn::Rebind<std::uint8_t, RealLanes>> stored) const {
        return of_byte(hn::PromoteTo(formulae::IntLanes(), stored));
    }
    HWY_INLINE Real of_byte(hn::Vec<formulae::IntLanes> byte) const {
        return Real(hn::GatherIndex(RealLanes(), table, byte));
    }
};

/// The four components of lane_count() interleaved texels; those beyond kChannels stay unset.
template <typename Sample, int kChannels, class Value>
HWY_INLINE void load_texels(const Sample* texels, const Value& value, Real out[4]) {
    const hn::Rebind<Sample, RealLanes> lanes;
    hn::Vec<decltype(lanes)> a, b, c, d;
    if constexpr (kChannels == 1) {
        out[0] = value(hn::LoadU(lanes, texels));
    } else if constexpr (kChannels == 2) {
        hn::LoadInterleaved2(lanes, texels, a, b);
        out[0] = value(a);
        out[1] = value(b);
    } else if constexpr (kChannels == 3) {
        hn::LoadInterleaved3(lanes, texels, a, b, c);
        out[0] = value(a);
        out[1] = value(b);
        out[2] = value(c);
    } else if constexpr (std::is_same_v<Sample, std::uint8_t>) {
        // A texel is one 32-bit number.
        const auto packed = hn::LoadU(UintLanes(), reinterpret_cast<const std::uint32_t*>(texels));
        out[0] = value.of_byte(byte_of<0>(packed));
        out[1] = value.of_byte(byte_of<1>(packed));
        out[2] = value.of_byte(byte_of<2>(packed));
        out[3] = value.of_byte(byte_of<3>(packed));
    } else {
        hn::LoadInterleaved4(lanes, texels, a, b, c, d);
        out[0] = value(a);
        out[1] = value(b);
        out[2] = value(c);
        out[3] = value(d);
    }
}

/// Component kIndex of each texel, or, where it is -1, the first three.
template <int kChannels, int kIndex, typename Sample, class Value>
HWY_INLINE void read_lanes(const Sample* texels, const Value& value, float* const* planes,
                           std::size_t at) {
    Real texel[4];
    load_texels<Sample, kChannels>(texels, value, texel);
    if constexpr (kIndex >= 0) {
        store(texel[kIndex], planes[0] + at);
    } else {
        for (int k = 0; k < 3; ++k) store(texel[k], planes[k] + at);
    }
}

/// Asks for the bytes that the next tile of the row will read where this one reads `texels`, a few
/// at a time, so that the requests do not queue. Hardware follows a few streams well, but a stack
/// reads dozens in turn, in short runs.
template <std::size_t kBytes>
HWY_INLINE void prefetch_next(const void* texels, std::size_t tile_bytes) {
    const auto* const next = static_cast<const std::byte*>(texels) + tile_bytes;
    for (std::size_t i = 0; i < kBytes; i += 64) hwy::Prefetch(next + i);
}

template <typename Sample, int kChannels, int kIndex, class Value = AsStored>
HWY_NOINLINE HWY_FLATTEN void read_run(const ReadTask& task) {
    const Value value = Value::make();
    const std::size_t count = static_cast<std::size_t>(task.count);
    const auto* const texels = reinterpret_cast<const Sample*>(task.texels);
    const std::size_t tile_bytes = count * kChannels * sizeof(Sample);
    constexpr std::size_t kStepBytes = hn::MaxLanes(RealLanes()) * kChannels * sizeof(Sample);
    std::size_t i = 0;
    for (; i + lane_count() <= count; i += lane_count()) {
        prefetch_next<kStepBytes>(texels + i * kChannels, tile_bytes);
        read_lanes<kChannels, kIndex>(texels + i * kChannels, value, task.planes, i);
    }
    if (i == count) return;
    // The last texels may end where the image ends: read them from a padded copy.
    alignas(64) Sample padded[16 * kChannels] = {};
    __builtin_memcpy(padded, texels + i * kChannels, (count - i) * kChannels * sizeof(Sample));
    read_lanes<kChannels, kIndex>(padded, value, task.planes, i);
}

template <typename Sample, int kChannels, class Value>
void read_component(const ReadTask& task, int index) {
    if constexpr (kChannels > 3)
        if (index == 3) return read_run<Sample, kChannels, 3, Value>(task);
    if constexpr (kChannels > 2)
        if (index == 2) return read_run<Sample, kChannels, 2, Value>(task);
    if constexpr (kChannels > 1)
        if (index == 1) return read_run<Sample, kChannels, 1, Value>(task);
    read_run<Sample, kChannels, 0, Value>(task);
}

template <typename Sample, class Value>
void read_samples(const ReadTask& task) {
    const int index = task.components.index[0];
    switch (task.channels) {
        case 1:
            return read_component<Sample, 1, Value>(task, index);
        case 2:
            return read_component<Sample, 2, Value>(task, index);
        case 3:
            return task.components.count == 3 ? read_run<Sample, 3, -1, Value>(task)
                                              : read_component<Sample, 3, Value>(task, index);
        default:
            return task.components.count == 3 ? read_run<Sample, 4, -1, Value>(task)
                                              : read_component<Sample, 4, Value>(task, index);
    }
}

void read_by_type(const ReadTask& task) {
    switch (task.type) {
        case SampleType::U8:
            return task.decode ? read_samples<std::uint8_t, Decoded>(task)
                               : read_samples<std::uint8_t, AsStored>(task);
        case SampleType::U16:
            return read_samples<std::uint16_t, AsStored>(task);
        case SampleType::F32:
            return read_samples<float, AsStored>(task);
    }
}

/// The steps that each component takes by itself.
HWY_INLINE Real adjusted(const Adjustment& adjustment, Real value, int k) {
    if (adjustment.invert) value = 1.0f - value;
    if (adjustment.decode) value = formulae::linear_from_srgb(value);
    if (adjustment.unpack) value = value * 2.0f - 1.0f;
    if (adjustment.flip_y && k == 1) value = -value;
    if (adjustment.scale) value = value * adjustment.multiply[k] + adjustment.add[k];
    return value;
}

HWY_NOINLINE HWY_FLATTEN void adjust_one(const Adjustment& adjustment, float* plane, int count) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); i += lane_count()) {
        Real value = adjusted(adjustment, load(plane + i), 0);
        if (adjustment.hold) value = clamp(value, 0.0f, 1.0f);
        if (adjustment.encode) value = formulae::srgb_from_linear(value);
        store(value, plane + i);
    }
}

HWY_NOINLINE HWY_FLATTEN void adjust_three(const Adjustment& adjustment, float* const* planes,
                                           int count) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); i += lane_count()) {
        Real3 value(adjusted(adjustment, load(planes[0] + i), 0),
                    adjusted(adjustment, load(planes[1] + i), 1),
                    adjusted(adjustment, load(planes[2] + i), 2));
        if (adjustment.normalise) value = formulae::unit_normal(value);
        if (adjustment.luminance) {
            Real grey = formulae::luminance(value);
            if (adjustment.hold) grey = clamp(grey, 0.0f, 1.0f);
            store(grey, planes[0] + i);
            continue;
        }
        if (adjustment.hold) value = clamp(value, 0.0f, 1.0f);
        if (adjustment.encode) value = formulae::srgb_from_linear(value);
        store(value.x, planes[0] + i);
        store(value.y, planes[1] + i);
        store(value.z, planes[2] + i);
    }
}

void adjust(const Adjustment& adjustment, int components, float* const* planes, int count) {
    if (components == 3)
        adjust_three(adjustment, planes, count);
    else
        adjust_one(adjustment, planes[0], count);
}

}  // namespace

}  // namespace patina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace patina {

HWY_EXPORT(read_by_type);
HWY_EXPORT(adjust);

Components picked_components(ChannelPick pick, int channels) {
    const bool grey = channels <= 2;
    switch (pick) {
        case ChannelPick::Rgb:
            if (grey) return {.count = 1, .index = {0, 0, 0}};
            return {.count = 3, .index = {0, 1, 2}};
        case ChannelPick::Red:
            return {.index = {0}};
        case ChannelPick::Green:
            return {.index = {grey ? 0 : 1}};
        case ChannelPick::Blue:
            return {.index = {grey ? 0 : 2}};
        case ChannelPick::Alpha:
            return {.index = {channels == 2 ? 1 : channels == 4 ? 3 : -1}};
    }
    return {};
}

void read_tile(const ReadTask& task) {
    HWY_DYNAMIC_DISPATCH(read_by_type)(task);
}

void adjust_tile(const Adjustment& adjustment, int components, float* const planes[3], int count) {
    HWY_DYNAMIC_DISPATCH(adjust)(adjustment, components, planes, count);
}

}  // namespace patina
#endif
