// SPDX-License-Identifier: MIT
#include "core/stored_values.h"

#include "core/formulae/formulae.h"

namespace patina {

const std::array<float, 256>& linear_of_bytes() {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> made = {};
        for (std::size_t byte = 0; byte < made.size(); ++byte)
            made[byte] = formulae::linear_from_srgb(unit_value(static_cast<std::uint8_t>(byte)));
        return made;
    }();
    return table;
}

glm::vec3 linear_of_rgb(const std::array<std::uint8_t, 3>& rgb) {
    const std::array<float, 256>& linear = linear_of_bytes();
    return {linear[rgb[0]], linear[rgb[1]], linear[rgb[2]]};
}

}  // namespace patina
