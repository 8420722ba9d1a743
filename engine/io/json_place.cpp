// SPDX-License-Identifier: MIT
#include "io/json_place.h"

#include <cmath>

#include "core/json.h"

namespace patina::io {
namespace {

/// RFC 6901, and fit for a message.
std::string pointer_token(std::string_view key) {
    std::string token;
    for (const char c : key) {
        if (c == '~')
            token += "~0";
        else if (c == '/')
            token += "~1";
        else
            token += c;
    }
    return quoted_for_message(token, 80);
}

std::string child_pointer(const std::string& parent, std::string_view key) {
    return key.empty() ? parent : parent + '/' + pointer_token(key);
}

/// The whole number that a JSON number is, if it is one that 2^53 holds.
std::optional<std::int64_t> whole_number(const SortedJson& value) {
    constexpr std::int64_t kLargest = std::int64_t{1} << 53;
    if (value.is_number_unsigned()) {
        const auto number = value.get<std::uint64_t>();
        if (number > static_cast<std::uint64_t>(kLargest)) return std::nullopt;
        return static_cast<std::int64_t>(number);
    }
    if (value.is_number_integer()) return value.get<std::int64_t>();
    if (!value.is_number_float()) return std::nullopt;
    const double number = value.get<double>();
    if (!(std::abs(number) <= static_cast<double>(kLargest)) || number != std::floor(number))
        return std::nullopt;
    return static_cast<std::int64_t>(number);
}

}  // namespace

JsonPlace::JsonPlace(const SortedJson& value, std::string pointer, FirstFault& fault)
    : value_(&value), pointer_(std::move(pointer)), fault_(&fault) {
    if (!value_->is_object()) this->fault({}, "must be an object");
}

void JsonPlace::fault(std::string_view key, std::string_view what) const {
    const std::string place = child_pointer(pointer_, key);
    fault_->report(fmt::format("{}: {}", place.empty() ? "/" : place, what));
}

const SortedJson* JsonPlace::find(std::string_view key) const {
    if (!value_->is_object()) return nullptr;
    const auto member = value_->find(key);
    return member == value_->end() ? nullptr : &*member;
}

const SortedJson* JsonPlace::find_array(std::string_view key) const {
    const SortedJson* const member = find(key);
    if (!member || member->is_array()) return member;
    fault(key, "must be an array");
    return nullptr;
}

JsonPlace JsonPlace::object(std::string_view key) const {
    static const SortedJson empty = SortedJson::object();
    const SortedJson* const member = find(key);
    return JsonPlace(member ? *member : empty, child_pointer(pointer_, key), *fault_);
}

std::vector<JsonPlace> JsonPlace::objects(std::string_view key) const {
    std::vector<JsonPlace> places;
    const SortedJson* const array = find_array(key);
    if (!array) return places;
    places.reserve(array->size());
    const std::string base = child_pointer(pointer_, key);
    for (std::size_t i = 0; i < array->size(); ++i)
        places.emplace_back((*array)[i], fmt::format("{}/{}", base, i), *fault_);
    return places;
}

std::size_t JsonPlace::array_size(std::string_view key) const {
    const SortedJson* const array = find_array(key);
    return array ? array->size() : 0;
}

bool JsonPlace::boolean(std::string_view key, bool fallback) const {
    const SortedJson* const member = find(key);
    if (!member) return fallback;
    if (member->is_boolean()) return member->get<bool>();
    fault(key, "must be true or false");
    return fallback;
}

float JsonPlace::checked_float(const SortedJson& value, std::string_view key) const {
    if (!value.is_number()) {
        fault(key, "must be a number");
        return 0.0f;
    }
    const auto number = static_cast<float>(value.get<double>());
    if (std::isfinite(number)) return number;
    fault(key, "is too large a number");
    return 0.0f;
}

float JsonPlace::number(std::string_view key, float fallback, Range<float> range) const {
    const SortedJson* const member = find(key);
    if (!member) return fallback;
    const float value = checked_float(*member, key);
    if (value >= range.low && value <= range.high) return value;
    fault(key, fmt::format("is {}, must be {} to {}", value, range.low, range.high));
    return fallback;
}

std::int64_t JsonPlace::integer(std::string_view key, std::int64_t fallback,
                                Range<std::int64_t> range) const {
    const SortedJson* const member = find(key);
    if (!member) return fallback;
    const auto value = whole_number(*member);
    if (value && *value >= range.low && *value <= range.high) return *value;
    if (!value)
        fault(key, "must be a whole number");
    else
        fault(key, fmt::format("is {}, must be {} to {}", *value, range.low, range.high));
    return fallback;
}

std::string JsonPlace::text(std::string_view key) const {
    const SortedJson* const member = find(key);
    if (!member) return {};
    if (member->is_string()) return member->get<std::string>();
    fault(key, "must be a string");
    return {};
}

std::optional<std::string> JsonPlace::record_text() const {
    const SortedJson* const extras = find("extras");
    if (!extras || !extras->is_object()) return std::nullopt;
    const auto record = extras->find("patina");
    if (record == extras->end() || !record->is_string()) return std::nullopt;
    return record->get<std::string>();
}

std::vector<std::string> JsonPlace::texts(std::string_view key) const {
    std::vector<std::string> values;
    const SortedJson* const array = find_array(key);
    if (!array) return values;
    for (const SortedJson& element : *array) {
        if (element.is_string())
            values.push_back(element.get<std::string>());
        else
            fault(key, "must be an array of strings");
    }
    return values;
}

int JsonPlace::checked_index(const SortedJson& value, std::string_view key,
                             std::size_t count) const {
    const auto index = whole_number(value);
    if (index && *index >= 0 && static_cast<std::size_t>(*index) < count)
        return static_cast<int>(*index);
    if (!index)
        fault(key, "must be an index");
    else
        fault(key, fmt::format("is {}, but there are {} of what it points to", *index, count));
    return -1;
}

int JsonPlace::index(std::string_view key, std::size_t count) const {
    const SortedJson* const member = find(key);
    return member ? checked_index(*member, key, count) : -1;
}

int JsonPlace::required_index(std::string_view key, std::size_t count) const {
    if (!has(key)) fault(key, "is missing");
    return index(key, count);
}

std::vector<int> JsonPlace::indices(std::string_view key, std::size_t count) const {
    std::vector<int> values;
    const SortedJson* const array = find_array(key);
    if (!array) return values;
    values.reserve(array->size());
    for (std::size_t i = 0; i < array->size(); ++i) {
        const int index = checked_index((*array)[i], key, count);
        if (index < 0) return {};
        values.push_back(index);
    }
    return values;
}

std::vector<std::pair<std::string, int>> JsonPlace::index_members(std::size_t count) const {
    std::vector<std::pair<std::string, int>> members;
    if (!value_->is_object()) return members;
    for (const auto& [key, value] : value_->items()) {
        const int index = checked_index(value, key, count);
        if (index >= 0) members.emplace_back(key, index);
    }
    return members;
}

void JsonPlace::numbers(std::string_view key, std::span<float> numbers) const {
    const SortedJson* const array = find_array(key);
    if (!array) return;
    if (array->size() != numbers.size())
        return fault(key,
                     fmt::format("has {} numbers, must have {}", array->size(), numbers.size()));
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = checked_float((*array)[i], key);
}

std::vector<float> JsonPlace::numbers(std::string_view key) const {
    std::vector<float> values(array_size(key));
    numbers(key, values);
    return values;
}

}  // namespace patina::io
