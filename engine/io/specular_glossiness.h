// SPDX-License-Identifier: MIT
#pragma once

/// Materials of KHR_materials_pbrSpecularGlossiness, shown and edited as metallic-roughness.
///
/// The conversion is the one that Khronos published with the extension: glTF repository,
/// extensions/2.0/Archived/KHR_materials_pbrSpecularGlossiness/examples/convert-between-workflows
/// (babylon.pbrUtilities.js). It looks for the metalness with which a dielectric reflectance of
/// 0.04 explains the brightness of diffuse and specular colour. What has no such reading (a
/// coloured specular over a bright diffuse colour) comes out close, not equal.

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "io/image_store.h"
#include "io/material_read.h"

namespace patina::io {

/// Linear, 0 to 1.
struct SpecularGlossiness {
    glm::vec4 diffuse = glm::vec4(1.0f);  ///< w: opacity
    glm::vec3 specular = glm::vec3(1.0f);
    float glossiness = 1.0f;
};

struct MetallicRoughness {
    glm::vec4 base_color = glm::vec4(1.0f);  ///< linear; w: opacity
    float metallic = 0.0f;
    float roughness = 0.0f;
};

MetallicRoughness metallic_roughness_of(const SpecularGlossiness& texel);

/// Turns every material of the extension into metallic-roughness: its factors where it has no maps,
/// else maps of 8 bits made texel by texel, added behind the images and textures of the file. The
/// extension is gone from the model afterwards; the file's own text keeps it until the material is
/// edited.
/// @param images  by index of the model's images; grows with them
Status convert_specular_glossiness(tinygltf::Model& model, FileImages& images, ImageStore& store,
                                   std::vector<std::string>& warnings);

}  // namespace patina::io
