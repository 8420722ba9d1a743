// SPDX-License-Identifier: MIT
#pragma once

/// The JSON of a glTF file while a save edits it: members of the root are parsed when they are
/// asked for, and go back into the text as splices.

#include <map>
#include <string>
#include <string_view>

#include "io/json_splice.h"

namespace patina::io {

class GltfJson {
  public:
    static Result<GltfJson> open(const std::string& text);

    /// An array of the root ("materials", "images" ...), to read and to change; empty where the
    /// file has none. References stay good for as long as this object.
    Json& array(std::string_view name);
    std::size_t count(std::string_view name) { return array(name).size(); }
    /// A number of the root, such as "scene", or `fallback`.
    int number(std::string_view name, int fallback) const;
    /// Every whole number that is a member called `key`, anywhere but under the root's `array`.
    std::vector<int> numbers_outside(std::string_view array, std::string_view key) const;
    /// Names an extension in extensionsUsed.
    void use_extension(std::string_view name);
    /// Takes an extension of materials out of extensionsUsed and extensionsRequired, unless one
    /// that stands in "materials" still has it.
    void leave_out_unused_extension(std::string_view name);

    /// The text with all that was changed, and every other byte as it was. An array that has become
    /// empty is left out, as glTF wants.
    Result<std::string> text() const;

  private:
    explicit GltfJson(JsonSpans spans) : spans_(std::move(spans)) {}

    JsonSpans spans_;
    std::map<std::string, Json, std::less<>> arrays_;
};

/// Calls `visit(key, value)` for every member of every object in `json`, at any depth.
template <typename Visit>
void for_each_member(Json& json, const Visit& visit) {
    if (!json.is_structured()) return;
    for (auto& [key, value] : json.items()) {
        if (json.is_object()) visit(key, value);
        for_each_member(value, visit);
    }
}

/// Calls `visit(primitive)` for every primitive of "meshes".
template <typename Visit>
void for_each_primitive(Json& meshes, const Visit& visit) {
    for (Json& mesh : meshes)
        if (mesh.is_object() && mesh.contains("primitives"))
            for (Json& primitive : mesh["primitives"])
                if (primitive.is_object()) visit(primitive);
}

/// `json[key]` if that is an integer, or -1.
int index_at(const Json& json, std::string_view key);
/// The string `json[key]`, or an empty one.
std::string text_at(const Json& json, std::string_view key);

}  // namespace patina::io
