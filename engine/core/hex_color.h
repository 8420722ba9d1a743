// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace patina {

/// Red, green and blue of what stands after '#' in HTML: six hexadecimal digits, or three, each of
/// which counts twice. Nothing for any other text.
std::optional<std::array<std::uint8_t, 3>> rgb_from_hex(std::string_view digits);

/// Of "#8a3b12", all seven characters; nothing for any other text.
std::optional<std::array<std::uint8_t, 3>> rgb_from_html(std::string_view text);

}  // namespace patina
