// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

namespace patina {

/// The linear light of each of the 256 sRGB-encoded bytes.
struct DecodedBytes {
    alignas(64) std::array<float, 256> values;
    /// The lower and the upper 16 bits of each value.
    alignas(64) std::array<std::uint16_t, 256> low_halves;
    alignas(64) std::array<std::uint16_t, 256> high_halves;
};
const DecodedBytes& decoded_bytes();

}  // namespace patina
