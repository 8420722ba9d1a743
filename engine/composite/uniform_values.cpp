// SPDX-License-Identifier: MIT
#include "composite/uniform_values.h"

#include "core/formulae/formulae.h"

namespace patina {
namespace {

float combined(float below, MaskCombine combine, float entry) {
    switch (combine) {
        case MaskCombine::Replace:
            return formulae::mask_replace(below, entry);
        case MaskCombine::Multiply:
            return formulae::mask_multiply(below, entry);
        case MaskCombine::Add:
            return formulae::mask_add(below, entry);
        case MaskCombine::Subtract:
            return formulae::mask_subtract(below, entry);
        case MaskCombine::Lighten:
            return formulae::mask_lighten(below, entry);
        case MaskCombine::Darken:
            return formulae::mask_darken(below, entry);
    }
    return below;
}

}  // namespace

glm::vec3 encoded_color(const glm::vec3& color_linear) {
    return {formulae::srgb_from_linear(color_linear.x), formulae::srgb_from_linear(color_linear.y),
            formulae::srgb_from_linear(color_linear.z)};
}

glm::vec3 linear_color(const glm::vec3& color_encoded) {
    return {formulae::linear_from_srgb(color_encoded.x),
            formulae::linear_from_srgb(color_encoded.y),
            formulae::linear_from_srgb(color_encoded.z)};
}

float joined_mask_value(float below, const MaskEntry& entry, float value) {
    const Levels& levels = entry.levels;
    const float own = entry.invert ? formulae::inverted(value) : value;
    const float adjusted = formulae::levels(own, levels.in_low, levels.in_high, levels.gamma,
                                            levels.out_low, levels.out_high);
    return formulae::mix(below, combined(below, entry.combine, adjusted), entry.opacity);
}

float finished_mask_value(float value, bool invert) {
    const float held = formulae::clamp(value, 0.0f, 1.0f);
    return invert ? formulae::inverted(held) : held;
}

}  // namespace patina
