// SPDX-License-Identifier: MIT
#include "composite/decoded_bytes.h"

#include <bit>

#include "core/formulae/formulae.h"

namespace patina {

const DecodedBytes& decoded_bytes() {
    static const DecodedBytes table = [] {
        DecodedBytes decoded{};
        for (std::size_t byte = 0; byte < decoded.values.size(); ++byte) {
            const float value =
                formulae::linear_from_srgb(static_cast<float>(byte) * (1.0f / 255.0f));
            const auto bits = std::bit_cast<std::uint32_t>(value);
            decoded.values[byte] = value;
            decoded.low_halves[byte] = static_cast<std::uint16_t>(bits & 0xffffu);
            decoded.high_halves[byte] = static_cast<std::uint16_t>(bits >> 16);
        }
        return decoded;
    }();
    return table;
}

}  // namespace patina
