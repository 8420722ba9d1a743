// SPDX-License-Identifier: MIT
#include "io/texture_use.h"

#include <glm/gtc/constants.hpp>

namespace patina::io {
namespace {

/// @param uv_set  what the slot names; a transform may name another
TextureUse use_of(int texture, int uv_set, const tinygltf::Value& transform) {
    TextureUse use{.texture = texture, .named_uv_set = uv_set, .transform = {}};
    if (const int set = index_in(transform, "texCoord"); set >= 0) use.named_uv_set = set;
    if (use.named_uv_set <= kMaxReadUvSet) use.uv_set = use.named_uv_set;
    numbers_in(transform, "offset", std::span(&use.transform.offset.x, 2));
    numbers_in(transform, "scale", std::span(&use.transform.scale.x, 2));
    use.transform.rotation_degrees =
        glm::degrees(static_cast<float>(number_in(transform, "rotation", 0.0)));
    return use;
}

template <typename Info>
TextureUse use_of_info(const Info& info) {
    return use_of(info.index, info.texCoord, extension_of(info.extensions, kTextureTransform));
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
    return use_of(index_in(info, "index"), std::max(index_in(info, "texCoord"), 0),
                  member(member(info, "extensions"), kTextureTransform));
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
