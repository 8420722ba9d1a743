// SPDX-License-Identifier: MIT
#pragma once

/// The sums that can be typed into a number field.

#include <optional>
#include <string_view>

namespace patina::editor {

/// The value of a sum of decimal numbers, + - * / and parentheses, such as "2048/3" or "-(1+2)*3".
/// A comma counts as a decimal point, a true minus as a minus; one unit (letters, %, degrees) may
/// follow. Nothing for what is not such a sum or has no finite value.
std::optional<double> value_of_sum(std::string_view text);

}  // namespace patina::editor
