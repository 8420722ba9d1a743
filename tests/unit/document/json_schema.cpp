// SPDX-License-Identifier: MIT
#include "unit/document/json_schema.h"

#include <algorithm>
#include <cmath>
#include <regex>
#include <set>

#include "core/json.h"

namespace patina::test_support {
namespace {

bool has_type(const SortedJson& value, const std::string& type) {
    if (type == "object") return value.is_object();
    if (type == "array") return value.is_array();
    if (type == "string") return value.is_string();
    if (type == "boolean") return value.is_boolean();
    if (type == "number") return value.is_number();
    if (type == "integer")
        return value.is_number_integer() ||
               (value.is_number() && value.get<double>() == std::floor(value.get<double>()));
    return false;
}

bool keyword_is_known(const std::string& keyword) {
    static const std::set<std::string> known = {"$schema",   "$id",
                                                "$defs",     "$ref",
                                                "title",     "description",
                                                "default",   "type",
                                                "enum",      "const",
                                                "minimum",   "maximum",
                                                "pattern",   "minLength",
                                                "maxLength", "items",
                                                "minItems",  "maxItems",
                                                "anyOf",     "properties",
                                                "required",  "additionalProperties"};
    return known.contains(keyword);
}

/// Keywords that look at numbers, texts and whole values.
std::string plain_fault(const SortedJson& schema, const SortedJson& value) {
    if (schema.contains("type") && !has_type(value, schema["type"])) return "has the wrong type";
    if (schema.contains("const") && value != schema["const"]) return "is not the constant";
    if (schema.contains("enum")) {
        const SortedJson& allowed = schema["enum"];
        if (std::find(allowed.begin(), allowed.end(), value) == allowed.end())
            return "is none of " + allowed.dump();
    }
    if (value.is_number()) {
        if (schema.contains("minimum") && value < schema["minimum"]) return "is too small";
        if (schema.contains("maximum") && value > schema["maximum"]) return "is too large";
    }
    if (value.is_string()) {
        const std::string text = value;
        if (schema.contains("minLength") && text.size() < schema["minLength"])
            return "is too short";
        if (schema.contains("maxLength") && text.size() > schema["maxLength"]) return "is too long";
        if (schema.contains("pattern") &&
            !std::regex_search(text, std::regex(schema["pattern"].get<std::string>())))
            return "does not match the pattern";
    }
    return "";
}

std::string array_fault(const SortedJson& root, const SortedJson& schema, const SortedJson& value,
                        const std::string& pointer) {
    if (schema.contains("minItems") && value.size() < schema["minItems"])
        return "has too few items";
    if (schema.contains("maxItems") && value.size() > schema["maxItems"])
        return "has too many items";
    if (!schema.contains("items")) return "";
    for (std::size_t i = 0; i < value.size(); ++i) {
        std::string fault =
            schema_fault(root, schema["items"], value[i], pointer + "/" + std::to_string(i));
        if (!fault.empty()) return fault;
    }
    return "";
}

std::string object_fault(const SortedJson& root, const SortedJson& schema, const SortedJson& value,
                         const std::string& pointer) {
    for (const SortedJson& key : schema.value("required", SortedJson::array()))
        if (!value.contains(key.get<std::string>())) return "lacks " + key.get<std::string>();
    const SortedJson properties = schema.value("properties", SortedJson::object());
    for (const auto& [key, member] : value.items()) {
        const SortedJson* rule = nullptr;
        if (properties.contains(key))
            rule = &properties[key];
        else if (schema.contains("additionalProperties"))
            rule = &schema["additionalProperties"];
        if (!rule) continue;
        if (rule->is_boolean() && !rule->get<bool>()) return "has an unknown key " + key;
        std::string fault = schema_fault(root, *rule, member, pointer + "/" + key);
        if (!fault.empty()) return fault;
    }
    return "";
}

std::string any_of_fault(const SortedJson& root, const SortedJson& schema, const SortedJson& value,
                         const std::string& pointer) {
    std::string last;
    for (const SortedJson& choice : schema["anyOf"]) {
        last = schema_fault(root, choice, value, pointer);
        if (last.empty()) return "";
    }
    return "matches no alternative, the last because it " + last;
}

}  // namespace

std::string schema_fault(const SortedJson& root, const SortedJson& schema, const SortedJson& value,
                         const std::string& pointer) {
    for (const auto& [keyword, unused] : schema.items())
        if (!keyword_is_known(keyword)) return "the validator does not know " + keyword;
    std::string fault;
    if (schema.contains("$ref")) {
        const std::string target = schema["$ref"].get<std::string>().substr(1);
        fault = schema_fault(root, root.at(SortedJson::json_pointer(target)), value, pointer);
        if (!fault.empty()) return fault;
    }
    fault = plain_fault(schema, value);
    if (fault.empty() && schema.contains("anyOf"))
        fault = any_of_fault(root, schema, value, pointer);
    if (fault.empty() && value.is_array()) fault = array_fault(root, schema, value, pointer);
    if (fault.empty() && value.is_object()) fault = object_fault(root, schema, value, pointer);
    if (fault.empty() || fault.starts_with("/")) return fault;
    return pointer + "/ " + fault;
}

}  // namespace patina::test_support
