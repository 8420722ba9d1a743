// SPDX-License-Identifier: MIT
#include "composite/uniform_values.h"

#include "composite/adjust_kernels.h"
#include "composite/mask_kernels.h"
#include "core/formulae/formulae.h"

namespace patina {

glm::vec3 encoded_color(const glm::vec3& color_linear) {
    return {formulae::srgb_from_linear(color_linear.x), formulae::srgb_from_linear(color_linear.y),
            formulae::srgb_from_linear(color_linear.z)};
}

glm::vec3 linear_color(const glm::vec3& color_encoded) {
    return {formulae::linear_from_srgb(color_encoded.x),
            formulae::linear_from_srgb(color_encoded.y),
            formulae::linear_from_srgb(color_encoded.z)};
}

float adjusted_mask_value(const AdjustmentSettings& adjustment, float below) {
    if (looks_around(adjustment.kind)) return below;
    const UniformPlane from(below);
    UniformPlane to;
    run_adjustment({.adjustment = &adjustment,
                    .channel = AroundRecord::kMaskChannel,
                    .count = 1,
                    .from = {from.lanes},
                    .to = {to.lanes}});
    return to.lanes[0];
}

float joined_mask_value(float below, const MaskEntry& entry, float value) {
    UniformPlane mask(below);
    const UniformPlane source(value);
    join_mask_tile({.mask = mask.lanes,
                    .blocks = all_blocks(1),
                    .source = source.plane(),
                    .combine = entry.combine,
                    .opacity = entry.opacity,
                    .invert = entry.invert,
                    .levels = &entry.levels,
                    .count = 1});
    return mask.lanes[0];
}

}  // namespace patina
