// SPDX-License-Identifier: MIT
#include "shaders/published_modes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "shaders/published_hsv.h"

namespace patina::test_support {
namespace {

double held(double x) {
    return std::clamp(x, 0.0, 1.0);
}

double multiply(double cb, double cs) {
    return cb * cs;
}
double screen(double cb, double cs) {
    return cb + cs - cb * cs;
}
double color_dodge(double cb, double cs) {
    if (cb == 0) return 0;
    if (cs == 1) return 1;
    return std::min(1.0, cb / (1 - cs));
}
double color_burn(double cb, double cs) {
    if (cb == 1) return 1;
    if (cs == 0) return 0;
    return 1 - std::min(1.0, (1 - cb) / cs);
}
double hard_light(double cb, double cs) {
    return cs <= 0.5 ? multiply(cb, 2 * cs) : screen(cb, 2 * cs - 1);
}
double soft_light_w3c(double cb, double cs) {
    const double d = cb <= 0.25 ? ((16 * cb - 12) * cb + 4) * cb : std::sqrt(cb);
    return cs <= 0.5 ? cb - (1 - 2 * cs) * cb * (1 - cb) : cb + (2 * cs - 1) * (d - cb);
}
double divide(double cb, double cs) {
    if (cb == 0) return 0;
    return cs == 0 ? 1 : held(cb / cs);
}

// W3C, "non-separable blend modes", as its pseudo-code has it.

double lum(const glm::dvec3& c) {
    return 0.3 * c.r + 0.59 * c.g + 0.11 * c.b;
}
glm::dvec3 clip_color(glm::dvec3 c) {
    const double l = lum(c);
    const double n = std::min({c.r, c.g, c.b});
    const double x = std::max({c.r, c.g, c.b});
    if (n < 0) c = l + (c - l) * l / (l - n);
    if (x > 1) c = l + (c - l) * (1 - l) / (x - l);
    return c;
}
glm::dvec3 set_lum(const glm::dvec3& c, double l) {
    return clip_color(c + (l - lum(c)));
}
double sat(const glm::dvec3& c) {
    return std::max({c.r, c.g, c.b}) - std::min({c.r, c.g, c.b});
}
glm::dvec3 set_sat(glm::dvec3 c, double s) {
    std::array<int, 3> order = {0, 1, 2};
    std::sort(order.begin(), order.end(), [&](int a, int b) { return c[a] < c[b]; });
    double &low = c[order[0]], &mid = c[order[1]], &high = c[order[2]];
    if (high > low) {
        mid = (mid - low) * s / (high - low);
        high = s;
    } else {
        mid = high = 0;
    }
    low = 0;
    return c;
}

/// Smith's model with nothing at all where a grey gives its hue.
glm::dvec3 rgb_with_hue_of(const glm::dvec3& c, double saturation, double value) {
    return rgb_from_hsv(hsv_from_rgb(c).x, sat(c) > 0 ? saturation : 0, value);
}

}  // namespace

double published_blend(BlendMode mode, double cb, double cs) {
    switch (mode) {
        case BlendMode::Darken:
        case BlendMode::HeightMin:
            return std::min(cb, cs);
        case BlendMode::Multiply:
            return multiply(cb, cs);
        case BlendMode::ColorBurn:
            return color_burn(cb, cs);
        case BlendMode::LinearBurn:
            return held(cb + cs - 1);
        case BlendMode::Lighten:
        case BlendMode::HeightMax:
            return std::max(cb, cs);
        case BlendMode::Screen:
            return screen(cb, cs);
        case BlendMode::ColorDodge:
            return color_dodge(cb, cs);
        case BlendMode::Add:
            return held(cb + cs);
        case BlendMode::Overlay:
            return hard_light(cs, cb);
        case BlendMode::SoftLightW3c:
            return soft_light_w3c(cb, cs);
        case BlendMode::SoftLightPegtop:
            return (1 - 2 * cs) * cb * cb + 2 * cs * cb;
        case BlendMode::HardLight:
            return hard_light(cb, cs);
        case BlendMode::VividLight:
            return cs <= 0.5 ? color_burn(cb, 2 * cs) : color_dodge(cb, 2 * cs - 1);
        case BlendMode::LinearLight:
            return held(cb + 2 * cs - 1);
        case BlendMode::PinLight:
            return cs <= 0.5 ? std::min(cb, 2 * cs) : std::max(cb, 2 * cs - 1);
        case BlendMode::HardMix:
            return cb + cs >= 1 ? 1 : 0;
        case BlendMode::Difference:
            return std::abs(cb - cs);
        case BlendMode::Exclusion:
            return cb + cs - 2 * cb * cs;
        case BlendMode::Subtract:
            return held(cb - cs);
        case BlendMode::InverseSubtract:
            return held(cs - cb);
        case BlendMode::Divide:
            return divide(cb, cs);
        case BlendMode::InverseDivide:
            return divide(cs, cb);
        case BlendMode::SignedAdd:
            return held(cb + cs - 0.5);
        case BlendMode::Average:
            return (cb + cs) / 2;
        case BlendMode::HeightAdd:
            return cb + cs;
        case BlendMode::HeightSubtract:
            return cb - cs;
        default:
            return cs;
    }
}

glm::dvec3 published_blend(BlendMode mode, const glm::dvec3& cb, const glm::dvec3& cs) {
    switch (mode) {
        case BlendMode::HueW3c:
            return set_lum(set_sat(cs, sat(cb)), lum(cb));
        case BlendMode::SaturationW3c:
            return set_lum(set_sat(cb, sat(cs)), lum(cb));
        case BlendMode::ColorW3c:
            return set_lum(cs, lum(cb));
        case BlendMode::LuminosityW3c:
            return set_lum(cb, lum(cs));
        case BlendMode::TintHsv:
            return rgb_with_hue_of(cs, hsv_from_rgb(cb).y, hsv_from_rgb(cb).z);
        case BlendMode::SaturationHsv:
            return rgb_with_hue_of(cb, hsv_from_rgb(cs).y, hsv_from_rgb(cb).z);
        case BlendMode::ColorHsv:
            return rgb_with_hue_of(cs, hsv_from_rgb(cs).y, hsv_from_rgb(cb).z);
        case BlendMode::ValueHsv:
            return rgb_with_hue_of(cb, hsv_from_rgb(cb).y, hsv_from_rgb(cs).z);
        default: {
            glm::dvec3 result;
            for (int k = 0; k < 3; ++k) result[k] = published_blend(mode, cb[k], cs[k]);
            return result;
        }
    }
}

bool is_non_separable(BlendMode mode) {
    return info(mode).kinds == kColorOnly;
}

}  // namespace patina::test_support
