// SPDX-License-Identifier: MIT
#pragma once

/// Numbers as the interface writes them: fixed decimals, a true minus, the unit after a space
/// (degrees without one).

#include <cstdint>
#include <string>
#include <string_view>

namespace patina::editor {

struct NumberFormat {
    int decimals = 2;
    std::string_view unit = {};
    bool always_signed = false;  ///< EV
};

std::string number_text(double value, const NumberFormat& format = {});
/// "48.9 MB" with one decimal, "612 MB" with none.
std::string megabytes(std::uint64_t bytes, int decimals = 0);
/// "1 layer", "9 layers".
std::string counted(std::size_t count, std::string_view singular);

}  // namespace patina::editor
