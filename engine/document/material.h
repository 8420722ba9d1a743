// SPDX-License-Identifier: MIT
#pragma once

/// A material: its stack of layers and what glTF says of it beside the maps.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "document/layer.h"

namespace patina {

/// Unique within a document and stable over save and reopen; never 0.
struct MaterialId {
    std::uint64_t value = 0;
    auto operator<=>(const MaterialId&) const = default;
};

enum class AlphaMode : std::uint8_t { Opaque, Mask, Blend };

/// What baked maps hold beside the islands that the UVs of the model make of the texture: what the
/// layers make there, or what the nearest texel of an island has, so that no filter or mip-map
/// shows a seam. Auto is the latter where layers read the model.
enum class Padding : std::uint8_t { Auto, Layers, Dilate };

/// Where the numbers of added materials begin, and the most materials that a file may hold.
inline constexpr int kFirstAddedMaterial = 1 << 20;

inline constexpr int kMinResolution = 256;
inline constexpr int kMaxResolution = 8192;

struct Material {
    MaterialId id;
    std::string name;
    std::vector<LayerPtr> stack;  ///< bottom to top
    int resolution = 2048;        ///< side of the baked maps: 256, 512 ... 8192
    int uv_set = 0;               ///< TEXCOORD_n that baked maps use
    float height_scale = 0.02f;   ///< depth of height 1, as a share of the texture's side, 0 to 1
    Padding padding = Padding::Auto;
    AlphaMode alpha_mode = AlphaMode::Opaque;
    float alpha_cutoff = 0.5f;
    bool double_sided = false;
    bool unlit = false;                                 ///< KHR_materials_unlit
    float ior = 1.5f;                                   ///< KHR_materials_ior
    float specular_factor = 1.0f;                       ///< KHR_materials_specular
    glm::vec3 specular_color_linear = glm::vec3(1.0f);  ///< KHR_materials_specular
    /// Textures of that extension, as the file has them: shown and kept, not edited. The first
    /// one's alpha multiplies the factor, the second one's colour (sRGB) the colour.
    std::optional<ImageSource> specular_map = {};
    std::optional<ImageSource> specular_color_map = {};
    float emissive_strength = 1.0f;  ///< KHR_materials_emissive_strength
    /// Index in the glTF file, or kFirstAddedMaterial and beyond for one that an edit added; unset
    /// for the material that stands for primitives without one. What the renderer knows it by.
    std::optional<int> source_material;
    /// The material of the file that an added one is a copy of: what Patina does not understand of
    /// that one goes along when it is saved.
    std::optional<int> copied_from;

    bool operator==(const Material&) const = default;
};

using MaterialPtr = std::shared_ptr<const Material>;

/// Whether an edit added it: nothing of it is in the file that was opened.
inline bool is_added(const Material& material) {
    return material.source_material.value_or(-1) >= kFirstAddedMaterial;
}

/// What lies under every stack: base colour 0.5 linear, metalness 0, roughness 0.5, flat normal,
/// height 0, occlusion 1, emissive 0, opacity 1. Colours and normals in xyz, scalars in x.
glm::vec3 stack_bottom(Channel channel);

}  // namespace patina
