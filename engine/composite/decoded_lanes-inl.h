// SPDX-License-Identifier: MIT

/// The bytes of texels, and the linear light of those that are sRGB-encoded, for the kernels that
/// read images.

#if defined(PATINA_COMPOSITE_DECODED_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PATINA_COMPOSITE_DECODED_LANES_INL_H
#undef PATINA_COMPOSITE_DECODED_LANES_INL_H
#else
#define PATINA_COMPOSITE_DECODED_LANES_INL_H
#endif

#include "composite/decoded_bytes.h"
#include "composite/plane_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace patina::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// One component of lane_count() RGBA8 texels, which are one 32-bit number each.
template <int kIndex>
HWY_INLINE hn::Vec<formulae::IntLanes> byte_of(hn::Vec<formulae::UintLanes> texels) {
    const auto byte =
        hn::And(hn::ShiftRight<8 * kIndex>(texels), hn::Set(formulae::UintLanes(), 0xffu));
    return hn::BitCast(formulae::IntLanes(), byte);
}

/// One byte a lane.
HWY_INLINE Real decoded(const DecodedBytes& table, hn::Vec<formulae::IntLanes> byte) {
    return Real(hn::GatherIndex(formulae::RealLanes(), table.values.data(), byte));
}

#if HWY_TARGET == HWY_AVX3
// A gather loads each lane by itself: three of them are the better part of a blend. A table of
// 16-bit halves is 8 registers, which are looked up for two bytes of every lane at once. Red and
// blue go by it and green is gathered, which keeps other parts of a core busy meanwhile.

/// The entries of a table of halves at the bytes in the 16-bit lanes of `at`.
HWY_INLINE __m512i entries(const std::uint16_t* halves, __m512i at, __mmask32 bit6,
                           __mmask32 bit7) {
    const auto of_64 = [&](int i) {
        return _mm512_permutex2var_epi16(_mm512_load_si512(halves + i), at,
                                         _mm512_load_si512(halves + i + 32));
    };
    return _mm512_mask_blend_epi16(bit7, _mm512_mask_blend_epi16(bit6, of_64(0), of_64(64)),
                                   _mm512_mask_blend_epi16(bit6, of_64(128), of_64(192)));
}

/// Of the bytes in the lower and in the upper half of each lane.
HWY_INLINE void decoded_pair(const DecodedBytes& table, __m512i at, Real& lower, Real& upper) {
    constexpr __mmask32 kUpper = 0xaaaaaaaau;
    const __mmask32 bit6 = _mm512_test_epi16_mask(at, _mm512_set1_epi16(64));
    const __mmask32 bit7 = _mm512_test_epi16_mask(at, _mm512_set1_epi16(128));
    const __m512i low = entries(table.low_halves.data(), at, bit6, bit7);
    const __m512i high = entries(table.high_halves.data(), at, bit6, bit7);
    const auto real = [](__m512i bits) {
        return Real(hn::BitCast(formulae::RealLanes(), hn::Vec<formulae::IntLanes>{bits}));
    };
    lower = real(_mm512_mask_blend_epi16(kUpper, low, _mm512_slli_epi32(high, 16)));
    upper = real(_mm512_mask_blend_epi16(kUpper, _mm512_srli_epi32(low, 16), high));
}

/// The first three bytes of each lane.
HWY_INLINE void decoded_rgb(const DecodedBytes& table, hn::Vec<formulae::UintLanes> texels,
                            Real out[3]) {
    const auto every_second = hn::Set(formulae::UintLanes(), 0x00ff00ffu);
    decoded_pair(table, hn::And(texels, every_second).raw, out[0], out[2]);
    out[1] = decoded(table, byte_of<1>(texels));
}
#else
HWY_INLINE void decoded_rgb(const DecodedBytes& table, hn::Vec<formulae::UintLanes> texels,
                            Real out[3]) {
    out[0] = decoded(table, byte_of<0>(texels));
    out[1] = decoded(table, byte_of<1>(texels));
    out[2] = decoded(table, byte_of<2>(texels));
}
#endif

}  // namespace
}  // namespace patina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled once per target
