// SPDX-License-Identifier: MIT
#include "core/hash.h"

#define XXH_INLINE_ALL
#include <fmt/format.h>
#include <xxhash.h>

#include <charconv>

namespace patina {
namespace {

Hash128 from_xxhash(const XXH128_hash_t& hash) {
    return {.high = hash.high64, .low = hash.low64};
}

std::optional<std::uint64_t> parse_hex64(std::string_view digits) {
    for (const char c : digits) {
        const bool lower_hex = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
        if (!lower_hex) return std::nullopt;
    }
    std::uint64_t value = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
    return value;
}

}  // namespace

std::string to_hex(const Hash128& hash) {
    return fmt::format("{:016x}{:016x}", hash.high, hash.low);
}

std::optional<Hash128> hash_from_hex(std::string_view text) {
    if (text.size() != 32) return std::nullopt;
    const auto high = parse_hex64(text.substr(0, 16));
    const auto low = parse_hex64(text.substr(16));
    if (!high || !low) return std::nullopt;
    return Hash128{.high = *high, .low = *low};
}

Hash128 hash_bytes(std::span<const std::byte> bytes) {
    return from_xxhash(XXH3_128bits(bytes.data(), bytes.size()));
}

Hash128 hash_text(std::string_view text) {
    return from_xxhash(XXH3_128bits(text.data(), text.size()));
}

struct Hasher::State {
    XXH3_state_t xxh3;
};

Hasher::Hasher() : state_(std::make_unique<State>()) {
    XXH3_128bits_reset(&state_->xxh3);
}
Hasher::~Hasher() = default;

Hasher& Hasher::add_raw(const void* data, std::size_t size_bytes) {
    XXH3_128bits_update(&state_->xxh3, data, size_bytes);
    return *this;
}

Hasher& Hasher::add(std::string_view text) {
    add(static_cast<std::uint64_t>(text.size()));
    return add_raw(text.data(), text.size());
}

Hasher& Hasher::add_bytes(std::span<const std::byte> bytes) {
    add(static_cast<std::uint64_t>(bytes.size()));
    return add_raw(bytes.data(), bytes.size());
}

Hash128 Hasher::finish() const {
    return from_xxhash(XXH3_128bits_digest(&state_->xxh3));
}

}  // namespace patina
