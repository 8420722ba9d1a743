// SPDX-License-Identifier: MIT
#pragma once

/// Content hashes (XXH3, 128 bit). Caches and references in Patina are keyed by them, never by an
/// address, so that equal content is found again in another session and on another machine.

#include <compare>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace patina {

struct Hash128 {
    std::uint64_t high = 0;
    std::uint64_t low = 0;
    auto operator<=>(const Hash128&) const = default;
};

/// 32 lower-case hexadecimal digits, most significant first.
std::string to_hex(const Hash128& hash);
/// The hash that `to_hex` wrote, or nothing for any other text.
std::optional<Hash128> hash_from_hex(std::string_view text);

Hash128 hash_bytes(std::span<const std::byte> bytes);
Hash128 hash_text(std::string_view text);

/// Hashes a sequence of values. Equal sequences of `add` calls give equal hashes on every machine
/// with the same byte order. Text and byte spans are preceded by their length, so that "ab","c" and
/// "a","bc" differ.
class Hasher {
  public:
    Hasher();
    ~Hasher();
    Hasher(const Hasher&) = delete;
    Hasher& operator=(const Hasher&) = delete;

    Hasher& add(std::string_view text);
    Hasher& add_bytes(std::span<const std::byte> bytes);

    /// A number or an enumerator. Structures are added member by member: their padding is not
    /// content. Minus zero counts as zero.
    template <typename T>
    requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) Hasher& add(T value) {
        if constexpr (std::is_floating_point_v<T>) value = value == T(0) ? T(0) : value;
        return add_raw(&value, sizeof value);
    }
    Hasher& add(const Hash128& hash) { return add(hash.high).add(hash.low); }

    Hash128 finish() const;

  private:
    Hasher& add_raw(const void* data, std::size_t size_bytes);
    struct State;
    std::unique_ptr<State> state_;
};

/// For unordered containers.
struct Hash128Hash {
    std::size_t operator()(const Hash128& hash) const noexcept { return hash.low; }
};

}  // namespace patina
