// SPDX-License-Identifier: MIT
#include "core/hex_color.h"

#include <charconv>

namespace patina {

std::optional<std::array<std::uint8_t, 3>> rgb_from_hex(std::string_view digits) {
    if (digits.size() != 3 && digits.size() != 6) return std::nullopt;
    const std::size_t each = digits.size() / 3;
    std::array<std::uint8_t, 3> rgb = {};
    for (std::size_t i = 0; i < rgb.size(); ++i) {
        const char* const first = digits.data() + i * each;
        unsigned value = 0;
        const auto [end, error] = std::from_chars(first, first + each, value, 16);
        if (error != std::errc() || end != first + each) return std::nullopt;
        rgb[i] = static_cast<std::uint8_t>(each == 1 ? 17 * value : value);
    }
    return rgb;
}

std::optional<std::array<std::uint8_t, 3>> rgb_from_html(std::string_view text) {
    if (text.size() != 7 || text[0] != '#') return std::nullopt;
    return rgb_from_hex(text.substr(1));
}

}  // namespace patina
