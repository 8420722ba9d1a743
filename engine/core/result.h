// SPDX-License-Identifier: MIT
#pragma once

/// Errors as values. What may fail for reasons outside the program returns Result<T>; the message
/// is one line that says what, where (file and place), why, and what to do. Exceptions never cross
/// a public function of the engine; `assert` is for what cannot happen, never for what a file says.

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>

namespace patina {

/// One line of plain text, without a full stop or line break at the end.
struct Error {
    std::string message;
    bool operator==(const Error&) const = default;
};

template <typename T>
using Result = tl::expected<T, Error>;

/// The outcome of something that has no value to give back.
using Status = Result<void>;

/// Makes the failed Result of a fmt format string: `return failure("{}: no such file", path);`
template <typename... Args>
[[nodiscard]] tl::unexpected<Error> failure(fmt::format_string<Args...> format, Args&&... args) {
    return tl::unexpected<Error>(Error{fmt::format(format, std::forward<Args>(args)...)});
}

/// Passes on the error of a failed Result of another type: `if (!image) return passed_on(image);`
template <typename T>
[[nodiscard]] tl::unexpected<Error> passed_on(const Result<T>& failed) {
    return tl::unexpected<Error>(failed.error());
}

/// `text` fit for a one-line message: control characters and broken UTF-8 become escapes such as
/// \x1b, and what lies beyond `limit_bytes` is cut with an ellipsis. Use it for all text that comes
/// from a file, so that no model can write terminal sequences or fill a screen.
std::string quoted_for_message(std::string_view text, std::size_t limit_bytes = 300);

}  // namespace patina
