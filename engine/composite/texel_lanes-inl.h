// SPDX-License-Identifier: MIT

/// From stored texels to lanes of floats, for the kernels that read images: those that fill planes
/// (composite/fetch_kernels.cpp) and those that use what they read at once.

#if defined(PATINA_COMPOSITE_TEXEL_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PATINA_COMPOSITE_TEXEL_LANES_INL_H
#undef PATINA_COMPOSITE_TEXEL_LANES_INL_H
#else
#define PATINA_COMPOSITE_TEXEL_LANES_INL_H
#endif

#include <hwy/cache_control.h>

#include <type_traits>

#include "composite/decoded_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace patina::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using formulae::RealLanes;

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
    HWY_INLINE void rgb(hn::Vec<formulae::UintLanes> texels, Real out[3]) const {
        out[0] = of_byte(byte_of<0>(texels));
        out[1] = of_byte(byte_of<1>(texels));
        out[2] = of_byte(byte_of<2>(texels));
    }
};
struct Decoded {
    const DecodedBytes& table;
    static HWY_INLINE Decoded make() { return {decoded_bytes()}; }
    HWY_INLINE Real operator()(hn::Vec<hn::Rebind<std::uint8_t, RealLanes>> stored) const {
        return of_byte(hn::PromoteTo(formulae::IntLanes(), stored));
    }
    HWY_INLINE Real of_byte(hn::Vec<formulae::IntLanes> byte) const { return decoded(table, byte); }
    HWY_INLINE void rgb(hn::Vec<formulae::UintLanes> texels, Real out[3]) const {
        decoded_rgb(table, texels, out);
    }
};

/// The components of lane_count() interleaved texels; those beyond kChannels stay unset.
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
        const auto packed =
            hn::LoadU(formulae::UintLanes(), reinterpret_cast<const std::uint32_t*>(texels));
        value.rgb(packed, out);
        out[3] = value.of_byte(byte_of<3>(packed));
    } else {
        hn::LoadInterleaved4(lanes, texels, a, b, c, d);
        out[0] = value(a);
        out[1] = value(b);
        out[2] = value(c);
        out[3] = value(d);
    }
}

/// Asks for the bytes below `texels` in the next row, a few at a time, so that the requests do not
/// queue. Hardware follows a few streams well, but a stack reads dozens in turn, in short runs; and
/// what a mask leaves out here it mostly leaves out there.
template <std::size_t kBytes>
HWY_INLINE void prefetch_below(const void* texels, std::size_t row_bytes) {
    const auto* const below = static_cast<const std::byte*>(texels) + row_bytes;
    for (std::size_t i = 0; i < kBytes; i += 64) hwy::Prefetch(below + i);
}

/// Reads kComponents of interleaved texels, from component kFirst on.
template <typename Sample, int kChannels, int kFirst, int kComponents, class Value = AsStored>
class TexelReader {
  public:
    /// `count` texels: nothing is read beyond them.
    HWY_INLINE TexelReader(const void* texels, std::size_t row_bytes, int count)
        : texels_(static_cast<const Sample*>(texels)),
          row_bytes_(row_bytes),
          count_(static_cast<std::size_t>(count)),
          value_(Value::make()) {}

    /// The components of lane_count() texels from texel `i` on.
    HWY_INLINE void load(std::size_t i, Real* components) const {
        const Sample* const here = texels_ + i * kChannels;
        Real texel[4];
        if (HWY_LIKELY(i + lane_count() <= count_)) {
            if (kPrefetch) prefetch_below<kStepBytes>(here, row_bytes_);
            load_texels<Sample, kChannels>(here, value_, texel);
        } else {
            // The last texels may end where the image ends: read them from a padded copy.
            alignas(64) Sample padded[16 * kChannels] = {};
            __builtin_memcpy(padded, here, (count_ - i) * kChannels * sizeof(Sample));
            load_texels<Sample, kChannels>(padded, value_, texel);
        }
        for (int k = 0; k < kComponents; ++k) components[k] = texel[kFirst + k];
    }

  private:
    /// Alpha alone goes by fast, and its requests would queue: what reads the colours asks.
    static constexpr bool kPrefetch = !(kChannels == 4 && kFirst == 3);
    static constexpr std::size_t kStepBytes =
        hn::MaxLanes(RealLanes()) * kChannels * sizeof(Sample);
    const Sample* texels_;
    std::size_t row_bytes_;
    std::size_t count_;
    Value value_;
};

/// What reads the source of a task (BlendTask, MaskTask) as its texels are stored.
template <int kChannels, int kFirst, int kComponents, class Value = AsStored>
struct FromTexels {
    template <class Task>
    static HWY_INLINE TexelReader<std::uint8_t, kChannels, kFirst, kComponents, Value> of(
        const Task& task) {
        return {task.stored.texels, task.stored.row_bytes, task.count};
    }
};

/// Reads kComponents planes.
template <int kComponents>
class PlaneReader {
  public:
    HWY_INLINE explicit PlaneReader(const ReadPlane* planes) : planes_(planes) {}
    HWY_INLINE void load(std::size_t i, Real* components) const {
        for (int k = 0; k < kComponents; ++k) components[k] = HWY_NAMESPACE::load(planes_[k], i);
    }

  private:
    const ReadPlane* planes_;
};

}  // namespace
}  // namespace patina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled once per target
