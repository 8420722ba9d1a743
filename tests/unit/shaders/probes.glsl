// SPDX-License-Identifier: MIT
// Calls of the shared formulae, as a text that is GLSL and C++ like they are: lanes_test.cpp runs
// it over SIMD lanes and one value at a time, gpu_test.cpp in a fragment shader, and both compare.
// probes.h names the probes in this order and says how far the GPU may be off.
#ifndef PROBES_GLSL
#define PROBES_GLSL

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

/// A unit normal of the upper half-space, at most 70 degrees from flat.
Real3 probe_normal(Real4 a) {
    return unit_normal(Real3(a.x * 2.0f - 1.0f, a.y * 2.0f - 1.0f, a.z + 0.5f));
}

Ramp probe_ramp() {
    Ramp ramp;
    ramp.count = 3;
    for (int i = 0; i < 8; ++i) {
        ramp.stops[i].position = float(i) * 0.5f;
        ramp.stops[i].x = float(i) * 0.25f;
        ramp.stops[i].y = float((i * 3) & 3);
        ramp.stops[i].z = 1.0f - float(i);
    }
    return ramp;
}

Real4 probe_blend(int which, Real4 a, Real4 b) {
    if (which == 0)
        return Real4(blend_normal(a.x, b.x), blend_multiply(a.x, b.x), blend_screen(a.x, b.x),
                     blend_add(a.x, b.x));
    if (which == 1)
        return Real4(blend_hard_light(a.x, b.x), blend_overlay(a.x, b.x),
                     blend_soft_light_w3c(a.x, b.x), blend_subtract(a.x, b.x));
    if (which == 2)
        return Real4(blend_darken(a.x, b.x), blend_lighten(a.x, b.x), blend_difference(a.x, b.x),
                     over_coverage(a.x, b.x));
    if (which == 3)
        return Real4(blend_linear_burn(a.x, b.x), blend_soft_light_pegtop(a.x, b.x),
                     blend_linear_light(a.x, b.x), blend_pin_light(a.x, b.x));
    if (which == 4)
        return Real4(blend_hard_mix(a.x, b.x * 0.7f + 0.001f), blend_exclusion(a.x, b.x),
                     blend_inverse_subtract(a.x, b.x), blend_signed_add(a.x, b.x));
    // Quotients by what is not next to 0, where any rounding is large.
    if (which == 5)
        return Real4(blend_color_burn(a.x, b.x * 0.9f + 0.1f), blend_color_dodge(a.x, b.x * 0.9f),
                     blend_divide(a.x, b.x * 0.9f + 0.1f),
                     blend_inverse_divide(a.x * 0.9f + 0.1f, b.x));
    if (which == 6)
        return Real4(blend_vivid_light(a.x, b.x * 0.8f + 0.1f), blend_average(a.x, b.x),
                     height_min(a.x, b.x), height_subtract(a.x, b.x));
    Real3 below = Real3(a.x, a.y, a.z);
    // Never grey, whose hue any rounding decides.
    Real3 vivid_below = Real3(0.5f + 0.5f * a.x, 0.4f * a.y, 0.4f * a.z);
    Real3 own = Real3(0.4f * b.x, 0.5f + 0.5f * b.y, 0.4f * b.z);
    if (which == 7) return Real4(blend_hue_w3c(below, own), blend_value_hsv(vivid_below, own).x);
    if (which == 8)
        return Real4(blend_saturation_w3c(vivid_below, own), blend_color_w3c(below, own).x);
    if (which == 9)
        return Real4(blend_luminosity_w3c(vivid_below, own), blend_tint_hsv(below, own).x);
    if (which == 10)
        return Real4(blend_saturation_hsv(vivid_below, own), blend_color_hsv(below, own).x);
    if (which == 11)
        return Real4(normal_blend_partial_derivative(probe_normal(a), probe_normal(b)),
                     unpremultiplied(replaced_premultiplied(a.x, a.y, b.x, b.y, b.z),
                                     replaced_coverage(a.y, b.y, b.z)));
    return Real4(over_premultiplied(a.x, a.y, b.x, b.y, b.z), unpremultiplied(a.x, b.x),
                 over_opaque(a.x, b.x, b.y), luminance(srgb_from_linear(Real3(a.x, a.y, a.z))));
}

