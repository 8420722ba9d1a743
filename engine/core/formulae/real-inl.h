// SPDX-License-Identifier: MIT

/// The vocabulary of shaders/shared/ over SIMD lanes: Real is a Highway vector of floats, as wide
/// as the instruction set that is compiled for. See formulae-inl.h for how to use it.
///
/// Only operations that round the same way on every instruction set: no fused multiply-add, no
/// approximate reciprocal. The results have the bits that real.h gives.

#if defined(PATINA_CORE_FORMULAE_REAL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PATINA_CORE_FORMULAE_REAL_INL_H
#undef PATINA_CORE_FORMULAE_REAL_INL_H
#else
#define PATINA_CORE_FORMULAE_REAL_INL_H
#endif

#include <hwy/highway.h>

#include <cmath>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace patina::HWY_NAMESPACE::formulae {

namespace hn = hwy::HWY_NAMESPACE;
using RealLanes = hn::ScalableTag<float>;
using IntLanes = hn::ScalableTag<std::int32_t>;
using UintLanes = hn::ScalableTag<std::uint32_t>;
using uint = std::uint32_t;

struct Bool {
    hn::Mask<RealLanes> mask;
};

struct Uint;

struct Int {
    hn::Vec<IntLanes> lanes;
    Int() = default;
    HWY_INLINE Int(std::int32_t uniform) : lanes(hn::Set(IntLanes(), uniform)) {}
    HWY_INLINE explicit Int(hn::Vec<IntLanes> vector) : lanes(vector) {}
    HWY_INLINE explicit Int(Uint wrapped);
    HWY_INLINE explicit Int(struct Real truncated);
};

struct Uint {
    hn::Vec<UintLanes> lanes;
    Uint() = default;
    HWY_INLINE Uint(std::uint32_t uniform) : lanes(hn::Set(UintLanes(), uniform)) {}
    HWY_INLINE explicit Uint(hn::Vec<UintLanes> vector) : lanes(vector) {}
    HWY_INLINE explicit Uint(Int wrapped) : lanes(hn::BitCast(UintLanes(), wrapped.lanes)) {}
};

struct Real {
    hn::Vec<RealLanes> lanes;
    Real() = default;
    HWY_INLINE Real(float uniform) : lanes(hn::Set(RealLanes(), uniform)) {}
    HWY_INLINE explicit Real(hn::Vec<RealLanes> vector) : lanes(vector) {}
    HWY_INLINE explicit Real(Int exact) : lanes(hn::ConvertTo(RealLanes(), exact.lanes)) {}
    HWY_INLINE Real& operator+=(Real b);
    HWY_INLINE Real& operator*=(Real b);
};

Int::Int(Uint wrapped) : lanes(hn::BitCast(IntLanes(), wrapped.lanes)) {}
Int::Int(Real truncated) : lanes(hn::ConvertTo(IntLanes(), truncated.lanes)) {}

/// How many texels one Real holds. Planes of floats are padded to a multiple of it.
HWY_INLINE std::size_t lane_count() {
    return hn::Lanes(RealLanes());
}

/// Reads and writes lane_count() floats; any alignment of float will do.
HWY_INLINE Real load(const float* source) {
    return Real(hn::LoadU(RealLanes(), source));
}
HWY_INLINE void store(Real value, float* target) {
    hn::StoreU(value.lanes, RealLanes(), target);
}

HWY_INLINE Real operator+(Real a, Real b) {
    return Real(hn::Add(a.lanes, b.lanes));
}
HWY_INLINE Real operator-(Real a, Real b) {
    return Real(hn::Sub(a.lanes, b.lanes));
}
HWY_INLINE Real operator*(Real a, Real b) {
    return Real(hn::Mul(a.lanes, b.lanes));
}
HWY_INLINE Real operator/(Real a, Real b) {
    return Real(hn::Div(a.lanes, b.lanes));
}
HWY_INLINE Real operator-(Real a) {
    return Real(hn::Neg(a.lanes));
}
Real& Real::operator+=(Real b) {
    return *this = *this + b;
}
Real& Real::operator*=(Real b) {
    return *this = *this * b;
}

HWY_INLINE Bool operator<(Real a, Real b) {
    return {hn::Lt(a.lanes, b.lanes)};
}
HWY_INLINE Bool operator<=(Real a, Real b) {
    return {hn::Le(a.lanes, b.lanes)};
}
HWY_INLINE Bool operator>(Real a, Real b) {
    return {hn::Gt(a.lanes, b.lanes)};
}
HWY_INLINE Bool operator>=(Real a, Real b) {
    return {hn::Ge(a.lanes, b.lanes)};
}
HWY_INLINE Bool operator==(Real a, Real b) {
    return {hn::Eq(a.lanes, b.lanes)};
}

HWY_INLINE Bool operator&&(Bool a, Bool b) {
    return {hn::And(a.mask, b.mask)};
}
HWY_INLINE Bool operator||(Bool a, Bool b) {
    return {hn::Or(a.mask, b.mask)};
}
HWY_INLINE Bool operator!(Bool a) {
    return {hn::Not(a.mask)};
}

