// SPDX-License-Identifier: MIT
#include "io/texture_use.h"

#include <glm/gtc/constants.hpp>

namespace patina::io {
namespace {

TextureUse transformed(TextureUse use, const tinygltf::Value& transform) {
    if (const int set = index_in(transform, "texCoord"); set >= 0) use.uv_set = set;
    numbers_in(transform, "offset", std::span(&use.transform.offset.x, 2));
    numbers_in(transform, "scale", std::span(&use.transform.scale.x, 2));
    use.transform.rotation_degrees =
        glm::degrees(static_cast<float>(number_in(transform, "rotation", 0.0)));
    return use;
}

template <typename Info>
TextureUse use_of_info(const Info& info) {
    return transformed({.texture = info.index, .uv_set = info.texCoord, .transform = {}},
                       extension_of(info.extensions, "KHR_texture_transform"));
}

const tinygltf::Value& member(const tinygltf::Value& object, const char* key) {
    static const tinygltf::Value none;
    return object.Has(key) ? object.Get(key) : none;
}

}  // namespace

TextureUse texture_use(const tinygltf::TextureInfo& info) {
    return use_of_info(info);
}
TextureUse texture_use(const tinygltf::NormalTextureInfo& info) {
    return use_of_info(info);
}
TextureUse texture_use(const tinygltf::OcclusionTextureInfo& info) {
    return use_of_info(info);
}

TextureUse texture_use(const tinygltf::Value& extension, const char* key) {
    const tinygltf::Value& info = member(extension, key);
    const int set = index_in(info, "texCoord");
    return transformed(
        {.texture = index_in(info, "index"), .uv_set = std::max(set, 0), .transform = {}},
        member(member(info, "extensions"), "KHR_texture_transform"));
}

int image_index(const tinygltf::Model& model, const TextureUse& use) {
    if (use.texture < 0) return -1;
    const tinygltf::Texture& texture = model.textures[static_cast<std::size_t>(use.texture)];
    int image = texture.source;
    for (const char* format : kImageFormatExtensions)
        if (image < 0) image = index_in(extension_of(texture.extensions, format), "source");
    return image;
}

}  // namespace patina::io
