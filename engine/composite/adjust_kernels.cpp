// SPDX-License-Identifier: MIT
#include "composite/adjust_kernels.h"

#include "composite/curve_slopes.h"
#include "composite/kernel_targets.h"
#include "composite/uniform_values.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "composite/adjust_kernels.cpp"
#include <hwy/foreach_target.h>

#include "composite/plane_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace patina::HWY_NAMESPACE {
namespace {

formulae::Curve curve_of(const AdjustNumbers& numbers) {
    formulae::Curve curve = {};
    curve.count = numbers.curve_count;
    for (int i = 0; i < numbers.curve_count; ++i)
        curve.points[i] = {numbers.curve[i][0], numbers.curve[i][1], numbers.curve[i][2]};
    return curve;
}

formulae::Ramp gradient_of(const AdjustNumbers& numbers) {
    formulae::Ramp ramp = {};
    ramp.count = numbers.stop_count;
    for (int i = 0; i < numbers.stop_count; ++i) {
        const float* const stop = numbers.stops[i];
        ramp.stops[i] = {stop[0], stop[1], stop[2], stop[3]};
    }
    return ramp;
}

/// The loop over planes that are changed one by one.
template <class Change>
HWY_INLINE void each_value(const float* const* from, float* const* to, int planes, int count,
                           bool height, const Change& change) {
    for (int k = 0; k < planes; ++k)
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); i += lane_count()) {
            Real value = load(from[k] + i);
            if (height) value = clamp(formulae::encoded_from_signed(value), 0.0f, 1.0f);
            value = change(value);
            if (height) value = formulae::signed_from_encoded(value);
            store(value, to[k] + i);
        }
}

HWY_NOINLINE HWY_FLATTEN void adjust_levels(const AdjustNumbers& n, const float* const* from,
                                            float* const* to, int planes, int count, bool height) {
    each_value(from, to, planes, count, height, [&](Real x) {
        return formulae::levels(x, n.levels.in_low, n.levels.in_high, n.levels.gamma,
                                n.levels.out_low, n.levels.out_high);
    });
}

HWY_NOINLINE HWY_FLATTEN void adjust_curve(const AdjustNumbers& n, const float* const* from,
                                           float* const* to, int planes, int count, bool height) {
    const formulae::Curve curve = curve_of(n);
    each_value(from, to, planes, count, height,
               [&](Real x) { return formulae::curve_value(curve, x); });
}

HWY_NOINLINE HWY_FLATTEN void adjust_simply(const AdjustNumbers& n, const float* const* from,
                                            float* const* to, int planes, int count, bool height) {
    each_value(from, to, planes, count, height, [&](Real x) {
        if (n.kind == AdjustmentKind::Invert) return formulae::inverted(x);
        if (n.kind == AdjustmentKind::Posterise) return formulae::posterised(x, n.steps);
        if (n.kind == AdjustmentKind::Clamp) return clamp(x, n.low, n.high);
        return formulae::brightened(x, n.brightness, n.contrast);
    });
}

HWY_NOINLINE HWY_FLATTEN void adjust_hue(const AdjustNumbers& n, const float* const* from,
                                         float* const* to, int count) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); i += lane_count()) {
        const Real3 color = load(from, i);
        store(formulae::hue_saturation(color, n.hue_sixths, n.saturation, n.lightness), to, i);
    }
}

HWY_NOINLINE HWY_FLATTEN void map_colors(const AdjustNumbers& n, const float* const* from,
                                         float* const* to, int count) {
    const formulae::Ramp ramp = gradient_of(n);
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); i += lane_count()) {
        const Real3 color = load(from, i);
        store(formulae::ramp_color(ramp, formulae::luminance(color)), to, i);
    }
}

HWY_NOINLINE HWY_FLATTEN void map_values(const AdjustNumbers& n, const float* const* from,
                                         float* const* to, int count, bool height) {
    const formulae::Ramp ramp = gradient_of(n);
    each_value(from, to, 1, count, height, [&](Real x) { return formulae::ramp_scalar(ramp, x); });
}

/// A single number has no hue: its lightness alone is changed.
HWY_NOINLINE HWY_FLATTEN void adjust_lightness(const AdjustNumbers& n, const float* const* from,
                                               float* const* to, int count, bool height) {
    each_value(from, to, 1, count, height, [&](Real x) {
        return formulae::hue_saturation(Real3(x), 0.0f, 0.0f, n.lightness).x;
    });
}

void adjust_by_kind(const AdjustNumbers& n, const float* const* from, float* const* to, int planes,
                    int count, bool height) {
    switch (n.kind) {
        case AdjustmentKind::Levels:
            return adjust_levels(n, from, to, planes, count, height);
        case AdjustmentKind::Curves:
            return adjust_curve(n, from, to, planes, count, height);
        case AdjustmentKind::HueSaturation:
            return planes == 3 ? adjust_hue(n, from, to, count)
                               : adjust_lightness(n, from, to, count, height);
        case AdjustmentKind::GradientMap:
            return planes == 3 ? map_colors(n, from, to, count)
                               : map_values(n, from, to, count, height);
        case AdjustmentKind::BrightnessContrast:
        case AdjustmentKind::Invert:
        case AdjustmentKind::Posterise:
        case AdjustmentKind::Clamp:
            return adjust_simply(n, from, to, planes, count, height);
        case AdjustmentKind::Blur:
        case AdjustmentKind::Sharpen:
        case AdjustmentKind::Warp:
            return;  // composite/around.h
    }
}

}  // namespace

}  // namespace patina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace patina {
namespace {

AdjustNumbers numbers_of(const AdjustTask& task) {
    const AdjustmentSettings& from = *task.adjustment;
    AdjustNumbers numbers{.kind = from.kind, .levels = from.levels};
    numbers.curve_count = static_cast<int>(from.curve.size());
    const std::vector<float> slopes = curve_slopes(from.curve);
    for (std::size_t i = 0; i < from.curve.size(); ++i) {
        numbers.curve[i][0] = from.curve[i].x;
        numbers.curve[i][1] = from.curve[i].y;
        numbers.curve[i][2] = slopes[i];
    }
    numbers.hue_sixths = from.hue_degrees / 60.0f;
    if (numbers.hue_sixths < 0.0f) numbers.hue_sixths += 6.0f;
    numbers.saturation = from.saturation;
    numbers.lightness = from.lightness;
    numbers.brightness = from.brightness;
    numbers.contrast = from.contrast;
    numbers.steps = static_cast<float>(from.steps);
    numbers.stop_count = static_cast<int>(from.gradient.size());
    for (std::size_t i = 0; i < from.gradient.size(); ++i) {
        const glm::vec3& value = from.gradient[i].value;
        const glm::vec3 color = task.encoded ? encoded_color(value) : value;
        numbers.stops[i][0] = from.gradient[i].position;
        for (int k = 0; k < 3; ++k) numbers.stops[i][k + 1] = color[k];
    }
    numbers.low = from.low;
    numbers.high = from.high;
    return numbers;
}

}  // namespace

HWY_EXPORT(adjust_by_kind);

void run_adjustment(const AdjustTask& task) {
    const AdjustNumbers numbers = numbers_of(task);
    const bool height = info(task.channel).kind == ChannelKind::Height;
    HWY_DYNAMIC_DISPATCH(adjust_by_kind)
    (numbers, task.from, task.to, component_count(task.channel), task.count, height);
}

}  // namespace patina
#endif
