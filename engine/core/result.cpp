// SPDX-License-Identifier: MIT
#include "core/result.h"

#include <cstdint>

namespace patina {
namespace {

/// Length of the well-formed UTF-8 sequence that starts at `at`, or 0 (Unicode 15, table 3-7).
std::size_t utf8_sequence_length(std::string_view text, std::size_t at) {
    const auto byte = [&](std::size_t i) {
        return at + i < text.size() ? static_cast<std::uint8_t>(text[at + i]) : std::uint8_t{0};
    };
    const auto continues = [&](std::size_t i) { return (byte(i) & 0xC0) == 0x80; };
    const std::uint8_t lead = byte(0);
    if (lead < 0x80) return 1;
    if (lead >= 0xC2 && lead <= 0xDF) return continues(1) ? 2 : 0;
    if (lead >= 0xE0 && lead <= 0xEF) {
        if (!continues(1) || !continues(2)) return 0;
        if (lead == 0xE0 && byte(1) < 0xA0) return 0;
        if (lead == 0xED && byte(1) > 0x9F) return 0;
        return 3;
    }
    if (lead >= 0xF0 && lead <= 0xF4) {
        if (!continues(1) || !continues(2) || !continues(3)) return 0;
        if (lead == 0xF0 && byte(1) < 0x90) return 0;
        if (lead == 0xF4 && byte(1) > 0x8F) return 0;
        return 4;
    }
    return 0;
}

bool is_c1_control(std::string_view sequence) {
    return sequence.size() == 2 && sequence[0] == '\xC2' &&
           static_cast<std::uint8_t>(sequence[1]) < 0xA0;
}

}  // namespace

std::string quoted_for_message(std::string_view text, std::size_t limit_bytes) {
    std::string quoted;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = utf8_sequence_length(text, at);
        const std::string_view sequence = text.substr(at, length == 0 ? 1 : length);
        const auto first = static_cast<std::uint8_t>(sequence.front());
        const bool printable =
            length != 0 && first >= 0x20 && first != 0x7F && !is_c1_control(sequence);
        const std::string piece =
            printable ? std::string(sequence) : fmt::format("\\x{:02x}", first);
        if (quoted.size() + piece.size() > limit_bytes) return quoted + "…";
        quoted += piece;
        at += printable ? sequence.size() : 1;
    }
    return quoted;
}

}  // namespace patina
