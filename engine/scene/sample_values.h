// SPDX-License-Identifier: MIT
#pragma once

/// Reading and writing single stored numbers of an image, whatever their type.

#include <algorithm>
#include <cstring>

#include "core/stored_values.h"
#include "scene/image.h"

namespace patina {

/// Component `channel` of texel (x, y): 0..1 for integers, as stored for floats.
inline float stored_value(const Image& image, int x, int y, int channel) {
    const std::size_t index =
        static_cast<std::size_t>(x) * static_cast<std::size_t>(image.channels) +
        static_cast<std::size_t>(channel);
    const std::byte* const row =
        image.data.data() + image.row_bytes() * static_cast<std::size_t>(y);
    switch (image.type) {
        case SampleType::U8:
            return unit_value(static_cast<std::uint8_t>(row[index]));
        case SampleType::U16: {
            std::uint16_t value = 0;
            std::memcpy(&value, row + 2 * index, sizeof value);
            return unit_value(value);
        }
        case SampleType::F32: {
            float value = 0.0f;
            std::memcpy(&value, row + 4 * index, sizeof value);
            return value;
        }
    }
    return 0.0f;
}

/// The linear light, 0..1, of a component that is sRGB-encoded.
float linear_value(const Image& image, int x, int y, int channel);

/// Integers are rounded to the nearest that is stored.
inline void store_value(Image& image, int x, int y, int channel, float value) {
    const std::size_t index =
        static_cast<std::size_t>(x) * static_cast<std::size_t>(image.channels) +
        static_cast<std::size_t>(channel);
    std::byte* const row = image.data.data() + image.row_bytes() * static_cast<std::size_t>(y);
    const float unit = std::clamp(value, 0.0f, 1.0f);
    switch (image.type) {
        case SampleType::U8:
            row[index] = static_cast<std::byte>(static_cast<std::uint8_t>(unit * 255.0f + 0.5f));
            return;
        case SampleType::U16: {
            const auto rounded = static_cast<std::uint16_t>(unit * 65535.0f + 0.5f);
            std::memcpy(row + 2 * index, &rounded, sizeof rounded);
            return;
        }
        case SampleType::F32:
            std::memcpy(row + 4 * index, &value, sizeof value);
            return;
    }
}

}  // namespace patina
