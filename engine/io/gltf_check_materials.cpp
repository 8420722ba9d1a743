// SPDX-License-Identifier: MIT
#include <array>

#include "document/material.h"
#include "io/gltf_check.h"
#include "io/texture_use.h"

namespace patina::io {
namespace {

void check_wrap(const JsonPlace& place, std::string_view key) {
    const std::int64_t wrap = place.integer(key, 10497);
    if (wrap != 10497 && wrap != 33648 && wrap != 33071)
        place.fault(key, "is not a wrap mode of glTF");
}

/// The image that a texture shows: its own, or one in a format that an extension adds.
void check_texture_image(const JsonPlace& place, std::size_t images) {
    place.index("source", images);
    const JsonPlace extensions = place.object("extensions");
    for (const char* format : kImageFormatExtensions)
        if (extensions.has(format)) extensions.object(format).index("source", images);
}

void check_texture_use(const JsonPlace& owner, std::string_view key, std::size_t textures) {
    if (!owner.has(key)) return;
    const JsonPlace place = owner.object(key);
    place.required_index("index", textures);
    place.integer("texCoord", 0, {0, kMaxUvSet});
    place.number("scale", 1.0f);
    place.number("strength", 1.0f);
    const JsonPlace transform = place.object("extensions").object("KHR_texture_transform");
    transform.integer("texCoord", 0, {0, kMaxUvSet});
    std::array<float, 2> pair{};
    transform.numbers("offset", pair);
    transform.numbers("scale", pair);
    transform.number("rotation", 0.0f);
}

void check_alpha_mode(const JsonPlace& place) {
    const std::string mode = place.text("alphaMode");
    if (!mode.empty() && mode != "OPAQUE" && mode != "MASK" && mode != "BLEND")
        place.fault("alphaMode", "is not OPAQUE, MASK or BLEND");
}

/// The maps that Patina does not show are checked all the same: a save copies them.
void check_extension_maps(const JsonPlace& extensions, std::size_t textures) {
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
            check_texture_use(extensions.object(map.extension), map.key, textures);
}

void check_extension_factors(const JsonPlace& extensions) {
    std::array<float, 4> numbers{};
    const std::span<float> all(numbers);
    extensions.object("KHR_materials_unlit");
    extensions.object("KHR_materials_ior").number("ior", 1.5f);
    const JsonPlace specular = extensions.object("KHR_materials_specular");
    specular.number("specularFactor", 1.0f);
    specular.numbers("specularColorFactor", all.first(3));
    extensions.object("KHR_materials_emissive_strength").number("emissiveStrength", 1.0f);
    const JsonPlace glossiness = extensions.object("KHR_materials_pbrSpecularGlossiness");
    glossiness.numbers("diffuseFactor", all);
    glossiness.numbers("specularFactor", all.first(3));
    glossiness.number("glossinessFactor", 1.0f);
}

void check_material(const JsonPlace& place, std::size_t textures) {
    std::array<float, 4> numbers{};
    const std::span<float> all(numbers);
    place.text("name");
    const JsonPlace pbr = place.object("pbrMetallicRoughness");
    pbr.numbers("baseColorFactor", all);
    pbr.number("metallicFactor", 1.0f);
    pbr.number("roughnessFactor", 1.0f);
    check_texture_use(pbr, "baseColorTexture", textures);
    check_texture_use(pbr, "metallicRoughnessTexture", textures);
    for (const std::string_view key : {"normalTexture", "occlusionTexture", "emissiveTexture"})
        check_texture_use(place, key, textures);
    place.numbers("emissiveFactor", all.first(3));
    check_alpha_mode(place);
    place.number("alphaCutoff", 0.5f);
    place.boolean("doubleSided", false);
    const JsonPlace extensions = place.object("extensions");
    check_extension_factors(extensions);
    check_extension_maps(extensions, textures);
}

}  // namespace

void check_textures(const JsonPlace& root, const CheckedGltf& checked) {
    for (const JsonPlace& place : root.objects("images")) {
        place.text("name");
        place.text("mimeType");
        if (place.has("uri") && place.text("uri").empty()) place.fault("uri", "is empty");
        place.index("bufferView", checked.views.size());
    }
    for (const JsonPlace& place : root.objects("samplers")) {
        check_wrap(place, "wrapS");
        check_wrap(place, "wrapT");
        place.integer("magFilter", 9729);
    }
    for (const JsonPlace& place : root.objects("textures")) {
        place.index("sampler", root.array_size("samplers"));
        check_texture_image(place, root.array_size("images"));
    }
}

void check_materials(const JsonPlace& root) {
    const std::size_t textures = root.array_size("textures");
    if (root.array_size("materials") > std::size_t{kFirstAddedMaterial})
        return root.fault("materials",
                          fmt::format("are {}, more than the limit of {}",
                                      root.array_size("materials"), kFirstAddedMaterial));
    for (const JsonPlace& place : root.objects("materials")) check_material(place, textures);
}

}  // namespace patina::io
