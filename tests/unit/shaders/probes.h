// SPDX-License-Identifier: MIT
#pragma once

/// What the probes of probes.glsl are, and the inputs that they are run over.

#include <array>
#include <cstddef>
#include <vector>

namespace patina {

struct Probe {
    const char* name;
    /// How far a GPU may be off, relative to max(1, |value|): GLSL lets it fuse and reorder. Narrow
    /// highlights magnify a rounding of n.h by 1 / alpha^2, which is 600 at the least roughness
    /// here.
    float gpu_tolerance;
};

inline constexpr Probe kProbes[] = {
    {"blend: normal, multiply, screen, add", 1e-6f},
    {"blend: hard light, overlay, soft light, subtract", 1e-6f},
    {"blend: darken, lighten, difference; over_coverage", 1e-6f},
    {"blend: linear burn, soft light pegtop, linear light, pin light", 1e-6f},
    {"blend: hard mix, exclusion, inverse subtract, signed add", 1e-6f},
    {"blend: colour burn, colour dodge, divide, inverse divide", 4e-6f},
    {"blend: vivid light, average; height_min, height_subtract", 4e-6f},
    {"blend: hue w3c, value hsv", 4e-6f},
    {"blend: saturation w3c, colour w3c", 4e-6f},
    {"blend: luminosity w3c, tint hsv", 4e-6f},
    {"blend: saturation hsv, colour hsv", 4e-6f},
    {"normal_blend_partial_derivative; replaced_premultiplied, replaced_coverage", 4e-6f},
    {"over_premultiplied, unpremultiplied, over_opaque; srgb of colours", 4e-6f},
    {"srgb_from_linear, linear_from_srgb, luminance", 2e-6f},
    {"normal_blend_rnm; height_add", 2e-6f},
    {"normal_blend_udn, normal_faded; height_max", 2e-6f},
    {"normal_blend_whiteout; height_slope", 2e-6f},
    {"normal_over, signed_from_encoded, encoded_from_signed; height_normal", 2e-6f},
    {"levels, contrasted, inverted", 4e-6f},
    {"mask: add, subtract, lighten, multiply, darken, replace", 1e-6f},
    {"ramp_color, ramp_scalar", 2e-6f},
    {"exp2_poly, log2_poly, pow_poly, acos_poly", 4e-6f},
    {"sin_poly, cos_poly, atan2_poly", 2e-6f},
    {"value_noise, perlin_noise, worley_noise", 1e-5f},
    {"fbm of the three noises", 4e-6f},
    {"pattern: value, perlin, worley, simplex", 1e-5f},
    {"pattern: ridged, turbulence, worley f2, worley edges", 2e-5f},
    {"pattern: cells; gradients linear, radial, angular", 4e-5f},
    {"pattern: checker, stripes, bricks, tiles", 4e-5f},
    {"pattern: hexagons, weave, spots, scratches", 1e-4f},
    {"pattern: cracks, wood rings, marble, grunge", 1e-4f},
    {"distribution: ggx, beckmann, blinn_phong; material_f0", 3e-4f},
    {"visibility: smith, correlated, schlick_ggx, lecture", 4e-6f},
    {"brdf: burley with schlick", 3e-4f},
    {"brdf: oren_nayar with spherical gaussian", 3e-4f},
    {"phong_material and blinn_phong_material, and their lobes", 4e-5f},
    {"tone_map_none", 1e-6f},
    {"tone_map_reinhard", 2e-6f},
    {"tone_map_aces", 4e-6f},
    {"tone_map_agx", 2e-5f},
    {"tone_map_pbr_neutral", 4e-6f},
    {"heat_map_inferno", 1e-5f},
    {"equirect_direction, filtered_level, disc_in_level", 2e-5f},
    {"equirect_uv, cube_texel_solid_angle, cube_direction", 4e-6f},
    {"split_sum_sample, schlick_mean, roughness_under_disc, prefiltered_roughness ...", 1e-4f},
    {"sample_ggx_visible_half_vector, ggx_visible_density", 3e-4f},
    {"curve_value, brightened, posterised", 4e-6f},
    {"hue_saturation", 8e-6f},
    {"height_share", 2e-5f},
    {"blur_weight, sharpened, warp_direction", 1e-5f},
    {"relief_value", 2e-6f},
    {"sphere_share, share_of_vector, sphere_density", 1e-4f},
    {"rectangle_direction, rectangle_density", 1e-3f},
    {"sphere_direction, sphere_is_met, rectangle_is_met", 1e-5f},
    {"sphere_highlight, rectangle_highlight, brdf_of_highlight", 1e-3f},
    {"mirrored_share, horizon_share, diffuse_sample", 1e-4f},
    {"split_sum_sample of other terms", 3e-4f},
    {"projection_weights, projected_place, projected_lean", 1e-5f},
    {"range_window, cone_window, rectangle_point", 1e-5f},
    {"spread_pattern, faded_result", 2e-6f},
    {"interleaved_gradient_noise, sphere_from_middle, luma_bt601 ...", 1e-5f},
    {"normal_in_group; finished_mask", 2e-6f},
};
inline constexpr int kProbeCount = static_cast<int>(std::size(kProbes));

/// The inputs a and b of the probes as eight planes (a.x ... b.w) of kProbeInputs floats in 0..1:
/// every second value is 0, 1 or a branch point of some formula, the rest are random, always the
/// same.
inline constexpr std::size_t kProbeInputs = 64 * 64;
using ProbeInputs = std::array<std::vector<float>, 8>;
const ProbeInputs& probe_inputs();

}  // namespace patina
