// SPDX-License-Identifier: MIT
#include "document/json_reader.h"

#include <charconv>
#include <cmath>

namespace patina {
namespace {

/// Groups nest 64 deep and each takes an array and an object; the rest is for what they hold.
constexpr int kDepthLimit = 160;
constexpr std::size_t kLineWidth = 100;

/// Whether brackets nest deeper than the limit; strings are skipped.
bool too_deep(std::string_view text) {
    int depth = 0;
    bool in_string = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (in_string) {
            if (c == '\\') ++i;
            if (c == '"') in_string = false;
        } else if (c == '"') {
            in_string = true;
        } else if (c == '{' || c == '[') {
            if (++depth > kDepthLimit) return true;
        } else if (c == '}' || c == ']') {
            --depth;
        }
    }
    return false;
}

/// Notes the first key that occurs twice in one object while the text is parsed.
class RepeatedKeys {
  public:
    void see(Json::parse_event_t event, const Json& parsed) {
        if (event == Json::parse_event_t::object_start) open_.emplace_back();
        if (event == Json::parse_event_t::object_end) open_.pop_back();
        if (event != Json::parse_event_t::key || repeated_) return;
        const auto& key = parsed.get_ref<const std::string&>();
        if (!open_.back().insert(key).second) repeated_ = key;
    }
    const std::optional<std::string>& repeated() const { return repeated_; }

  private:
    std::vector<std::set<std::string>> open_;
    std::optional<std::string> repeated_;
};

std::string escaped_for_pointer(std::string_view key) {
    std::string escaped;
    for (const char c : key) {
        if (c == '~')
            escaped += "~0";
        else if (c == '/')
            escaped += "~1";
        else
            escaped += c;
    }
    return quoted_for_message(escaped, 80);
}

std::string line_of(const Json& json) {
    if (!json.is_structured() || json.empty())
        return json.dump(-1, ' ', false, Json::error_handler_t::replace);
    std::string line = json.is_object() ? "{" : "[";
    bool first = true;
    for (const auto& [key, value] : json.items()) {
        if (!first) line += ", ";
        first = false;
        if (json.is_object())
            line += Json(key).dump(-1, ' ', false, Json::error_handler_t::replace) + ": ";
        line += line_of(value);
    }
    return line + (json.is_object() ? "}" : "]");
}

void write_indented(const Json& json, std::size_t indent, std::size_t used, std::string& text) {
    const std::string line = line_of(json);
    if (!json.is_structured() || json.empty() || used + line.size() <= kLineWidth) {
        text += line;
        return;
    }
    const std::string margin(indent + 2, ' ');
    text += json.is_object() ? "{\n" : "[\n";
    std::size_t left = json.size();
    for (const auto& [key, value] : json.items()) {
        const std::string label =
            json.is_object() ? Json(key).dump(-1, ' ', false, Json::error_handler_t::replace) + ": "
                             : std::string();
        text += margin + label;
        // One more for the comma.
        write_indented(value, indent + 2, margin.size() + label.size() + 1, text);
        text += --left > 0 ? ",\n" : "\n";
    }
    text += std::string(indent, ' ') + (json.is_object() ? "}" : "]");
}

}  // namespace

Result<Json> json_from_text(std::string_view text) {
    if (too_deep(text)) return failure("JSON nested deeper than {} levels", kDepthLimit);
    RepeatedKeys keys;
    const auto watch = [&keys](int, Json::parse_event_t event, Json& parsed) {
        keys.see(event, parsed);
        return true;
    };
    Json json = Json::parse(text.begin(), text.end(), watch, false);
    if (json.is_discarded()) return failure("not valid JSON");
    if (keys.repeated())
        return failure("the key \"{}\" occurs twice in one object",
                       quoted_for_message(*keys.repeated(), 80));
    return json;
}

void JsonFaults::add(std::string_view pointer, std::string_view fault) {
    if (first_) return;
    first_ = Error{fmt::format("{} {}", pointer.empty() ? "the whole" : pointer, fault)};
}

Status JsonFaults::status() const {
    if (first_) return tl::unexpected<Error>(*first_);
    return {};
}

JsonObject::JsonObject(const Json& value, std::string pointer, JsonFaults& faults)
    : value_(value), pointer_(std::move(pointer)), faults_(faults) {
    if (!value_.is_object()) faults_.add(pointer_, "is not an object");
}

std::string JsonObject::pointer_to(std::string_view key) const {
    return pointer_ + "/" + escaped_for_pointer(key);
}

void JsonObject::fault(std::string_view key, std::string_view what) const {
    faults_.add(pointer_to(key), what);
}

bool JsonObject::has(std::string_view key) const {
    return value_.is_object() && value_.find(std::string(key)) != value_.end();
}

const Json* JsonObject::find(std::string_view key) {
    known_.emplace(key);
    if (!value_.is_object()) return nullptr;
    const auto found = value_.find(std::string(key));
    return found == value_.end() ? nullptr : &*found;
}

const Json* JsonObject::require(std::string_view key) {
    const Json* value = find(key);
    if (!value) fault(key, "is missing");
    return value;
}

bool JsonObject::boolean(std::string_view key, bool standard) {
    const Json* value = find(key);
    if (!value) return standard;
    if (value->is_boolean()) return value->get<bool>();
    fault(key, "is not true or false");
    return standard;
}

