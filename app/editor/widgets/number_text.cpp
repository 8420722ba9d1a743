// SPDX-License-Identifier: MIT
#include "editor/widgets/number_text.h"

#include <fmt/format.h>

#include <cmath>

namespace patina::editor {

std::string number_text(double value, const NumberFormat& format) {
    const std::string digits = fmt::format("{:.{}f}", std::fabs(value), format.decimals);
    const bool is_zero = digits.find_first_not_of("0.") == std::string::npos;
    const std::string_view sign = is_zero                ? ""
                                  : value < 0.0          ? "\u2212"
                                  : format.always_signed ? "+"
                                                         : "";
    const std::string_view space = format.unit.empty() || format.unit == "\u00b0" ? "" : " ";
    return fmt::format("{}{}{}{}", sign, digits, space, format.unit);
}

std::string megabytes(std::uint64_t bytes, int decimals) {
    return number_text(static_cast<double>(bytes) / 1e6, {.decimals = decimals, .unit = "MB"});
}

std::string counted(std::size_t count, std::string_view singular) {
    return fmt::format("{} {}{}", count, singular, count == 1 ? "" : "s");
}

}  // namespace patina::editor
