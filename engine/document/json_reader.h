// SPDX-License-Identifier: MIT
#pragma once

/// Reading JSON that may say anything: a strict view of one object, which knows where it is and
/// which of its keys were asked for. The first fault is kept and names its JSON pointer; after it
/// every question is answered with a default, so that readers need no check after each key.

#include <cstdint>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/hash.h"
#include "core/json.h"
#include "core/result.h"
#include "document/choices.h"
#include "document/parameters.h"

namespace patina {

/// Parses text under limits: depth 160, no key twice in one object, nothing after the value.
Result<Json> json_from_text(std::string_view text);

/// The first fault of one reading.
class JsonFaults {
  public:
    void add(std::string_view pointer, std::string_view fault);
    bool any() const { return first_.has_value(); }
    /// The fault, or success.
    Status status() const;

  private:
    std::optional<Error> first_;
};

class JsonObject {
  public:
    /// Faults when `value` is no object. Both have to outlive this.
    JsonObject(const Json& value, std::string pointer, JsonFaults& faults);

    const std::string& pointer() const { return pointer_; }
    std::string pointer_to(std::string_view key) const;
    JsonFaults& faults() const { return faults_; }
    void fault(std::string_view key, std::string_view what) const;
    bool has(std::string_view key) const;

    /// The member, or null when it is absent. Counts as asked for.
    const Json* find(std::string_view key);
    /// The member; a fault when it is absent.
    const Json* require(std::string_view key);

    bool boolean(std::string_view key, bool standard);
    /// A number in the parameter's range.
    float number(std::string_view key, Parameter parameter, float standard);
    std::int64_t integer(std::string_view key, std::int64_t minimum, std::int64_t maximum,
                         std::int64_t standard);
    std::string text(std::string_view key, std::string_view standard = {});
    std::string required_text(std::string_view key);
    std::vector<std::string> texts(std::string_view key);
    /// 32 hexadecimal digits.
    Hash128 required_hash(std::string_view key);
    /// Two or three numbers, each in the parameter's range.
    glm::vec2 vector2(std::string_view key, Parameter parameter, const glm::vec2& standard);
    glm::vec3 vector3(std::string_view key, Parameter parameter, const glm::vec3& standard);

    /// What `read(element, its pointer, faults)` makes of each element of a list that may be
    /// absent; nothing, and a fault, where the member is something else or holds more than
    /// `at_most`.
    template <typename Read>
    auto list(std::string_view key, std::size_t at_most, const Read& read) {
        std::vector<std::invoke_result_t<Read, const Json&, std::string, JsonFaults&>> elements;
        const Json* json = find_list(key, at_most);
        if (json == nullptr) return elements;
        for (std::size_t i = 0; i < json->size(); ++i)
            elements.push_back(
                read((*json)[i], pointer_to(key) + '/' + std::to_string(i), faults_));
        return elements;
    }

    template <typename Enumeration>
    Enumeration choice(std::string_view key, Enumeration standard) {
        const Json* value = find(key);
        if (!value) return standard;
        if (value->is_string())
            if (const auto found =
                    choice_from_id<Enumeration>(value->get_ref<const std::string&>()))
                return *found;
        fault(key, "is none of " + ids_of(choices<Enumeration>()));
        return standard;
    }

    /// Faults on the first key that nothing asked for.
    void finish();

  private:
    const Json* find_list(std::string_view key, std::size_t at_most);
    static std::string ids_of(std::span<const Choice> table);
    std::vector<float> numbers(std::string_view key, Parameter parameter, std::size_t count);

    const Json& value_;
    std::string pointer_;
    JsonFaults& faults_;
    std::set<std::string, std::less<>> known_;
};

/// A finite number that is in the parameter's range, the nearest whole one where the parameter is
/// whole; a fault at `pointer` otherwise.
float json_number(const Json& value, Parameter parameter, const std::string& pointer,
                  JsonFaults& faults);

/// A float as the shortest JSON number that reads back to it; whole numbers without a point.
Json json_of(float value);
/// A number when all three are the same, else an array.
Json json_of(const glm::vec2& value);
Json json_of(const glm::vec3& value);

/// Compact text, the same for equal values. Broken UTF-8 becomes U+FFFD.
std::string compact_text(const Json& json);
/// Indented by two spaces; what fits on a line of 100 characters stands on one.
std::string indented_text(const Json& json);

}  // namespace patina