HWY_INLINE Int operator+(Int a, Int b) {
    return Int(hn::Add(a.lanes, b.lanes));
}
HWY_INLINE Int operator-(Int a, Int b) {
    return Int(hn::Sub(a.lanes, b.lanes));
}
HWY_INLINE Int operator&(Int a, Int b) {
    return Int(hn::And(a.lanes, b.lanes));
}
HWY_INLINE Int operator|(Int a, Int b) {
    return Int(hn::Or(a.lanes, b.lanes));
}
HWY_INLINE Int operator^(Int a, Int b) {
    return Int(hn::Xor(a.lanes, b.lanes));
}
HWY_INLINE Int operator<<(Int a, int bits) {
    return Int(hn::ShiftLeftSame(a.lanes, bits));
}
HWY_INLINE Int operator>>(Int a, int bits) {
    return Int(hn::ShiftRightSame(a.lanes, bits));
}
HWY_INLINE Bool operator<(Int a, Int b) {
    return {hn::RebindMask(RealLanes(), hn::Lt(a.lanes, b.lanes))};
}
HWY_INLINE Bool operator>(Int a, Int b) {
    return {hn::RebindMask(RealLanes(), hn::Gt(a.lanes, b.lanes))};
}
HWY_INLINE Bool operator==(Int a, Int b) {
    return {hn::RebindMask(RealLanes(), hn::Eq(a.lanes, b.lanes))};
}

HWY_INLINE Uint operator+(Uint a, Uint b) {
    return Uint(hn::Add(a.lanes, b.lanes));
}
HWY_INLINE Uint operator*(Uint a, Uint b) {
    return Uint(hn::Mul(a.lanes, b.lanes));
}
HWY_INLINE Uint operator&(Uint a, Uint b) {
    return Uint(hn::And(a.lanes, b.lanes));
}
HWY_INLINE Uint operator|(Uint a, Uint b) {
    return Uint(hn::Or(a.lanes, b.lanes));
}
HWY_INLINE Uint operator^(Uint a, Uint b) {
    return Uint(hn::Xor(a.lanes, b.lanes));
}
HWY_INLINE Uint operator<<(Uint a, int bits) {
    return Uint(hn::ShiftLeftSame(a.lanes, bits));
}
HWY_INLINE Uint operator>>(Uint a, int bits) {
    return Uint(hn::ShiftRightSame(a.lanes, bits));
}
HWY_INLINE Bool operator==(Uint a, Uint b) {
    return {hn::RebindMask(RealLanes(), hn::Eq(a.lanes, b.lanes))};
}

HWY_INLINE Real select(Bool condition, Real if_true, Real if_false) {
    return Real(hn::IfThenElse(condition.mask, if_true.lanes, if_false.lanes));
}
HWY_INLINE Real select(Bool condition, float if_true, float if_false) {
    return select(condition, Real(if_true), Real(if_false));
}
HWY_INLINE Int select(Bool condition, Int if_true, Int if_false) {
    const auto mask = hn::RebindMask(IntLanes(), condition.mask);
    return Int(hn::IfThenElse(mask, if_true.lanes, if_false.lanes));
}
HWY_INLINE Uint select(Bool condition, Uint if_true, Uint if_false) {
    const auto mask = hn::RebindMask(UintLanes(), condition.mask);
    return Uint(hn::IfThenElse(mask, if_true.lanes, if_false.lanes));
}

HWY_INLINE bool any_lane(Bool condition) {
    return !hn::AllFalse(RealLanes(), condition.mask);
}

HWY_INLINE Real min(Real a, Real b) {
    return Real(hn::Min(a.lanes, b.lanes));
}
HWY_INLINE Real max(Real a, Real b) {
    return Real(hn::Max(a.lanes, b.lanes));
}
HWY_INLINE Int min(Int a, Int b) {
    return Int(hn::Min(a.lanes, b.lanes));
}
HWY_INLINE Int max(Int a, Int b) {
    return Int(hn::Max(a.lanes, b.lanes));
}
HWY_INLINE Real abs(Real x) {
    return Real(hn::Abs(x.lanes));
}
HWY_INLINE Real floor(Real x) {
    return Real(hn::Floor(x.lanes));
}
HWY_INLINE Real sqrt(Real x) {
    return Real(hn::Sqrt(x.lanes));
}
// NOLINTNEXTLINE(readability-identifier-naming): the name is GLSL's
HWY_INLINE Int floatBitsToInt(Real x) {
    return Int(hn::BitCast(IntLanes(), x.lanes));
}
// NOLINTNEXTLINE(readability-identifier-naming): the name is GLSL's
HWY_INLINE Real intBitsToFloat(Int bits) {
    return Real(hn::BitCast(RealLanes(), bits.lanes));
}

// The same on uniform values, so that what is uniform stays out of the lanes.
HWY_INLINE float select(bool condition, float if_true, float if_false) {
    return condition ? if_true : if_false;
}
HWY_INLINE float min(float a, float b) {
    return a < b ? a : b;
}
HWY_INLINE float max(float a, float b) {
    return a > b ? a : b;
}
HWY_INLINE float clamp(float x, float lowest, float highest) {
    return min(max(x, lowest), highest);
}
HWY_INLINE float abs(float x) {
    return std::fabs(x);
}
HWY_INLINE float floor(float x) {
    return std::floor(x);
}
HWY_INLINE float sqrt(float x) {
    return std::sqrt(x);
}

#define FORMULAE_INLINE HWY_INLINE
#include "core/formulae/vocabulary-inl.h"
#undef FORMULAE_INLINE

}  // namespace patina::HWY_NAMESPACE::formulae
HWY_AFTER_NAMESPACE();

#endif  // toggled once per target
