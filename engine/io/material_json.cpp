// SPDX-License-Identifier: MIT
#include "io/material_json.h"

#include <array>

#include "io/texture_use.h"

namespace patina::io {
namespace {

constexpr const char* kUnlit = "KHR_materials_unlit";
constexpr const char* kIor = "KHR_materials_ior";
constexpr const char* kSpecular = "KHR_materials_specular";
constexpr const char* kEmissiveStrength = "KHR_materials_emissive_strength";
constexpr std::array kWrittenExtensions = {kUnlit, kIor, kSpecular, kEmissiveStrength};

struct SlotPlace {
    bool in_metallic_roughness;  ///< inside pbrMetallicRoughness
    const char* texture;
};
constexpr std::array<SlotPlace, kSlotCount> kPlaces = {{
    {true, "baseColorTexture"},
    {true, "metallicRoughnessTexture"},
    {false, "normalTexture"},
    {false, "occlusionTexture"},
    {false, "emissiveTexture"},
}};
const SlotPlace& place_of(Slot slot) {
    return kPlaces[static_cast<std::size_t>(slot)];
}

/// Sets a member, or leaves it away where it is absent and at its default.
void state(Json& object, const char* key, Json value, const Json& if_absent) {
    if (object.contains(key) || value != if_absent) object[key] = std::move(value);
}
void state_factor(Json& object, const char* key, float value) {
    state(object, key, json_number(value), 1);
}
Json json_numbers(const glm::vec3& v) {
    return {json_number(v.x), json_number(v.y), json_number(v.z)};
}
Json json_numbers(const glm::vec2& v) {
    return {json_number(v.x), json_number(v.y)};
}

/// The object that is a member; made where it is absent or of another kind.
Json& object_at(Json& json, const char* key) {
    Json& member = json[key];
    if (!member.is_object()) member = Json::object();
    return member;
}

void erase_if_empty(Json& json, const char* key) {
    const auto found = json.find(key);
    if (found != json.end() && found->empty()) json.erase(key);
}

void state_transform(Json& info, const UvTransform& transform) {
    if (info.contains("extensions") && info["extensions"].is_object()) {
        info["extensions"].erase(kTextureTransform);
        erase_if_empty(info, "extensions");
    }
    if (transform == UvTransform{}) return;
    Json& json = object_at(info, "extensions")[kTextureTransform];
    json = Json::object();
    state(json, "offset", json_numbers(transform.offset), json_numbers(glm::vec2(0.0f)));
    state(json, "rotation", json_number(glm::radians(transform.rotation_degrees)), 0);
    state(json, "scale", json_numbers(transform.scale), json_numbers(glm::vec2(1.0f)));
}

void state_texture(Json& parent, const char* key, const std::optional<StatedTexture>& texture) {
    if (!texture) {
        parent.erase(key);
        return;
    }
    Json& info = object_at(parent, key);
    info["index"] = texture->texture;
    state(info, "texCoord", texture->uv_set, 0);
    state_transform(info, texture->transform);
}

/// Sets a member of an extension of the material.
void state_in_extension(Json& material, const char* extension, const char* key, Json value) {
    object_at(object_at(material, "extensions"), extension)[key] = std::move(value);
}

const char* alpha_mode_id(AlphaMode mode) {
    switch (mode) {
        case AlphaMode::Opaque:
            return "OPAQUE";
        case AlphaMode::Mask:
            return "MASK";
        case AlphaMode::Blend:
            return "BLEND";
    }
    return "OPAQUE";
}

void state_alpha(Json& material, const Material& now, const Material& before) {
    if (now.alpha_mode != before.alpha_mode)
        state(material, "alphaMode", alpha_mode_id(now.alpha_mode), "OPAQUE");
    if (now.alpha_mode == before.alpha_mode && now.alpha_cutoff == before.alpha_cutoff) return;
    // Only alpha mode MASK may have a cutoff.
    if (now.alpha_mode == AlphaMode::Mask)
        state(material, "alphaCutoff", json_number(now.alpha_cutoff), 0.5);
    else
        material.erase("alphaCutoff");
}

void state_unlit(Json& material, bool unlit) {
    if (unlit) {
        object_at(object_at(material, "extensions"), kUnlit);
    } else if (material.contains("extensions")) {
        material["extensions"].erase(kUnlit);
        erase_if_empty(material, "extensions");
    }
}

}  // namespace

void state_slot(Json& material, Slot slot, const SlotStatement& statement) {
    const SlotPlace& place = place_of(slot);
    Json& parent =
        place.in_metallic_roughness ? object_at(material, "pbrMetallicRoughness") : material;
    state_texture(parent, place.texture, statement.texture);
    const glm::vec4& factor = statement.factor;
    switch (slot) {
        case Slot::BaseColor: {
            Json rgba = json_numbers(glm::vec3(factor));
            rgba.push_back(json_number(factor.w));
            state(parent, "baseColorFactor", std::move(rgba), {1, 1, 1, 1});
            break;
        }
        case Slot::MetallicRoughness:
            state_factor(parent, "metallicFactor", factor.z);
            state_factor(parent, "roughnessFactor", factor.y);
            break;
        case Slot::Normal:
            if (statement.texture) state_factor(parent[place.texture], "scale", factor.x);
            break;
        case Slot::Occlusion:
            if (statement.texture) state_factor(parent[place.texture], "strength", factor.x);
            break;
        case Slot::Emissive:
            state(parent, "emissiveFactor", json_numbers(glm::vec3(factor)), {0, 0, 0});
            break;
    }
    if (place.in_metallic_roughness) erase_if_empty(material, "pbrMetallicRoughness");
}

int slot_texture(const Json& material, Slot slot) {
    const SlotPlace& place = place_of(slot);
    const Json* parent = &material;
    if (place.in_metallic_roughness) {
        const auto found = material.find("pbrMetallicRoughness");
        if (found == material.end() || !found->is_object()) return -1;
        parent = &*found;
    }
    const auto info = parent->find(place.texture);
    return info == parent->end() ? -1 : index_at(*info, "index");
}

void state_settings(Json& material, const Material& now, const Material* before) {
    static const Material kDefaults;
    const Material& old = before ? *before : kDefaults;
    if (now.name != old.name) state(material, "name", now.name, "");
    state_alpha(material, now, old);
    if (now.double_sided != old.double_sided)
        state(material, "doubleSided", now.double_sided, false);
    if (now.unlit != old.unlit) state_unlit(material, now.unlit);
    if (now.ior != old.ior) state_in_extension(material, kIor, "ior", json_number(now.ior));
    if (now.specular_factor != old.specular_factor)
        state_in_extension(material, kSpecular, "specularFactor", json_number(now.specular_factor));
    if (now.specular_color_linear != old.specular_color_linear)
        state_in_extension(material, kSpecular, "specularColorFactor",
                           json_numbers(now.specular_color_linear));
    if (now.emissive_strength != old.emissive_strength)
        state_in_extension(material, kEmissiveStrength, "emissiveStrength",
                           json_number(now.emissive_strength));
}

void list_extensions(GltfJson& gltf, const Json& material) {
    Json copy = material;
    for_each_member(copy, [&](const std::string& key, const Json&) {
        if (key == kTextureTransform) gltf.use_extension(key);
        for (const char* written : kWrittenExtensions)
            if (key == written) gltf.use_extension(key);
    });
}

}  // namespace patina::io
