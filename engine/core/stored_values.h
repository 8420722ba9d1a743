// SPDX-License-Identifier: MIT
#pragma once

/// What integers stand for that are stored in images.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

namespace patina {

/// 0..1 of a stored number. 0 and 1 are exact.
constexpr float unit_value(std::uint8_t stored) {
    return static_cast<float>(stored) * (1.0f / 255.0f);
}
constexpr float unit_value(std::uint16_t stored) {
    return static_cast<float>(stored) * (1.0f / 65535.0f);
}

/// The linear light of each of the 256 sRGB-encoded bytes.
const std::array<float, 256>& linear_of_bytes();
/// The linear light of an sRGB-encoded red, green and blue, 0..1.
glm::vec3 linear_of_rgb(const std::array<std::uint8_t, 3>& rgb);

}  // namespace patina
