// SPDX-License-Identifier: MIT
#include "composite/image_sampling.h"

#include <cmath>

#include "core/formulae/formulae.h"
#include "scene/sample_values.h"

namespace patina {
namespace {

/// A coordinate brought into 0..1, so that texel indices stay within one texel of the image.
float wrapped(float coordinate, Wrap wrap) {
    switch (wrap) {
        case Wrap::Repeat:
            return coordinate - std::floor(coordinate);
        case Wrap::Mirror: {
            const float twice = coordinate - 2.0f * std::floor(coordinate * 0.5f);
            return 1.0f - std::abs(1.0f - twice);
        }
        case Wrap::Clamp:
            return std::clamp(coordinate, 0.0f, 1.0f);
    }
    return coordinate;
}

/// A texel index from -1 to `side` brought inside.
int wrapped_index(int index, int side, Wrap wrap) {
    if (index >= 0 && index < side) return index;
    if (wrap == Wrap::Repeat) return index < 0 ? side - 1 : 0;
    return index < 0 ? 0 : side - 1;
}

/// The two texels of one axis that are filtered, and the weight of the second.
struct Taps {
    int first = 0;
    int second = 0;
    float second_weight = 0.0f;
};

Taps taps_at(float coordinate, int side, Wrap wrap, Filter filter) {
    const float place = wrapped(coordinate, wrap) * static_cast<float>(side);
    if (filter == Filter::Nearest) {
        const int index = wrapped_index(static_cast<int>(place), side, wrap);
        return {index, index, 0.0f};
    }
    const float from_center = place - 0.5f;
    const float lower = std::floor(from_center);
    const int index = static_cast<int>(lower);
    return {wrapped_index(index, side, wrap), wrapped_index(index + 1, side, wrap),
            from_center - lower};
}

float tap(const SamplingTask& task, int x, int y, int channel) {
    if (task.decode && !task.invert) return linear_value(*task.image, x, y, channel);
    float value = stored_value(*task.image, x, y, channel);
    if (task.invert) value = 1.0f - value;
    return task.decode ? formulae::linear_from_srgb(value) : value;
}

float filtered(const SamplingTask& task, const Taps& across, const Taps& down, int channel) {
    const float upper_left = tap(task, across.first, down.first, channel);
    if (across.second_weight == 0.0f && down.second_weight == 0.0f) return upper_left;
    const float upper = formulae::mix(upper_left, tap(task, across.second, down.first, channel),
                                      across.second_weight);
    const float lower =
        formulae::mix(tap(task, across.first, down.second, channel),
                      tap(task, across.second, down.second, channel), across.second_weight);
    return formulae::mix(upper, lower, down.second_weight);
}

}  // namespace

void sample_tile(const SamplingTask& task, const TileSpan& span) {
    const auto& source = std::get<ImageSource>(task.record->source);
    const glm::vec3& to_u = task.record->to_u;
    const glm::vec3& to_v = task.record->to_v;
    const float side = static_cast<float>(span.size);
    const float v = (static_cast<float>(span.y) + 0.5f) / side;
    for (int i = 0; i < span.count; ++i) {
        const float u = (static_cast<float>(span.x + i) + 0.5f) / side;
        const bool given = task.at.u != nullptr;
        const float right = given ? task.at.u[i] : to_u.x * u + to_u.y * v + to_u.z;
        const float below = given ? task.at.v[i] : to_v.x * u + to_v.y * v + to_v.z;
        const Taps across = taps_at(right, task.image->width, source.wrap_u, source.filter);
        const Taps down = taps_at(below, task.image->height, source.wrap_v, source.filter);
        for (int k = 0; k < task.components.count; ++k)
            task.planes[k][i] = filtered(task, across, down, task.components.index[k]);
    }
}

}  // namespace patina
