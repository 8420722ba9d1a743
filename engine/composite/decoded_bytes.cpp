// SPDX-License-Identifier: MIT
#include "composite/decoded_bytes.h"

#include <array>
#include <cstddef>

#include "core/formulae/formulae.h"

namespace patina {

const float* decoded_bytes() {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> decoded{};
        for (std::size_t byte = 0; byte < decoded.size(); ++byte)
            decoded[byte] = formulae::linear_from_srgb(static_cast<float>(byte) * (1.0f / 255.0f));
        return decoded;
    }();
    return table.data();
}

}  // namespace patina
