// SPDX-License-Identifier: MIT

/// The formulae of shaders/shared/ over SIMD lanes, for kernels compiled once per instruction set.
/// formulae.h says what the shared texts are; this is how a kernel uses them, in a .cpp file:
///
///   #undef HWY_TARGET_INCLUDE
///   #define HWY_TARGET_INCLUDE "composite/screen_kernel.cpp"  // this file
///   #include <hwy/foreach_target.h>                           // includes it once per target
///
///   #include "core/formulae/formulae-inl.h"
///
///   HWY_BEFORE_NAMESPACE();
///   namespace patina::HWY_NAMESPACE {
///   using formulae::Real;  // the lanes of this target
///
///   // Planes of `count` floats, padded to a multiple of formulae::lane_count().
///   void screen_plane(float* backdrop, const float* source, const float* coverage,
///                     float opacity, std::size_t count) {
///       for (std::size_t i = 0; i < count; i += formulae::lane_count()) {
///           const Real below = formulae::load(backdrop + i);
///           const Real blended = formulae::blend_screen(below, formulae::load(source + i));
///           const Real weight = formulae::load(coverage + i) * opacity;
///           formulae::store(formulae::over_opaque(below, blended, weight), backdrop + i);
///       }
///   }
///
///   }  // namespace patina::HWY_NAMESPACE
///   HWY_AFTER_NAMESPACE();
///
///   #if HWY_ONCE
///   namespace patina {
///   HWY_EXPORT(screen_plane);
///   void screen(...) { HWY_DYNAMIC_DISPATCH(screen_plane)(...); }  // picks at run time
///   }  // namespace patina
///   #endif
///
/// Keep standard algorithms and containers, and any other inline function or template that is not
/// per target, out of the part between HWY_BEFORE_NAMESPACE and HWY_AFTER_NAMESPACE: the linker
/// keeps one copy of them, maybe the AVX-512 one, and older machines crash. Give a plane of 64
/// bytes' alignment and a length that is a multiple of 16 floats, the widest Real that is compiled.
/// Mark a kernel HWY_FLATTEN to have every formula that it calls inlined into its loop.

#if defined(PATINA_CORE_FORMULAE_FORMULAE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PATINA_CORE_FORMULAE_FORMULAE_INL_H
#undef PATINA_CORE_FORMULAE_FORMULAE_INL_H
#else
#define PATINA_CORE_FORMULAE_FORMULAE_INL_H
#endif

#include "core/formulae/real-inl.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-parameter"

HWY_BEFORE_NAMESPACE();
namespace patina::HWY_NAMESPACE::formulae {
namespace {
#include "core/formulae/texts-inl.h"
}  // namespace
}  // namespace patina::HWY_NAMESPACE::formulae
HWY_AFTER_NAMESPACE();

#pragma GCC diagnostic pop

#endif  // toggled once per target
