// SPDX-License-Identifier: MIT
#pragma once

/// The blend modes that take each number by itself, and their formulae in
/// shaders/shared/blend.glsl: PATINA_SCALAR_MODES(ROW) is ROW(Darken, blend_darken) and so on, for
/// whatever a kernel makes of each. Normal and Replace, of the same formula, are left to whoever
/// tells them apart.
#define PATINA_SCALAR_MODES(ROW)                  \
    ROW(Darken, blend_darken)                     \
    ROW(Multiply, blend_multiply)                 \
    ROW(ColorBurn, blend_color_burn)              \
    ROW(LinearBurn, blend_linear_burn)            \
    ROW(Lighten, blend_lighten)                   \
    ROW(Screen, blend_screen)                     \
    ROW(ColorDodge, blend_color_dodge)            \
    ROW(Add, blend_add)                           \
    ROW(Overlay, blend_overlay)                   \
    ROW(SoftLightW3c, blend_soft_light_w3c)       \
    ROW(SoftLightPegtop, blend_soft_light_pegtop) \
    ROW(HardLight, blend_hard_light)              \
    ROW(VividLight, blend_vivid_light)            \
    ROW(LinearLight, blend_linear_light)          \
    ROW(PinLight, blend_pin_light)                \
    ROW(HardMix, blend_hard_mix)                  \
    ROW(Difference, blend_difference)             \
    ROW(Exclusion, blend_exclusion)               \
    ROW(Subtract, blend_subtract)                 \
    ROW(InverseSubtract, blend_inverse_subtract)  \
    ROW(Divide, blend_divide)                     \
    ROW(InverseDivide, blend_inverse_divide)      \
    ROW(SignedAdd, blend_signed_add)              \
    ROW(Average, blend_average)
