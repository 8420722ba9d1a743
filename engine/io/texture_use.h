// SPDX-License-Identifier: MIT
#pragma once

/// Textures of a glTF file: what shows them, and what they show.

#include <array>
#include <vector>

#include "document/source.h"
#include "io/gltf_model.h"

namespace patina::io {

/// The highest TEXCOORD_n that a file may name.
inline constexpr int kMaxUvSet = 15;
/// The highest that Patina reads. Maps that name another are shown by TEXCOORD_0.
inline constexpr int kMaxReadUvSet = 1;

/// The extension that moves, turns and scales the UVs of one use of a texture (UvTransform).
inline constexpr const char* kTextureTransform = "KHR_texture_transform";
/// Extensions that give a texture an image in another format than glTF's own.
inline constexpr std::array kImageFormatExtensions = {"EXT_texture_webp", "KHR_texture_basisu",
                                                      "EXT_texture_avif", "MSFT_texture_dds"};

/// A material's use of a texture; absent while `texture` is -1.
struct TextureUse {
    int texture = -1;
    int uv_set = 0;        ///< TEXCOORD_n that is read, 0 to kMaxReadUvSet
    int named_uv_set = 0;  ///< TEXCOORD_n that the file names, 0 to kMaxUvSet
    UvTransform transform;
};

TextureUse texture_use(const tinygltf::TextureInfo& info);
TextureUse texture_use(const tinygltf::NormalTextureInfo& info);
TextureUse texture_use(const tinygltf::OcclusionTextureInfo& info);
/// Of an extension's own slot.
TextureUse texture_use(const tinygltf::Value& extension, const char* key);

/// The image that a use of a texture shows, -1 for none: the texture's own, or one in a format that
/// an extension adds.
int image_index(const tinygltf::Model& model, const TextureUse& use);

}  // namespace patina::io
