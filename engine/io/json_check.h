// SPDX-License-Identifier: MIT
#pragma once

/// JSON text from strangers, parsed once and strictly before anything else looks at it.

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string_view>

#include "core/result.h"

namespace patina::io {

struct JsonLimits {
    int depth = 64;                                       ///< nested arrays and objects
    std::uint64_t memory_bytes = std::uint64_t{1} << 30;  ///< of the parsed values
};

/// Parses one JSON value without recursion. Refused, with a line that says where: broken UTF-8,
/// bytes after the value, a key twice in one object (readers disagree on which counts), numbers
/// that no double holds, and what goes beyond `limits`, before memory is taken for it. The message
/// does not name the file.
Result<nlohmann::json> parse_json(std::string_view text, const JsonLimits& limits = {});

}  // namespace patina::io
