// SPDX-License-Identifier: MIT
#pragma once

/// The formulae of shaders/shared/ for one value at a time: `formulae::Real` is a float.
///
/// The texts in shaders/shared/ are GLSL 4.10 and C++ at once. What makes that work is a
/// vocabulary:
///
///   per lane (may differ from texel to texel)   Real Real2 Real3 Real4 Int Uint Bool
///   uniform (the same for every texel)          float int uint bool
///   functions                                   GLSL's own under GLSL's names (min, mix, dot ...),
///                                               select(condition, if_true, if_false), and
///                                               any_lane(condition), which is uniform: an `if` on
///                                               it leaves out what would change no value
///
/// It has three forms. GLSL: shaders/shared/prelude.glsl makes Real a name for float; the loader of
/// gl::Program puts it in front of every shader. One value in C++: this header. SIMD lanes in C++:
/// core/formulae/formulae-inl.h, for kernels that are compiled once per instruction set. All of the
/// C++ forms give the same bits on every instruction set and compiler (-ffp-contract=off; nothing
/// but correctly rounded operations; no libm).
///
/// What the texts keep to: pure functions; literals end in f; members are x, y, z, w, with no
/// swizzles; no `if` or loop on a per-lane value (use select), loops over uniform counts are fine;
/// no arrays but in structs; no pow, exp, log, sin, cos: shared/transcendental.glsl has Patina's
/// own. A new file in shaders/shared/ is added to core/formulae/texts-inl.h and has an include
/// guard SHARED_<NAME>_GLSL.
///
/// These functions have internal linkage, so include this in .cpp files, not in public headers.

#include "core/formulae/real.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-parameter"

namespace patina::formulae {
namespace {
#include "core/formulae/texts-inl.h"
}  // namespace
}  // namespace patina::formulae

#pragma GCC diagnostic pop
