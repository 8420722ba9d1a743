// SPDX-License-Identifier: MIT
// No include guard: formulae.h and formulae-inl.h include this inside a namespace, once for each
// meaning of Real. Every file of shaders/shared/ but the GLSL prelude stands in both lists.

#undef SHARED_ADJUST_GLSL
#undef SHARED_AREA_LIGHT_GLSL
#undef SHARED_BLEND_COLOR_GLSL
#undef SHARED_BLEND_GLSL
#undef SHARED_BRDF_GLSL
#undef SHARED_COLOR_GLSL
#undef SHARED_COMPOSITING_GLSL
#undef SHARED_DITHER_GLSL
#undef SHARED_ENVIRONMENT_GLSL
#undef SHARED_HEAT_MAP_GLSL
#undef SHARED_HEIGHT_GLSL
#undef SHARED_LAMP_GLSL
#undef SHARED_MASK_GLSL
#undef SHARED_NEIGHBOURHOOD_GLSL
#undef SHARED_NOISE_GLSL
#undef SHARED_NORMAL_BLEND_GLSL
#undef SHARED_PATTERN_GLSL
#undef SHARED_PHONG_GLSL
#undef SHARED_PROJECTION_GLSL
#undef SHARED_RAMP_GLSL
#undef SHARED_SEQUENCE_GLSL
#undef SHARED_TONE_MAP_GLSL
#undef SHARED_TRANSCENDENTAL_GLSL

#include "shared/adjust.glsl"
#include "shared/area_light.glsl"
#include "shared/blend.glsl"
#include "shared/blend_color.glsl"
#include "shared/brdf.glsl"
#include "shared/color.glsl"
#include "shared/compositing.glsl"
#include "shared/dither.glsl"
#include "shared/environment.glsl"
#include "shared/heat_map.glsl"
#include "shared/height.glsl"
#include "shared/lamp.glsl"
#include "shared/mask.glsl"
#include "shared/neighbourhood.glsl"
#include "shared/noise.glsl"
#include "shared/normal_blend.glsl"
#include "shared/pattern.glsl"
#include "shared/phong.glsl"
#include "shared/projection.glsl"
#include "shared/ramp.glsl"
#include "shared/sequence.glsl"
#include "shared/tone_map.glsl"
#include "shared/transcendental.glsl"
