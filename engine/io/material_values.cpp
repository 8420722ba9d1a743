// SPDX-License-Identifier: MIT
#include "io/material_values.h"

#include <algorithm>

namespace patina::io {
namespace {

constexpr float kLargest = 1e6f;  // of factors that glTF does not bound

/// Factors beyond what glTF allows are shown as the nearest one that it does.
float factor(double value, float high = 1.0f) {
    return std::clamp(static_cast<float>(value), 0.0f, high);
}

template <int N>
glm::vec<N, float> factors(const std::vector<double>& values, glm::vec<N, float> fallback) {
    for (int i = 0; i < std::min(N, static_cast<int>(values.size())); ++i)
        fallback[i] = static_cast<float>(values[static_cast<std::size_t>(i)]);
    return glm::clamp(fallback, 0.0f, 1.0f);
}

void read_extensions(const tinygltf::ExtensionMap& extensions, MaterialValues& values) {
    values.unlit = extensions.contains("KHR_materials_unlit");
    values.ior = factor(number_in(extension_of(extensions, "KHR_materials_ior"), "ior", 1.5), 100);
    const auto& specular = extension_of(extensions, "KHR_materials_specular");
    values.specular_factor = factor(number_in(specular, "specularFactor", 1.0));
    numbers_in(specular, "specularColorFactor", std::span(&values.specular_color_factor.x, 3));
    values.specular_color_factor = glm::clamp(values.specular_color_factor, 0.0f, kLargest);
    values.specular = texture_use(specular, "specularTexture");
    values.specular_color = texture_use(specular, "specularColorTexture");
    const auto& strength = extension_of(extensions, "KHR_materials_emissive_strength");
    values.emissive_strength = factor(number_in(strength, "emissiveStrength", 1.0), kLargest);
}

}  // namespace

MaterialValues material_values(const tinygltf::Material& material) {
    MaterialValues values;
    const tinygltf::PbrMetallicRoughness& pbr = material.pbrMetallicRoughness;
    values.base_color = texture_use(pbr.baseColorTexture);
    values.base_color_factor = factors<4>(pbr.baseColorFactor, glm::vec4(1.0f));
    values.metallic_roughness = texture_use(pbr.metallicRoughnessTexture);
    values.metallic_factor = factor(pbr.metallicFactor);
    values.roughness_factor = factor(pbr.roughnessFactor);
    values.normal = texture_use(material.normalTexture);
    values.normal_scale = static_cast<float>(material.normalTexture.scale);
    values.occlusion = texture_use(material.occlusionTexture);
    values.occlusion_strength = factor(material.occlusionTexture.strength);
    values.emissive = texture_use(material.emissiveTexture);
    values.emissive_factor = factors<3>(material.emissiveFactor, glm::vec3(0.0f));
    if (material.alphaMode == "MASK") values.alpha_mode = AlphaMode::Mask;
    if (material.alphaMode == "BLEND") values.alpha_mode = AlphaMode::Blend;
    values.alpha_cutoff = factor(material.alphaCutoff);
    values.double_sided = material.doubleSided;
    read_extensions(material.extensions, values);
    return values;
}

}  // namespace patina::io
