// SPDX-License-Identifier: MIT
#pragma once

/// The vocabulary of shaders/shared/ for one value at a time: Real is a float. See formulae.h.
///
/// Functions behave as in GLSL; where GLSL leaves a choice, these are the choices:
///   min(a, b) = a < b ? a : b and max(a, b) = a > b ? a : b, also for -0 (NaN is not promised),
///   mix(a, b, t) = a (1 - t) + b t, exactly a at 0 and exactly b at 1,
///   Int(real) and Uint(int) truncate and wrap; a real beyond 32 bits is not promised.

#include <cmath>
#include <cstdint>
#include <cstring>

namespace patina::formulae {

using Real = float;
using Bool = bool;
using Int = std::int32_t;
using Uint = std::uint32_t;
using uint = std::uint32_t;

inline float select(bool condition, float if_true, float if_false) {
    return condition ? if_true : if_false;
}
inline Int select(bool condition, Int if_true, Int if_false) {
    return condition ? if_true : if_false;
}
inline Uint select(bool condition, Uint if_true, Uint if_false) {
    return condition ? if_true : if_false;
}

inline bool any_lane(bool condition) {
    return condition;
}

inline float min(float a, float b) {
    return a < b ? a : b;
}
inline float max(float a, float b) {
    return a > b ? a : b;
}
inline Int min(Int a, Int b) {
    return a < b ? a : b;
}
inline Int max(Int a, Int b) {
    return a > b ? a : b;
}
inline float abs(float x) {
    return std::fabs(x);
}
inline float floor(float x) {
    return std::floor(x);
}
inline float sqrt(float x) {
    return std::sqrt(x);
}

// NOLINTNEXTLINE(readability-identifier-naming): the name is GLSL's
inline Int floatBitsToInt(float x) {
    Int bits = 0;
    std::memcpy(&bits, &x, sizeof bits);
    return bits;
}
// NOLINTNEXTLINE(readability-identifier-naming): the name is GLSL's
inline float intBitsToFloat(Int bits) {
    float x = 0.0f;
    std::memcpy(&x, &bits, sizeof x);
    return x;
}

#define FORMULAE_INLINE inline
#include "core/formulae/vocabulary-inl.h"
#undef FORMULAE_INLINE

}  // namespace patina::formulae
