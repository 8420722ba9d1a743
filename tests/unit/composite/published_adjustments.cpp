// SPDX-License-Identifier: MIT
#include "composite/published_adjustments.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "shaders/published_hsv.h"

namespace patina::test_support {
namespace {

double encoded(double x) {
    return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
}

/// Fritsch and Butland's slopes and Hermite's basis, as the papers have them.
double curve_at(const std::vector<CurvePoint>& points, double x) {
    const auto px = [&](std::size_t i) { return static_cast<double>(points[i].x); };
    const auto py = [&](std::size_t i) { return static_cast<double>(points[i].y); };
    const std::size_t last = points.size() - 1;
    if (x <= px(0)) return py(0);
    if (x >= px(last)) return py(last);
    const auto chord = [&](std::size_t i) { return (py(i + 1) - py(i)) / (px(i + 1) - px(i)); };
    const auto slope = [&](std::size_t i) {
        if (i == 0) return chord(0);
        if (i == last) return chord(last - 1);
        const double a = chord(i - 1), b = chord(i);
        if (a * b <= 0) return 0.0;
        const double ha = px(i) - px(i - 1), hb = px(i + 1) - px(i);
        return 3 * (ha + hb) / ((2 * hb + ha) / a + (hb + 2 * ha) / b);
    };
    std::size_t i = 0;
    while (x > px(i + 1)) ++i;
    const double h = px(i + 1) - px(i), t = (x - px(i)) / h;
    const double value =
        (2 * t * t * t - 3 * t * t + 1) * py(i) + (t * t * t - 2 * t * t + t) * h * slope(i) +
        (3 * t * t - 2 * t * t * t) * py(i + 1) + (t * t * t - t * t) * h * slope(i + 1);
    return std::clamp(value, 0.0, 1.0);
}

/// The hue turned, the saturation scaled about the middle between the least and the greatest
/// component, then towards white or black.
glm::dvec3 hue_saturation(const AdjustmentSettings& a, const glm::dvec3& c) {
    const glm::dvec3 h = hsv_from_rgb(c);
    const double saturation = std::clamp(h.y * (1 + static_cast<double>(a.saturation)), 0.0, 1.0);
    glm::dvec3 out = rgb_from_hsv(h.x + static_cast<double>(a.hue_degrees) / 60, saturation, h.z);
    const auto middle = [](const glm::dvec3& v) {
        return (std::max({v.r, v.g, v.b}) + std::min({v.r, v.g, v.b})) / 2;
    };
    out = glm::clamp(out + (middle(c) - middle(out)), 0.0, 1.0);
    const double light = static_cast<double>(a.lightness);
    return light >= 0 ? glm::mix(out, glm::dvec3(1), light) : out * (1 + light);
}

double contrasted(const AdjustmentSettings& a, double x) {
    const double moved = std::clamp(x + static_cast<double>(a.brightness), 0.0, 1.0);
    const double contrast = static_cast<double>(a.contrast);
    const double slope = contrast < 0 ? 1 + contrast : 1 / std::max(1 - contrast, 1e-4);
    return std::clamp((moved - 0.5) * slope + 0.5, 0.0, 1.0);
}

glm::dvec3 gradient_at(const AdjustmentSettings& a, double x, bool is_encoded) {
    const auto color = [&](std::size_t i) {
        const glm::dvec3 value(a.gradient[i].value);
        return is_encoded ? glm::dvec3(encoded(value.r), encoded(value.g), encoded(value.b))
                          : value;
    };
    glm::dvec3 value = color(0);
    for (std::size_t i = 1; i < a.gradient.size(); ++i) {
        const double from = static_cast<double>(a.gradient[i - 1].position);
        const double width = static_cast<double>(a.gradient[i].position) - from;
        if (x >= from)
            value = glm::mix(value, color(i),
                             width > 0 ? std::clamp((x - from) / width, 0.0, 1.0) : 1.0);
    }
    return value;
}

glm::dvec3 adjusted_unit(const AdjustmentSettings& a, bool is_color, const glm::dvec3& value,
                         bool is_encoded) {
    const auto each = [&](const std::function<double(double)>& change) {
        return glm::dvec3(change(value.x), change(value.y), change(value.z));
    };
    switch (a.kind) {
        case AdjustmentKind::Levels:
            return each([&](double x) { return leveled(a.levels, x); });
        case AdjustmentKind::Curves:
            return each([&](double x) { return curve_at(a.curve, x); });
        case AdjustmentKind::HueSaturation: {
            AdjustmentSettings own = a;
            if (!is_color) own.hue_degrees = own.saturation = 0;
            return hue_saturation(own, is_color ? value : glm::dvec3(value.x));
        }
        case AdjustmentKind::BrightnessContrast:
            return each([&](double x) { return contrasted(a, x); });
        case AdjustmentKind::Invert:
            return 1.0 - value;
        case AdjustmentKind::Posterise:
            return each([&](double x) {
                return std::min(std::floor(x * a.steps), a.steps - 1.0) / (a.steps - 1);
            });
        case AdjustmentKind::GradientMap: {
            const double luminance = 0.2126 * value.x + 0.7152 * value.y + 0.0722 * value.z;
            return gradient_at(a, is_color ? luminance : value.x, is_encoded);
        }
        case AdjustmentKind::Clamp:
            return glm::clamp(value, static_cast<double>(a.low), static_cast<double>(a.high));
        case AdjustmentKind::Blur:
        case AdjustmentKind::Sharpen:
        case AdjustmentKind::Warp:
            break;  // not of one texel: around_test.cpp
    }
    return value;
}

}  // namespace

double leveled(const Levels& levels, double x) {
    const double width = static_cast<double>(levels.in_high) - static_cast<double>(levels.in_low);
    const double t = std::clamp((x - static_cast<double>(levels.in_low)) / width, 0.0, 1.0);
    return glm::mix(static_cast<double>(levels.out_low), static_cast<double>(levels.out_high),
                    std::pow(t, 1.0 / static_cast<double>(levels.gamma)));
}

glm::dvec3 adjusted(const AdjustmentSettings& adjustment, Channel channel, const glm::dvec3& value,
                    bool gradient_encoded) {
    const ChannelKind kind = info(channel).kind;
    if (kind == ChannelKind::Height)
        return adjusted_unit(adjustment, false, glm::clamp(value * 0.5 + 0.5, 0.0, 1.0), false) *
                   2.0 -
               1.0;
    return adjusted_unit(adjustment, kind == ChannelKind::Color, value, gradient_encoded);
}

}  // namespace patina::test_support
