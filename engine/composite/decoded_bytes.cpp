// SPDX-License-Identifier: MIT
#include "composite/decoded_bytes.h"

#include <bit>

#include "core/stored_values.h"

namespace patina {

const DecodedBytes& decoded_bytes() {
    static const DecodedBytes table = [] {
        DecodedBytes decoded{};
        decoded.values = linear_of_bytes();
        for (std::size_t byte = 0; byte < decoded.values.size(); ++byte) {
            const auto bits = std::bit_cast<std::uint32_t>(decoded.values[byte]);
            decoded.low_halves[byte] = static_cast<std::uint16_t>(bits & 0xffffu);
            decoded.high_halves[byte] = static_cast<std::uint16_t>(bits >> 16);
        }
        return decoded;
    }();
    return table;
}

}  // namespace patina
