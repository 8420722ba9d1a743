// SPDX-License-Identifier: MIT
#include "io/gltf_json.h"

#include <algorithm>
#include <limits>

namespace patina::io {

Result<GltfJson> GltfJson::open(const std::string& text) {
    auto spans = JsonSpans::scan(text);
    if (!spans) return passed_on(spans);
    if (spans->node(0).kind != JsonKind::Object) return failure("the glTF JSON is not an object");
    return GltfJson(std::move(*spans));
}

Json& GltfJson::array(std::string_view name) {
    const auto found = arrays_.find(name);
    if (found != arrays_.end()) return found->second;
    Json parsed = parsed_at(spans_, fmt::format("/{}", name));
    if (!parsed.is_array()) parsed = Json::array();
    return arrays_.emplace(name, std::move(parsed)).first->second;
}

int GltfJson::number(std::string_view name, int fallback) const {
    const Json value = parsed_at(spans_, fmt::format("/{}", name));
    return value.is_number_integer() ? value.get<int>() : fallback;
}

std::vector<int> GltfJson::numbers_outside(std::string_view array, std::string_view key) const {
    const auto left_out = spans_.member(0, array);
    const TextSpan outside = left_out ? spans_.node(*left_out).value : TextSpan{};
    std::vector<int> numbers;
    for (int i = 0; i < static_cast<int>(spans_.nodes().size()); ++i) {
        const JsonNode& node = spans_.node(i);
        const bool within = node.value.begin >= outside.begin && node.value.end <= outside.end;
        if (within || node.kind != JsonKind::Number || spans_.key_of(i) != key) continue;
        const Json value = Json::parse(spans_.value_text(i), nullptr, false);
        if (value.is_number_integer()) numbers.push_back(value.get<int>());
    }
    return numbers;
}

void GltfJson::use_extension(std::string_view name) {
    Json& used = array("extensionsUsed");
    if (std::find(used.begin(), used.end(), name) == used.end()) used.push_back(std::string(name));
}

void GltfJson::leave_out_unused_extension(std::string_view name) {
    bool used = false;
    for_each_member(array("materials"),
                    [&](const std::string& key, const Json&) { used = used || key == name; });
    if (used) return;
    for (const char* list : {"extensionsUsed", "extensionsRequired"}) {
        Json& names = array(list);
        for (auto it = names.begin(); it != names.end();)
            it = *it == name ? names.erase(it) : std::next(it);
    }
}

Result<std::string> GltfJson::text() const {
    std::vector<JsonChange> changes;
    for (const auto& [name, value] : arrays_) {
        const std::string pointer = fmt::format("/{}", name);
        const auto node = spans_.find(pointer);
        const bool was_empty = !node || spans_.node(*node).first_child < 0;
        if (value.empty() && was_empty) continue;
        changes.push_back({pointer, value.empty() ? std::nullopt : std::optional(value)});
    }
    return spliced(spans_, changes);
}

int index_at(const Json& json, std::string_view key) {
    const auto found = json.is_object() ? json.find(key) : json.end();
    if (found == json.end() || !found->is_number_integer()) return -1;
    const auto value = found->get<std::int64_t>();
    return value >= 0 && value <= std::numeric_limits<int>::max() ? static_cast<int>(value) : -1;
}

std::string text_at(const Json& json, std::string_view key) {
    const auto found = json.is_object() ? json.find(key) : json.end();
    return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

}  // namespace patina::io