Real4 probe_adjust(int which, Real4 a) {
    Curve curve;
    curve.count = 3;
    for (int i = 0; i < 8; ++i) {
        curve.points[i].x = float(i) * 0.5f;
        curve.points[i].y = float((i * 3) & 3) * 0.3f;
        curve.points[i].slope = 0.4f;
    }
    if (which == 0)
        return Real4(curve_value(curve, a.x), brightened(a.y, 0.1f, 0.3f),
                     brightened(a.z, -0.2f, 0.0f), posterised(a.w * 0.9f + 0.013f, 5.0f));
    // Never grey, whose hue any rounding decides.
    Real3 color = Real3(0.5f + 0.5f * a.x, 0.4f * a.y, 0.4f * a.z);
    return Real4(hue_saturation(color, 3.3f, 0.4f, 0.1f),
                 hue_saturation(color, 4.6f, -0.4f, -0.3f).y);
}

Real4 probe_surface(int which, Real4 a, Real4 b) {
    if (which == 0)
        return Real4(srgb_from_linear(a.x), linear_from_srgb(a.x), luminance(Real3(a.x, a.y, a.z)),
                     linear_from_srgb(Real3(b.x, b.y, b.z)).y);
    if (which == 1)
        return Real4(normal_blend_rnm(probe_normal(a), probe_normal(b)), height_add(a.w, b.w));
    if (which == 2)
        return Real4(normal_blend_udn(probe_normal(a), normal_faded(probe_normal(b), a.w)),
                     height_max(a.w, b.w));
    if (which == 3)
        return Real4(normal_blend_whiteout(probe_normal(a), probe_normal(b)),
                     height_slope(a.x, a.y, a.z, b.x, b.y, b.z));
    if (which == 4)
        return Real4(normal_over(unit_normal(signed_from_encoded(Real3(a.x, a.y, 0.9f))), probe_normal(b), b.w),
                     encoded_from_signed(height_normal(a.z, b.z)).x);
    if (which == 5)
        return Real4(levels(a.x, 0.25f, 0.75f, 1.0f, 0.0f, 1.0f),
                     levels(a.y, 0.1f, 0.8f, 2.2f, 1.0f, 0.2f), contrasted(a.z, 0.5f, 0.25f),
                     contrasted(inverted(a.w), -0.5f, 0.75f));
    if (which == 6)
        return Real4(blend_add(a.x, b.x), blend_subtract(a.x, b.x),
                     blend_lighten(a.y, blend_multiply(a.x, b.x)),
                     blend_darken(a.y, blend_normal(a.x, b.x)));
    return Real4(ramp_color(probe_ramp(), a.x), ramp_scalar(probe_ramp(), b.x));
}

Real4 probe_number(int which, Real4 a, Real4 b) {
    if (which == 0)
        return Real4(exp2_poly(a.x * 40.0f - 20.0f), log2_poly(a.y + 1e-6f),
                     pow_poly(a.z, b.z * 4.0f + 0.1f), acos_poly(a.w * 2.0f - 1.0f));
    return Real4(sin_poly(a.x * 20.0f - 10.0f), cos_poly(a.y * 20.0f - 10.0f),
                 atan2_poly(a.z - 0.5f, b.z - 0.5f), 0.0f);
}

Real4 probe_noise(int which, Real4 a, Real4 b) {
    Real2 position = Real2(a.x * 40.0f - 8.0f, b.x * 40.0f - 8.0f);
    if (which == 0)
        return Real4(value_noise(position, 16, 1u), perlin_noise(position, 16, 2u),
                     worley_noise(position, 16, 3u), noise(NOISE_PERLIN, position, 5, 9u, 0.1f));
    return Real4(fbm(NOISE_VALUE, position, 7, 4u, 4, 0.5f, 0.0f),
                 fbm(NOISE_PERLIN, position, 16, 5u, 5, 0.6f, 0.05f),
                 fbm(NOISE_WORLEY, position, 3, 6u, 3, 0.5f, 0.1f), 0.0f);
}

/// Soft enough that a rounding does not decide which cell a place belongs to.
Pattern probe_pattern(int kind) {
    Pattern pattern;
    pattern.kind = kind;
    pattern.columns = 4;
    pattern.rows = 6;
    pattern.seed = 11u;
    pattern.octaves = 2;
    pattern.width = 0.6f;
    pattern.softness = 0.2f;
    pattern.variation = 0.4f;
    pattern.warp = kind == PATTERN_CHECKER ? 0.3f : 0.0f;
    pattern.footprint = 0.1f;
    return pattern;
}

/// Kinds 4 which to 4 which + 3.
Real4 probe_patterns(int which, Real4 a, Real4 b) {
    Real2 position = Real2(a.x * 4.0f, b.x * 6.0f);
    return Real4(pattern_value(probe_pattern(4 * which), position),
                 pattern_value(probe_pattern(4 * which + 1), position),
                 pattern_value(probe_pattern(4 * which + 2), position),
                 pattern_value(probe_pattern(4 * which + 3), position));
}

