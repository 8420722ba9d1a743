// SPDX-License-Identifier: MIT
#pragma once

/// A cursor over parsed JSON that checks what it reads. Every getter takes the key of a member; an
/// absent member gives the fallback, one that is not what it should be reports a fault with its
/// JSON pointer and gives the fallback too. The first fault is kept: look at it once at the end.

#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace patina::io {

class FirstFault {
  public:
    void report(std::string message) {
        if (!message_) message_ = std::move(message);
    }
    bool found() const { return message_.has_value(); }
    Status status() const { return message_ ? Status(failure("{}", *message_)) : Status(); }

  private:
    std::optional<std::string> message_;
};

template <typename T>
struct Range {
    T low = std::numeric_limits<T>::lowest();
    T high = std::numeric_limits<T>::max();
};

/// An object in the file. Lives no longer than the value and the fault that it points to.
class JsonPlace {
  public:
    JsonPlace(const nlohmann::json& value, std::string pointer, FirstFault& fault);

    const std::string& pointer() const { return pointer_; }
    bool has(std::string_view key) const { return find(key) != nullptr; }

    /// The object that is a member; empty where it is absent.
    JsonPlace object(std::string_view key) const;
    /// The elements of an array of objects.
    std::vector<JsonPlace> objects(std::string_view key) const;
    std::size_t array_size(std::string_view key) const;

    bool boolean(std::string_view key, bool fallback) const;
    /// Finite as a float, and within `range`.
    float number(std::string_view key, float fallback, Range<float> range = {}) const;
    /// A whole number; 3.0 is one.
    std::int64_t integer(std::string_view key, std::int64_t fallback,
                         Range<std::int64_t> range = {}) const;
    std::string text(std::string_view key) const;
    /// extras.patina where that is a string. Extras may be anything, so nothing here is a fault.
    std::optional<std::string> record_text() const;
    std::vector<std::string> texts(std::string_view key) const;

    /// An index of an array with `count` elements; -1 where it is absent.
    int index(std::string_view key, std::size_t count) const;
    int required_index(std::string_view key, std::size_t count) const;
    std::vector<int> indices(std::string_view key, std::size_t count) const;
    /// Every member of the object is an index.
    std::vector<std::pair<std::string, int>> index_members(std::size_t count) const;

    /// Fills all of `numbers`; they are left alone where the member is absent.
    void numbers(std::string_view key, std::span<float> numbers) const;
    std::vector<float> numbers(std::string_view key) const;

    /// Reports a fault of a member, or of this object where `key` is empty.
    void fault(std::string_view key, std::string_view what) const;

  private:
    const nlohmann::json* find(std::string_view key) const;
    const nlohmann::json* find_array(std::string_view key) const;
    float checked_float(const nlohmann::json& value, std::string_view key) const;
    int checked_index(const nlohmann::json& value, std::string_view key, std::size_t count) const;

    const nlohmann::json* value_;
    std::string pointer_;
    FirstFault* fault_;
};

}  // namespace patina::io
