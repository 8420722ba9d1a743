// SPDX-License-Identifier: MIT

/// Planes of a tile as lanes of floats, for the kernels of the compositor.

#if defined(PATINA_COMPOSITE_PLANE_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef PATINA_COMPOSITE_PLANE_LANES_INL_H
#undef PATINA_COMPOSITE_PLANE_LANES_INL_H
#else
#define PATINA_COMPOSITE_PLANE_LANES_INL_H
#endif

#include "composite/planes.h"
#include "core/formulae/formulae-inl.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"

HWY_BEFORE_NAMESPACE();
namespace patina::HWY_NAMESPACE {
namespace {

using formulae::lane_count;
using formulae::load;
using formulae::Real;
using formulae::Real3;
using formulae::store;

/// lane_count() texels from texel `i` on: of one plane, or of three.
HWY_INLINE Real load(const ReadPlane& plane, std::size_t i) {
    return load(plane.data + i * plane.step);
}
HWY_INLINE Real3 load(const ReadPlane* planes, std::size_t i) {
    return Real3(load(planes[0], i), load(planes[1], i), load(planes[2], i));
}
HWY_INLINE Real3 load(const float* const* planes, std::size_t i) {
    return Real3(load(planes[0] + i), load(planes[1] + i), load(planes[2] + i));
}
HWY_INLINE void store(const Real3& values, float* const* planes, std::size_t i) {
    store(values.x, planes[0] + i);
    store(values.y, planes[1] + i);
    store(values.z, planes[2] + i);
}

}  // namespace
}  // namespace patina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#pragma GCC diagnostic pop

#endif  // toggled once per target