Real4 probe_light(int which, Real4 a, Real4 b) {
    ReflectionAngles angles =
        reflection_angles(Real3(0.0f, 0.0f, 1.0f), probe_normal(a), probe_normal(b));
    Real roughness = 0.2f + 0.8f * a.w;
    Real alpha = alpha_from_roughness(roughness);
    Real3 base = Real3(b.x, b.y, b.w);
    Real3 f0 = material_f0(dielectric_f0(1.0f + a.x, 0.5f, base), base, a.y);
    if (which == 0)
        return Real4(distribution_ggx(angles.n_dot_h, alpha),
                     distribution_beckmann(angles.n_dot_h, alpha),
                     distribution_blinn_phong(angles.n_dot_h, alpha), f0.x);
    if (which == 1)
        return Real4(visibility_smith_separable(angles.n_dot_l, angles.n_dot_v, alpha),
                     visibility_smith_correlated(angles.n_dot_l, angles.n_dot_v, alpha),
                     visibility_schlick_ggx(angles.n_dot_l, angles.n_dot_v, alpha),
                     visibility_lecture(angles.n_dot_l, angles.n_dot_v, alpha));
    BrdfTerms terms;
    terms.distribution = DISTRIBUTION_GGX;
    terms.geometry = GEOMETRY_SMITH_SEPARABLE;
    terms.fresnel = which == 2 ? FRESNEL_SCHLICK : FRESNEL_SPHERICAL_GAUSSIAN;
    terms.diffuse = which == 2 ? DIFFUSE_BURLEY : DIFFUSE_OREN_NAYAR;
    Real f90 = material_f90(0.5f, a.y);
    Real3 specular = brdf_specular(terms, angles, f0, f90, roughness);
    Real3 diffuse = brdf_diffuse(terms, angles, diffuse_color(base, a.y), f0, f90, roughness);
    return Real4(specular + diffuse, multiple_scattering_scale(f0, roughness).x);
}

Real4 probe_phong(int which, Real4 a, Real4 b) {
    Real3 base = Real3(b.x, b.y, b.z);
    if (which == 0) {
        // Exponents grow without end as roughness falls: compare what they are used for.
        PhongMaterial phong = phong_material(base, a.x, a.y * 0.9f + 0.1f, base);
        PhongMaterial blinn = blinn_phong_material(base, a.x, a.y * 0.9f + 0.1f, base);
        return Real4(phong_lobe(0.9f + 0.1f * b.w, a.z, phong.exponent),
                     blinn_phong_lobe(0.9f + 0.1f * b.w, a.z, blinn.exponent), phong.diffuse.x,
                     blinn.specular.y);
    }
    if (which == 6) return Real4(heat_map_inferno(a.x), 0.0f);
    Real3 color = Real3(a.x, a.y, a.z) * (b.w * 4.0f);
    return Real4(tone_map(which - 1, color), 0.0f);
}

Real4 probe_environment(int which, Real4 a, Real4 b) {
    Real3 direction = equirect_direction(Real2(a.x, a.y));
    if (which == 0)
        return Real4(direction, filtered_level(0.01f + b.x, Real(0.02f)) +
                                    disc_in_level(2.0f * b.y - 1.0f, 0.5f + 0.5f * b.z, 0.1f));
    if (which == 1) {
        // Away from the seam and the poles, where a rounding of the direction turns the angle.
        Real3 middle = equirect_direction(Real2(0.1f + 0.8f * a.x, 0.1f + 0.8f * a.y));
        Real2 uv = equirect_uv(middle);
        return Real4(uv.x, uv.y, cube_texel_solid_angle(a.z, b.z, 8.0f),
                     cube_direction(3, a.z, b.z).y);
    }
    if (which == 3) {
        Real3 v = normalize(Real3(a.x - 0.5f, a.y - 0.5f, 0.1f + a.z));
        Real alpha = alpha_from_roughness(0.2f + 0.8f * b.z);
        Real3 h = sample_ggx_visible_half_vector(Real2(b.x, b.y), v, alpha);
        return Real4(h, ggx_visible_density(b.w, v.z, alpha));
    }
    Real2 point = hammersley(Uint(Int(a.x * 63.0f)), 64u);
    BrdfTerms terms;
    terms.distribution = DISTRIBUTION_GGX;
    terms.geometry = GEOMETRY_SMITH_CORRELATED;
    terms.fresnel = FRESNEL_SCHLICK;
    terms.diffuse = DIFFUSE_LAMBERT;
    SplitSumSample table = split_sum_sample(terms, point, 0.1f + 0.9f * b.x,
                                            alpha_from_roughness(0.2f + 0.8f * b.y));
    Real level = prefiltered_level_share(b.z);
    return Real4(table.scale + schlick_mean(a.w), table.bias + roughness_under_disc(a.y, 0.1f) + roughness_with_variance(a.y, b.w),
                 point.y + table.light.z, prefiltered_roughness(level) + level);
}

