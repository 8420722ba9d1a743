// SPDX-License-Identifier: MIT
#pragma once

/// JSON edited in place: the text with some values changed, added or removed, and every other byte
/// as it was.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/json.h"
#include "core/result.h"
#include "io/json_spans.h"

namespace patina::io {

/// What the value at a place is to be. Only what differs from the present value is touched: deeper
/// members and elements that are equal keep their bytes, and so does everything around them.
struct JsonChange {
    /// A JSON pointer. Its parent exists; the last step may name a new member, or the index one
    /// past the end of an array.
    std::string pointer;
    std::optional<Json> value;  ///< unset: the member, or the array's last element, is removed
};

/// Applies changes of places that do not contain each other. New text is laid out like the text
/// around it: on lines of their own with the same indentation, or compactly.
Result<std::string> spliced(const JsonSpans& spans, const std::vector<JsonChange>& changes);

/// The value at `pointer`, parsed; a null value where there is none.
Json parsed_at(const JsonSpans& spans, std::string_view pointer);

/// The number that prints as shortly as `value` does as a float: 0.1f gives 0.1, not
/// 0.10000000149011612.
Json json_number(float value);

}  // namespace patina::io
