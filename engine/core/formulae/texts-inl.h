// SPDX-License-Identifier: MIT
// No include guard: formulae.h and formulae-inl.h include this inside a namespace, once for each
// meaning of Real. Every file of shaders/shared/ but the GLSL prelude stands in both lists.

#undef SHARED_BLEND_GLSL
#undef SHARED_COMPOSITING_GLSL

#include "shared/blend.glsl"
#include "shared/compositing.glsl"