Real4 probe_heights(Real4 a, Real4 b) {
    return Real4(height_share(a.x, b.x, 0.0f, 0.3f, 0.0f),
                 height_share(a.y, b.y, -0.2f, 0.5f, 0.6f),
                 height_share(a.z, b.z, 0.1f, 1.0f, 0.3f), height_share(a.w, b.w, 0.0f, 0.1f, 0.5f));
}

Real4 probe_neighbourhood(Real4 a, Real4 b) {
    Real2 direction = warp_direction(Real2(a.z * 8.0f, b.z * 8.0f), 8, 7u, 2, 0.05f);
    return Real4(blur_weight(a.x * 8.0f, 6.0f), sharpened(a.y, b.y, 1.5f), direction.x,
                 direction.y);
}

Real4 probe_relief(Real4 a, Real4 b) {
    return Real4(relief_value(RELIEF_HEIGHT, a.x - 0.5f, b.x, 1.5f),
                 relief_value(RELIEF_CAVITY, a.y, b.y, 2.0f),
                 relief_value(RELIEF_EDGE, a.z, b.z, 2.0f),
                 relief_value(RELIEF_CURVATURE, a.w, b.w, 2.0f));
}

SeenRectangle probe_rectangle(Real4 a, Real4 b) {
    SeenRectangle r;
    r.middle = Real3(a.x - 0.5f, a.y - 0.5f, 1.0f + a.z);
    r.shines = normalize(Real3(b.x - 0.5f, b.y - 0.5f, Real(-1.0f)));
    Across frame = across_of(r.shines);
    r.across = frame.x_axis;
    r.up = frame.y_axis;
    r.half_width = 0.1f + 0.5f * b.z;
    r.half_height = 0.1f + 0.5f * b.w;
    return r;
}

Real4 probe_area_light(int which, Real4 a, Real4 b) {
    SeenRectangle r = probe_rectangle(a, b);
    Real3 towards = normalize(r.middle);
    if (which == 0)
        return Real4(sphere_share(1.8f * a.x - 0.9f, 0.05f + 0.7f * a.y),
                     share_of_vector(rectangle_irradiance(r), probe_normal(b)),
                     sphere_density(0.1f + a.w), 0.0f);
    if (which == 1)
        return Real4(rectangle_direction(Real2(0.05f + 0.9f * a.w, 0.05f + 0.9f * a.x), r),
                     rectangle_density(towards, r));
    if (which == 2)
        return Real4(sphere_direction(Real2(a.w, b.x), towards, 0.1f + 0.8f * b.y),
                     sphere_is_met(towards, r.middle, Real(0.1f)) + 2.0f * rectangle_is_met(towards, r));
    Real3 normal = probe_normal(a);
    Real3 v = probe_normal(b);
    Real roughness = 0.4f + 0.6f * a.w;
    Real alpha = alpha_from_roughness(roughness);
    Highlight sphere = sphere_highlight(towards, 0.1f + 0.8f * b.y, v, normal, alpha);
    Highlight rectangle = rectangle_highlight(r, v, normal, alpha);
    BrdfTerms terms;
    terms.distribution = DISTRIBUTION_BECKMANN;
    terms.geometry = GEOMETRY_SMITH_SEPARABLE;
    terms.fresnel = FRESNEL_SCHLICK;
    terms.diffuse = DIFFUSE_LAMBERT;
    ReflectionAngles angles =
        reflection_angles(normal, v, highlight_direction(rectangle, v, normal));
    return Real4(sphere.share, sphere.slope.x + sphere.slope.y, rectangle.share,
                 brdf_of_highlight(terms, angles, sphere.share, Real3(0.5f), Real(1.0f), roughness).x);
}

