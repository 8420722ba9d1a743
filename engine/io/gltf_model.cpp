// SPDX-License-Identifier: MIT
#include "io/gltf_model.h"

#include <algorithm>

namespace patina::io {

std::optional<std::string> record_text(const tinygltf::Value& extras) {
    if (!extras.Has("patina") || !extras.Get("patina").IsString()) return std::nullopt;
    return extras.Get("patina").Get<std::string>();
}

ElementLayout layout_of(const tinygltf::Accessor& accessor) {
    const ComponentType type = component_type(accessor.componentType).value_or(ComponentType::F32);
    switch (accessor.type) {
        case TINYGLTF_TYPE_MAT2:
            return {.type = type, .rows = 2, .columns = 2};
        case TINYGLTF_TYPE_MAT3:
            return {.type = type, .rows = 3, .columns = 3};
        case TINYGLTF_TYPE_MAT4:
            return {.type = type, .rows = 4, .columns = 4};
        default:
            return {
                .type = type,
                .rows = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)),
                .columns = 1};
    }
}

const tinygltf::Value& extension_of(const tinygltf::ExtensionMap& extensions, const char* name) {
    static const tinygltf::Value none{tinygltf::Value::Object()};
    const auto found = extensions.find(name);
    return found == extensions.end() ? none : found->second;
}

double number_in(const tinygltf::Value& object, const char* key, double fallback) {
    return object.Has(key) ? object.Get(key).GetNumberAsDouble() : fallback;
}

int index_in(const tinygltf::Value& object, const char* key) {
    return object.Has(key) ? object.Get(key).GetNumberAsInt() : -1;
}

void numbers_in(const tinygltf::Value& object, const char* key, std::span<float> numbers) {
    if (!object.Has(key)) return;
    const tinygltf::Value& array = object.Get(key);
    for (std::size_t i = 0; i < std::min(numbers.size(), array.ArrayLen()); ++i)
        numbers[i] = static_cast<float>(array.Get(static_cast<int>(i)).GetNumberAsDouble());
}

}  // namespace patina::io