float JsonObject::number(std::string_view key, Parameter parameter, float standard) {
    const Json* value = find(key);
    return value ? json_number(*value, parameter, pointer_to(key), faults_) : standard;
}

std::int64_t JsonObject::integer(std::string_view key, std::int64_t minimum, std::int64_t maximum,
                                 std::int64_t standard) {
    const Json* value = find(key);
    if (!value) return standard;
    // Unsigned numbers above the range of int64 would wrap when read as one.
    const bool fits =
        value->is_number_integer() &&
        !(value->is_number_unsigned() && value->get<std::uint64_t>() > std::uint64_t{INT64_MAX});
    const std::int64_t number = fits ? value->get<std::int64_t>() : 0;
    if (fits && number >= minimum && number <= maximum) return number;
    fault(key, fmt::format("is not a whole number from {} to {}", minimum, maximum));
    return standard;
}

std::string JsonObject::text(std::string_view key, std::string_view standard) {
    const Json* value = find(key);
    if (!value) return std::string(standard);
    if (value->is_string()) return value->get<std::string>();
    fault(key, "is not a text");
    return std::string(standard);
}

std::string JsonObject::required_text(std::string_view key) {
    return require(key) ? text(key) : std::string();
}

std::vector<std::string> JsonObject::texts(std::string_view key) {
    std::vector<std::string> result;
    const Json* value = find(key);
    if (!value) return result;
    const bool valid =
        value->is_array() && std::all_of(value->begin(), value->end(),
                                         [](const Json& each) { return each.is_string(); });
    if (!valid) {
        fault(key, "is not a list of texts");
        return result;
    }
    for (const Json& each : *value) result.push_back(each.get<std::string>());
    return result;
}

const Json* JsonObject::find_list(std::string_view key, std::size_t at_most) {
    const Json* value = find(key);
    if (value == nullptr || (value->is_array() && value->size() <= at_most)) return value;
    fault(key, fmt::format("is not a list of at most {} {}", at_most, key));
    return nullptr;
}

Hash128 JsonObject::required_hash(std::string_view key) {
    if (!require(key)) return {};
    const std::optional<Hash128> hash = hash_from_hex(text(key));
    if (!hash) fault(key, "is not a hash of 32 hexadecimal digits");
    return hash.value_or(Hash128{});
}

std::vector<float> JsonObject::numbers(std::string_view key, Parameter parameter,
                                       std::size_t count) {
    std::vector<float> result;
    const Json* value = find(key);
    if (!value) return result;
    const std::string pointer = pointer_to(key);
    if (value->is_number())
        return std::vector(count, json_number(*value, parameter, pointer, faults_));
    if (!value->is_array() || value->size() != count) {
        fault(key, fmt::format("is neither a number nor {} of them", count));
        return result;
    }
    for (const Json& each : *value)
        result.push_back(json_number(each, parameter, pointer, faults_));
    return result;
}

glm::vec2 JsonObject::vector2(std::string_view key, Parameter parameter,
                              const glm::vec2& standard) {
    const std::vector<float> read = numbers(key, parameter, 2);
    return read.empty() ? standard : glm::vec2(read[0], read[1]);
}

glm::vec3 JsonObject::vector3(std::string_view key, Parameter parameter,
                              const glm::vec3& standard) {
    const std::vector<float> read = numbers(key, parameter, 3);
    return read.empty() ? standard : glm::vec3(read[0], read[1], read[2]);
}

void JsonObject::finish() {
    if (!value_.is_object()) return;
    for (const auto& [key, unused] : value_.items())
        if (!known_.contains(key)) fault(key, "is not known to this version");
}

std::string JsonObject::ids_of(std::span<const Choice> table) {
    std::string ids;
    for (const Choice& row : table) ids += (ids.empty() ? "" : ", ") + std::string(row.id);
    return ids;
}

float json_number(const Json& value, Parameter parameter, const std::string& pointer,
                  JsonFaults& faults) {
    if (!value.is_number()) {
        faults.add(pointer, "is not a number");
        return 0.0f;
    }
    auto number = value.get<double>();
    // Files have had decimals of what was always taken for the nearest whole number, and so do the
    // places between the ends of a preset's knob.
    if (info(parameter).kind == ParameterKind::Integer) number = std::round(number);
    if (Status status = check_range(parameter, number); !status) {
        faults.add(pointer, "is out of range: " + status.error().message);
        return 0.0f;
    }
    return static_cast<float>(number);
}

Json json_of(float value) {
    if (value == 0.0f) return 0;  // minus zero too
    if (value == std::trunc(value) && std::abs(value) < 1e9f)
        return static_cast<std::int64_t>(value);
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
    double shortest = 0.0;
    std::from_chars(digits, end, shortest);
    // The double nearest to the shortest decimal could round to a neighbour of `value` in theory.
    return static_cast<float>(shortest) == value ? shortest : static_cast<double>(value);
}

Json json_of(const glm::vec2& value) {
    if (value.x == value.y) return json_of(value.x);
    return Json::array({json_of(value.x), json_of(value.y)});
}

Json json_of(const glm::vec3& value) {
    if (value.x == value.y && value.y == value.z) return json_of(value.x);
    return Json::array({json_of(value.x), json_of(value.y), json_of(value.z)});
}

std::string compact_text(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string indented_text(const Json& json) {
    std::string text;
    write_indented(json, 0, 0, text);
    return text + "\n";
}

}  // namespace patina
