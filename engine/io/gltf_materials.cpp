// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <glm/gtc/constants.hpp>

#include "io/gltf_read.h"

namespace patina::io::gltf {
namespace {

constexpr int kMaxUvSet = 15;

Wrap read_wrap(const JsonPlace& place, std::string_view key) {
    switch (place.integer(key, 10497)) {
        case 10497:
            return Wrap::Repeat;
        case 33648:
            return Wrap::Mirror;
        case 33071:
            return Wrap::Clamp;
        default:
            place.fault(key, "is not a wrap mode of glTF");
            return Wrap::Repeat;
    }
}

/// The image that a texture shows: its own, or one in a format that an extension adds.
int read_texture_image(const JsonPlace& place, std::size_t images) {
    constexpr std::array kFormats = std::to_array<std::string_view>(
        {"EXT_texture_webp", "KHR_texture_basisu", "EXT_texture_avif", "MSFT_texture_dds"});
    int image = place.index("source", images);
    const JsonPlace extensions = place.object("extensions");
    for (const std::string_view format : kFormats) {
        if (!extensions.has(format)) continue;
        const int other = extensions.object(format).index("source", images);
        if (image < 0) image = other;
    }
    return image;
}

TextureUse read_texture_use(const JsonPlace& owner, std::string_view key, const Model& model) {
    TextureUse use;
    if (!owner.has(key)) return use;
    const JsonPlace place = owner.object(key);
    use.texture = place.required_index("index", model.textures.size());
    use.uv_set = static_cast<int>(place.integer("texCoord", 0, {0, kMaxUvSet}));
    const JsonPlace transform = place.object("extensions").object("KHR_texture_transform");
    use.uv_set = static_cast<int>(transform.integer("texCoord", use.uv_set, {0, kMaxUvSet}));
    transform.numbers("offset", std::span(&use.transform.offset.x, 2));
    transform.numbers("scale", std::span(&use.transform.scale.x, 2));
    use.transform.rotation_degrees = glm::degrees(transform.number("rotation", 0.0f));
    return use;
}

/// Factors beyond what glTF allows are shown as the nearest one that it does.
float factor(const JsonPlace& place, std::string_view key, float fallback, float high = 1.0f) {
    return std::clamp(place.number(key, fallback), 0.0f, high);
}

template <int N>
glm::vec<N, float> factors(const JsonPlace& place, std::string_view key,
                           glm::vec<N, float> fallback, float high = 1.0f) {
    place.numbers(key, std::span(&fallback.x, N));
    return glm::clamp(fallback, 0.0f, high);
}

AlphaMode read_alpha_mode(const JsonPlace& place) {
    const std::string mode = place.text("alphaMode");
    if (mode == "MASK") return AlphaMode::Mask;
    if (mode == "BLEND") return AlphaMode::Blend;
    if (!mode.empty() && mode != "OPAQUE") place.fault("alphaMode", "is not OPAQUE, MASK or BLEND");
    return AlphaMode::Opaque;
}

/// The maps that Patina does not show are checked all the same: a save copies them.
void check_other_maps(const JsonPlace& extensions, const Model& model) {
    struct Map {
        std::string_view extension;
        std::string_view key;
    };
    constexpr std::array kMaps = std::to_array<Map>({
        {"KHR_materials_anisotropy", "anisotropyTexture"},
        {"KHR_materials_clearcoat", "clearcoatTexture"},
        {"KHR_materials_clearcoat", "clearcoatRoughnessTexture"},
        {"KHR_materials_clearcoat", "clearcoatNormalTexture"},
        {"KHR_materials_iridescence", "iridescenceTexture"},
        {"KHR_materials_iridescence", "iridescenceThicknessTexture"},
        {"KHR_materials_pbrSpecularGlossiness", "diffuseTexture"},
        {"KHR_materials_pbrSpecularGlossiness", "specularGlossinessTexture"},
        {"KHR_materials_sheen", "sheenColorTexture"},
        {"KHR_materials_sheen", "sheenRoughnessTexture"},
        {"KHR_materials_specular", "specularTexture"},
        {"KHR_materials_specular", "specularColorTexture"},
        {"KHR_materials_transmission", "transmissionTexture"},
        {"KHR_materials_volume", "thicknessTexture"},
    });
    for (const Map& map : kMaps)
        if (extensions.has(map.extension))
            read_texture_use(extensions.object(map.extension), map.key, model);
}

void read_material_extensions(const JsonPlace& extensions, Material& material) {
    constexpr float kLargest = 1e6f;
    material.unlit = extensions.has("KHR_materials_unlit");
    material.ior = factor(extensions.object("KHR_materials_ior"), "ior", 1.5f, 100.0f);
    const JsonPlace specular = extensions.object("KHR_materials_specular");
    material.specular_factor = factor(specular, "specularFactor", 1.0f);
    material.specular_color_factor =
        factors<3>(specular, "specularColorFactor", glm::vec3(1.0f), kLargest);
    material.emissive_strength = factor(extensions.object("KHR_materials_emissive_strength"),
                                        "emissiveStrength", 1.0f, kLargest);
}

Material read_material(const JsonPlace& place, const Model& model) {
    Material material;
    material.name = place.text("name");
    const JsonPlace pbr = place.object("pbrMetallicRoughness");
    material.base_color_factor = factors<4>(pbr, "baseColorFactor", glm::vec4(1.0f));
    material.base_color = read_texture_use(pbr, "baseColorTexture", model);
    material.metallic_factor = factor(pbr, "metallicFactor", 1.0f);
    material.roughness_factor = factor(pbr, "roughnessFactor", 1.0f);
    material.metallic_roughness = read_texture_use(pbr, "metallicRoughnessTexture", model);
    material.normal = read_texture_use(place, "normalTexture", model);
    material.normal_scale = place.object("normalTexture").number("scale", 1.0f);
    material.occlusion = read_texture_use(place, "occlusionTexture", model);
    material.occlusion_strength = factor(place.object("occlusionTexture"), "strength", 1.0f);
    material.emissive = read_texture_use(place, "emissiveTexture", model);
    material.emissive_factor = factors<3>(place, "emissiveFactor", glm::vec3(0.0f));
    material.alpha_mode = read_alpha_mode(place);
    material.alpha_cutoff = factor(place, "alphaCutoff", 0.5f);
    material.double_sided = place.boolean("doubleSided", false);
    const JsonPlace extensions = place.object("extensions");
    read_material_extensions(extensions, material);
    check_other_maps(extensions, model);
    material.record = place.record_text();
    return material;
}

}  // namespace

void read_textures(const JsonPlace& root, Model& model) {
    for (const JsonPlace& place : root.objects("images")) {
        Image image;
        image.name = place.text("name");
        if (place.has("uri")) image.uri = place.text("uri");
        image.view = place.index("bufferView", model.views.size());
        image.mime_type = place.text("mimeType");
        model.images.push_back(std::move(image));
    }
    for (const JsonPlace& place : root.objects("samplers")) {
        Sampler sampler;
        sampler.wrap_u = read_wrap(place, "wrapS");
        sampler.wrap_v = read_wrap(place, "wrapT");
        sampler.filter =
            place.integer("magFilter", 9729) == 9728 ? Filter::Nearest : Filter::Linear;
        model.samplers.push_back(sampler);
    }
    for (const JsonPlace& place : root.objects("textures")) {
        Texture texture;
        texture.sampler = place.index("sampler", model.samplers.size());
        texture.image = read_texture_image(place, model.images.size());
        model.textures.push_back(texture);
    }
}

void read_materials(const JsonPlace& root, Model& model) {
    for (const JsonPlace& place : root.objects("materials"))
        model.materials.push_back(read_material(place, model));
}

}  // namespace patina::io::gltf
