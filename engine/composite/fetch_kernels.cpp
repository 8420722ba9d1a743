// SPDX-License-Identifier: MIT
#include "composite/fetch_kernels.h"

#include "composite/kernel_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "composite/fetch_kernels.cpp"
#include <hwy/foreach_target.h>

#include "composite/texel_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace patina::HWY_NAMESPACE {
namespace {

/// kComponents of each texel, from component kFirst on.
template <typename Sample, int kChannels, int kFirst, int kComponents, class Value>
HWY_NOINLINE HWY_FLATTEN void read_run(const ReadTask& task) {
    const TexelReader<Sample, kChannels, kFirst, kComponents, Value> reader(
        task.texels, task.row_bytes, task.count);
    for (std::size_t i = 0; i < static_cast<std::size_t>(task.count); i += lane_count()) {
        Real values[kComponents];
        reader.load(i, values);
        for (int k = 0; k < kComponents; ++k) store(values[k], task.planes[k] + i);
    }
}

template <typename Sample, int kChannels, class Value>
void read_component(const ReadTask& task, int index) {
    if constexpr (kChannels > 3)
        if (index == 3) return read_run<Sample, kChannels, 3, 1, Value>(task);
    if constexpr (kChannels > 2)
        if (index == 2) return read_run<Sample, kChannels, 2, 1, Value>(task);
    if constexpr (kChannels > 1)
        if (index == 1) return read_run<Sample, kChannels, 1, 1, Value>(task);
    read_run<Sample, kChannels, 0, 1, Value>(task);
}

template <typename Sample, class Value>
void read_samples(const ReadTask& task) {
    const int index = task.components.index[0];
    switch (task.channels) {
        case 1:
            return read_component<Sample, 1, Value>(task, index);
        case 2:
            return read_component<Sample, 2, Value>(task, index);
        case 3:
            return task.components.count == 3 ? read_run<Sample, 3, 0, 3, Value>(task)
                                              : read_component<Sample, 3, Value>(task, index);
        default:
            return task.components.count == 3 ? read_run<Sample, 4, 0, 3, Value>(task)
                                              : read_component<Sample, 4, Value>(task, index);
    }
}

void read_by_type(const ReadTask& task) {
    switch (task.type) {
        case SampleType::U8:
            return task.decode ? read_samples<std::uint8_t, Decoded>(task)
                               : read_samples<std::uint8_t, AsStored>(task);
        case SampleType::U16:
            return read_samples<std::uint16_t, AsStored>(task);
        case SampleType::F32:
            return read_samples<float, AsStored>(task);
    }
}

/// The steps that each component takes by itself.
HWY_INLINE Real adjusted(const Adjustment& adjustment, Real value, int k) {
    if (adjustment.invert) value = 1.0f - value;
    if (adjustment.decode) value = formulae::linear_from_srgb(value);
    if (adjustment.unpack) value = formulae::signed_from_encoded(value);
    if (adjustment.flip_y && k == 1) value = -value;
    if (adjustment.scale) value = value * adjustment.multiply[k] + adjustment.add[k];
    return value;
}

HWY_NOINLINE HWY_FLATTEN void adjust_one(const Adjustment& adjustment, float* plane, int count) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); i += lane_count()) {
        Real value = adjusted(adjustment, load(plane + i), 0);
        if (adjustment.hold) value = clamp(value, 0.0f, 1.0f);
        if (adjustment.encode) value = formulae::srgb_from_linear(value);
        store(value, plane + i);
    }
}

HWY_NOINLINE HWY_FLATTEN void adjust_three(const Adjustment& adjustment, float* const* planes,
                                           int count) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); i += lane_count()) {
        Real3 value(adjusted(adjustment, load(planes[0] + i), 0),
                    adjusted(adjustment, load(planes[1] + i), 1),
                    adjusted(adjustment, load(planes[2] + i), 2));
        if (adjustment.normalise) value = formulae::unit_normal(value);
        if (adjustment.luminance) {
            Real grey = formulae::luminance(value);
            if (adjustment.hold) grey = clamp(grey, 0.0f, 1.0f);
            store(grey, planes[0] + i);
            continue;
        }
        if (adjustment.hold) value = clamp(value, 0.0f, 1.0f);
        if (adjustment.encode) value = formulae::srgb_from_linear(value);
        store(value, planes, i);
    }
}

void adjust(const Adjustment& adjustment, int components, float* const* planes, int count) {
    if (components == 3)
        adjust_three(adjustment, planes, count);
    else
        adjust_one(adjustment, planes[0], count);
}

}  // namespace

}  // namespace patina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace patina {

HWY_EXPORT(read_by_type);
HWY_EXPORT(adjust);

Components picked_components(ChannelPick pick, int channels) {
    const bool grey = channels <= 2;
    switch (pick) {
        case ChannelPick::Rgb:
            if (grey) return {.count = 1, .index = {0, 0, 0}};
            return {.count = 3, .index = {0, 1, 2}};
        case ChannelPick::Red:
            return {.index = {0}};
        case ChannelPick::Green:
            return {.index = {grey ? 0 : 1}};
        case ChannelPick::Blue:
            return {.index = {grey ? 0 : 2}};
        case ChannelPick::Alpha:
            return {.index = {channels == 2 ? 1 : channels == 4 ? 3 : -1}};
    }
    return {};
}

void read_tile(const ReadTask& task) {
    HWY_DYNAMIC_DISPATCH(read_by_type)(task);
}

void adjust_tile(const Adjustment& adjustment, int components, float* const planes[3], int count) {
    HWY_DYNAMIC_DISPATCH(adjust)(adjustment, components, planes, count);
}

}  // namespace patina
#endif
