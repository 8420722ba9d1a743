// SPDX-License-Identifier: MIT
#pragma once

/// What a glTF file says of a material, with its defaults filled in and its factors brought into
/// the ranges that glTF allows: 0 to 1 where nothing else is said.

#include <array>
#include <glm/glm.hpp>

#include "document/material.h"
#include "io/texture_use.h"

namespace patina::io {

struct MaterialValues {
    TextureUse base_color;
    glm::vec4 base_color_factor = glm::vec4(1.0f);
    TextureUse metallic_roughness;
    float metallic_factor = 1.0f;
    float roughness_factor = 1.0f;
    TextureUse normal;
    float normal_scale = 1.0f;  ///< any
    TextureUse occlusion;
    float occlusion_strength = 1.0f;
    TextureUse emissive;
    glm::vec3 emissive_factor = glm::vec3(0.0f);
    AlphaMode alpha_mode = AlphaMode::Opaque;
    float alpha_cutoff = 0.5f;
    bool double_sided = false;
    bool unlit = false;
    float ior = 1.5f;  ///< 0 to 100
    float specular_factor = 1.0f;
    TextureUse specular;
    glm::vec3 specular_color_factor = glm::vec3(1.0f);  ///< 0 to a million
    TextureUse specular_color;
    float emissive_strength = 1.0f;  ///< 0 to a million

    /// The slots that layers make maps for, the base colour's first.
    std::array<const TextureUse*, 5> slots() const {
        return {&base_color, &metallic_roughness, &normal, &occlusion, &emissive};
    }
    std::array<const TextureUse*, 7> textures() const {
        return {&base_color, &metallic_roughness, &normal,        &occlusion,
                &emissive,   &specular,           &specular_color};
    }
};

MaterialValues material_values(const tinygltf::Material& material);

}  // namespace patina::io