Real4 probe_ambient(int which, Real4 a, Real4 b) {
    BrdfTerms terms;
    terms.distribution = DISTRIBUTION_BECKMANN;
    terms.geometry = GEOMETRY_SCHLICK_GGX;
    terms.fresnel = FRESNEL_SPHERICAL_GAUSSIAN;
    terms.diffuse = DIFFUSE_OREN_NAYAR;
    terms = ambient_terms(terms);
    Real2 point = hammersley(Uint(Int(a.x * 63.0f)), 64u);
    if (which == 1) {
        SplitSumSample table = split_sum_sample(terms, point, 0.1f + 0.9f * b.x,
                                                alpha_from_roughness(0.3f + 0.7f * b.y));
        return Real4(table.scale, table.bias, table.light.x, table.light.z);
    }
    DiffuseSample diffuse = diffuse_sample(terms, point, 0.1f + 0.9f * b.x, b.y);
    return Real4(mirrored_share(a.x, a.y, 0.01f + 0.99f * a.z), horizon_share(2.0f * a.w - 1.0f),
                 diffuse.entering, diffuse.grazing);
}

Real4 probe_projection(Real4 a, Real4 b) {
    Real side = select(b.w < 0.5f, Real(-1.0f), Real(1.0f));
    Real3 weights = projection_weights(probe_normal(a), 0.4f);
    Real3 position = Real3(b.x, b.y, b.z);
    Real2 place = projected_place(0, position, side) + projected_place(1, position, side) * 2.0f +
                  projected_place(2, position, side) * 4.0f;
    Real3 normal = probe_normal(b);
    Real3 lean = projected_lean(0, normal, side) + projected_lean(1, normal, side) * 2.0f +
                 projected_lean(2, normal, side) * 4.0f;
    return Real4(weights.x + 2.0f * weights.y, place.x, place.y, lean.x + 8.0f * (lean.y + lean.z));
}

Real4 probe_lamp(Real4 a, Real4 b) {
    Real3 place = rectangle_point(Real2(a.x, b.x), probe_rectangle(b, a));
    return Real4(range_window(4.0f * a.y, b.y) + range_window(a.y, Real(0.0f)),
                 cone_window(2.0f * a.z - 1.0f, 1.0f + 4.0f * b.z, b.w - 1.0f),
                 place.x + place.y, place.z);
}

Real4 probe_fading(Real4 a, Real4 b) {
    return Real4(spread_pattern(shown_about(0.4f, 0.3f), a.x),
                 spread_pattern(shown_about(0.4f, 1.0f), a.y),
                 faded_result(shown_about(0.4f, 0.3f), b.x, 0.7f),
                 faded_result(shown_about(0.4f, 1.0f), b.y, 0.7f));
}

Real4 probe_from_middle(Real4 a, Real4 b) {
    Real2 pixel = floor(Real2(a.x * 7.0f, b.x * 7.0f));
    return Real4(interleaved_gradient_noise(pixel), sphere_from_middle(0.1f + a.y, b.y),
                 rectangle_from_middle(0.1f + a.z, b.z, 2.0f * a.w - 1.0f),
                 dielectric_part_f0(Real3(b.w), Real3(0.2f), 0.9f * a.x).x +
                     luma_bt601(Real3(a.x, a.y, a.z)));
}

/// Probe number `which` of inputs a and b, each component 0..1; -1 past the last one.
Real4 probe(int which, Real4 a, Real4 b) {
    if (which < 13) return probe_blend(which, a, b);
    if (which < 21) return probe_surface(which - 13, a, b);
    if (which < 23) return probe_number(which - 21, a, b);
    if (which < 25) return probe_noise(which - 23, a, b);
    if (which < 31) return probe_patterns(which - 25, a, b);
    if (which < 35) return probe_light(which - 31, a, b);
    if (which < 42) return probe_phong(which - 35, a, b);
    if (which < 46) return probe_environment(which - 42, a, b);
    if (which < 48) return probe_adjust(which - 46, a);
    if (which == 48) return probe_heights(a, b);
    if (which == 49) return probe_neighbourhood(a, b);
    if (which == 50) return probe_relief(a, b);
    if (which < 55) return probe_area_light(which - 51, a, b);
    if (which < 57) return probe_ambient(which - 55, a, b);
    if (which == 57) return probe_projection(a, b);
    if (which == 58) return probe_lamp(a, b);
    if (which == 59) return probe_fading(a, b);
    if (which == 60) return probe_from_middle(a, b);
    if (which == 61)
        return Real4(normal_in_group(probe_normal(a), b.x, probe_normal(b), b.y),
                     finished_mask(2.0f * a.x - 0.5f, false) + finished_mask(a.y, true));
    return Real4(-1.0f);
}

#endif
