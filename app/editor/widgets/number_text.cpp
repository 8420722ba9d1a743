// SPDX-License-Identifier: MIT
#include "editor/widgets/number_text.h"

#include <fmt/format.h>

#include <cmath>

namespace patina::editor {

std::string number_text(double value, const NumberFormat& format) {
    std::string digits = fmt::format("{:.{}f}", std::fabs(value), format.decimals);
    const bool is_zero = digits.find_first_not_of("0.") == std::string::npos;
    if (value < 0.0 && !is_zero)
        digits.insert(0, "\u2212");
    else if (format.always_signed && !is_zero)
        digits.insert(0, "+");
    if (!format.unit.empty()) {
        if (format.unit != "\u00b0") digits += ' ';
        digits += format.unit;
    }
    return digits;
}

std::string megabytes(std::uint64_t bytes, int decimals) {
    return number_text(static_cast<double>(bytes) / 1e6, {.decimals = decimals, .unit = "MB"});
}

std::string counted(std::size_t count, std::string_view singular) {
    return fmt::format("{} {}{}", count, singular, count == 1 ? "" : "s");
}

}  // namespace patina::editor
