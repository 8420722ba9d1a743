// SPDX-License-Identifier: MIT
#include "scene/sample_values.h"

#include "core/formulae/formulae.h"

namespace patina {

float linear_value(const Image& image, int x, int y, int channel) {
    if (image.type != SampleType::U8)
        return formulae::linear_from_srgb(stored_value(image, x, y, channel));
    const std::size_t index =
        static_cast<std::size_t>(x) * static_cast<std::size_t>(image.channels) +
        static_cast<std::size_t>(channel);
    const std::byte byte = image.data[image.row_bytes() * static_cast<std::size_t>(y) + index];
    return linear_of_bytes()[static_cast<std::size_t>(byte)];
}

}  // namespace patina
