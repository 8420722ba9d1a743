// SPDX-License-Identifier: MIT
// Puts a checked JSON in front of tinygltf. tinygltf reads bytes while it parses, refuses some
// files that are valid and misreads others without a word, so it gets the members that Patina shows
// in the one form that it reads right, and what it must not touch is put back into its model.
#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/json.h"
#include "io/gltf_model.h"
#include "io/texture_use.h"

namespace patina::io {
namespace {

using Keys = std::span<const std::string_view>;

constexpr std::uint64_t kModelBytes = std::uint64_t{1} << 30;

/// The members of the items of an array, beside names, that Patina shows.
struct KnownArray {
    std::string_view name;
    std::size_t item_bytes;  ///< that tinygltf takes for one
    std::array<std::string_view, 10> keys;
};
constexpr auto kArrays = std::to_array<KnownArray>({
    {"accessors",
     sizeof(tinygltf::Accessor),
     {"bufferView", "byteOffset", "componentType", "normalized", "count", "type", "sparse"}},
    {"bufferViews",
     sizeof(tinygltf::BufferView),
     {"buffer", "byteOffset", "byteLength", "byteStride"}},
    {"buffers", sizeof(tinygltf::Buffer), {"uri", "byteLength"}},
    {"cameras", sizeof(tinygltf::Camera), {"type", "perspective", "orthographic"}},
    {"images", sizeof(tinygltf::Image), {"uri", "bufferView"}},
    {"materials",
     sizeof(tinygltf::Material),
     {"pbrMetallicRoughness", "normalTexture", "occlusionTexture", "emissiveTexture",
      "emissiveFactor", "alphaMode", "alphaCutoff", "doubleSided", "extensions", "extras"}},
    {"meshes", sizeof(tinygltf::Mesh), {"primitives", "weights"}},
    {"nodes",
     sizeof(tinygltf::Node),
     {"mesh", "skin", "camera", "children", "matrix", "translation", "rotation", "scale", "weights",
      "extensions"}},
    {"samplers", sizeof(tinygltf::Sampler), {"wrapS", "wrapT", "magFilter"}},
    {"scenes", sizeof(tinygltf::Scene), {"nodes", "extras"}},
    {"skins", sizeof(tinygltf::Skin), {"inverseBindMatrices", "joints"}},
    {"textures", sizeof(tinygltf::Texture), {"sampler", "source", "extensions"}},
});
constexpr auto kRootKeys = std::to_array<std::string_view>({"asset", "scene", "extensions"});
constexpr auto kPrimitiveKeys =
    std::to_array<std::string_view>({"attributes", "indices", "material", "mode", "targets"});
constexpr auto kExtensions = std::to_array<std::string_view>(
    {"EXT_texture_avif", "EXT_texture_webp", "KHR_lights_punctual",
     "KHR_materials_emissive_strength", "KHR_materials_ior", "KHR_materials_pbrSpecularGlossiness",
     "KHR_materials_specular", "KHR_materials_unlit", "KHR_texture_basisu", "KHR_texture_transform",
     "MSFT_texture_dds"});

/// Visits the items of an array that is a member, where it is there.
template <typename Object, typename Visit>
void for_each_item(Object& json, std::string_view key, const Visit& visit) {
    if (const auto items = json.find(key); items != json.end())
        for (auto& item : *items) visit(item);
}

template <typename Wanted>
void keep_members(SortedJson& object, const Wanted& wanted) {
    for (auto member = object.begin(); member != object.end();)
        member = wanted(std::string_view(member.key())) ? std::next(member) : object.erase(member);
}

bool among(Keys keys, std::string_view key) {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
}

/// tinygltf takes only whole numbers without a point for integers, and only numbers with one for
/// more than 32 bits in extensions. Extensions that nothing reads go, at any depth.
void settle_numbers(SortedJson& json, bool in_extension) {
    if (json.is_object()) {
        for (auto& [key, value] : json.items()) {
            const bool opens = key == "extensions" && value.is_object();
            if (opens)
                keep_members(value, [](std::string_view name) { return among(kExtensions, name); });
            settle_numbers(value, in_extension || opens);
        }
    } else if (json.is_array()) {
        for (SortedJson& element : json) settle_numbers(element, in_extension);
    } else if (in_extension && json.is_number()) {
        json = json.get<double>();
    } else if (json.is_number_float()) {
        const double number = json.get<double>();
        if (number == std::floor(number) && std::abs(number) <= 9007199254740992.0 &&
            !std::signbit(number))
            json = static_cast<std::uint64_t>(number);
    }
}

/// Of extras, only a record of Patina's; they may be anything, and tinygltf copies them all.
void keep_record(SortedJson& item) {
    const auto extras = item.find("extras");
    if (extras == item.end()) return;
    const auto record = extras->is_object() ? extras->find("patina") : extras->end();
    if (extras->is_object() && record != extras->end() && record->is_string())
        keep_members(*extras, [](std::string_view key) { return key == "patina"; });
    else
        item.erase("extras");
}

void keep_known_members(SortedJson& json) {
    keep_members(json, [](std::string_view key) {
        return among(kRootKeys, key) ||
               std::any_of(kArrays.begin(), kArrays.end(),
                           [&](const KnownArray& array) { return array.name == key; });
    });
    keep_members(json["asset"], [](std::string_view key) { return key == "version"; });
    for (const KnownArray& array : kArrays)
        for_each_item(json, array.name, [&](SortedJson& item) {
            keep_members(item, [&](std::string_view key) {
                return key == "name" || among(array.keys, key);
            });
            keep_record(item);
        });
}

/// What tinygltf will take, before it takes it. A list of empty objects grows a thousandfold.
Status check_model_bytes(const SortedJson& json) {
    std::uint64_t bytes = 0;
    for (const KnownArray& array : kArrays)
        for_each_item(json, array.name, [&](const SortedJson&) { bytes += array.item_bytes; });
    for_each_item(json, "meshes", [&](const SortedJson& mesh) {
        for_each_item(mesh, "primitives",
                      [&](const SortedJson&) { bytes += sizeof(tinygltf::Primitive); });
    });
    if (bytes <= kModelBytes) return {};
    return failure("the lists of the model need more than the limit of {} MiB; simplify the model",
                   kModelBytes >> 20);
}

/// What tinygltf must not see as it is, by item.
struct HeldBack {
    struct Image {
        std::string uri;
        int view = -1;
    };
    std::vector<std::string> buffer_uris;
    std::vector<std::size_t> strides;
    std::vector<Image> images;
    std::vector<int> indices;  ///< of all primitives, in their order
};

template <typename T>
T taken(SortedJson& object, const char* key, T fallback) {
    const auto member = object.find(key);
    if (member == object.end()) return fallback;
    T value = member->get<T>();
    object.erase(member);
    return value;
}

void hold_back_primitive(SortedJson& primitive, HeldBack& held) {
    keep_members(primitive, [](std::string_view key) { return among(kPrimitiveKeys, key); });
    // tinygltf drops a primitive without attributes, and refuses indices that are all sparse.
    if (!primitive.contains("attributes")) primitive["attributes"] = SortedJson::object();
    held.indices.push_back(taken(primitive, "indices", -1));
}

HeldBack hold_back(SortedJson& json) {
    HeldBack held;
    for_each_item(json, "buffers", [&](SortedJson& buffer) {
        held.buffer_uris.push_back(taken(buffer, "uri", std::string()));
        buffer["uri"] = "data:application/octet-stream;base64,AA==";
        buffer["byteLength"] = 1;
    });
    for_each_item(json, "bufferViews", [&](SortedJson& view) {
        held.strides.push_back(taken(view, "byteStride", std::size_t{0}));
    });
    for_each_item(json, "images", [&](SortedJson& image) {
        std::string uri = taken(image, "uri", std::string());
        held.images.push_back({std::move(uri), taken(image, "bufferView", -1)});
        image["uri"] = "-";
    });
    for_each_item(json, "meshes", [&](SortedJson& mesh) {
        for_each_item(mesh, "primitives",
                      [&](SortedJson& primitive) { hold_back_primitive(primitive, held); });
    });
    return held;
}

void set_missing_numbers(SortedJson& object, std::initializer_list<const char*> keys, int value) {
    for (const char* key : keys)
        if (!object.contains(key) || !object[key].is_number()) object[key] = value;
}

/// A camera or a light that lacks what tinygltf insists on gets it.
void complete_views(SortedJson& json) {
    for_each_item(json, "cameras", [](SortedJson& camera) {
        if (camera.value("type", "") == "orthographic")
            return set_missing_numbers(camera["orthographic"], {"xmag", "ymag", "zfar", "znear"},
                                       1);
        camera["type"] = "perspective";
        set_missing_numbers(camera["perspective"], {"yfov", "znear"}, 0);
    });
    if (!json.contains("extensions") || !json["extensions"].contains("KHR_lights_punctual")) return;
    for_each_item(json["extensions"]["KHR_lights_punctual"], "lights", [](SortedJson& light) {
        light.erase("extras");
        if (light["type"] == "spot" && !light.contains("spot"))
            light["spot"] = SortedJson::object();
    });
}

bool put_back(HeldBack held, tinygltf::Model& model) {
    if (model.buffers.size() != held.buffer_uris.size() ||
        model.bufferViews.size() != held.strides.size() ||
        model.images.size() != held.images.size())
        return false;
    for (std::size_t i = 0; i < model.buffers.size(); ++i) {
        model.buffers[i].uri = std::move(held.buffer_uris[i]);
        model.buffers[i].data.clear();
    }
    for (std::size_t i = 0; i < model.bufferViews.size(); ++i)
        model.bufferViews[i].byteStride = held.strides[i];
    for (std::size_t i = 0; i < model.images.size(); ++i) {
        model.images[i].uri = std::move(held.images[i].uri);
        model.images[i].bufferView = held.images[i].view;
    }
    auto indices = held.indices.begin();
    for (tinygltf::Mesh& mesh : model.meshes)
        for (tinygltf::Primitive& primitive : mesh.primitives) {
            if (indices == held.indices.end()) return false;
            primitive.indices = *indices++;
        }
    return indices == held.indices.end();
}

bool has_all_items(const SortedJson& json, const tinygltf::Model& model) {
    const auto has = [&](const char* key, std::size_t count) {
        const auto items = json.find(key);
        return (items == json.end() ? 0 : items->size()) == count;
    };
    return has("accessors", model.accessors.size()) && has("cameras", model.cameras.size()) &&
           has("materials", model.materials.size()) && has("meshes", model.meshes.size()) &&
           has("nodes", model.nodes.size()) && has("samplers", model.samplers.size()) &&
           has("scenes", model.scenes.size()) && has("skins", model.skins.size()) &&
           has("textures", model.textures.size());
}

/// Never called while images have no data of their own; tinygltf wants it to be there.
bool refuse_image(tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*,
                  int, void*) {
    return false;
}

Status run_tinygltf(const std::string& text, tinygltf::Model& model) try {
    if (text.size() > std::numeric_limits<unsigned>::max())
        return failure("the JSON is larger than 4 GiB; simplify the model");
    tinygltf::TinyGLTF loader;
    loader.SetImageLoader(refuse_image, nullptr);
    std::string error;
    std::string warning;
    if (loader.LoadASCIIFromString(&model, &error, &warning, text.c_str(),
                                   static_cast<unsigned>(text.size()), ""))
        return {};
    return failure("tinygltf refuses it ({})", quoted_for_message(error, 200));
} catch (const std::bad_alloc&) {
    throw;  // load.h has a line for it
} catch (const std::exception& exception) {
    return failure("tinygltf refuses it ({})", quoted_for_message(exception.what(), 200));
}

}  // namespace

Result<tinygltf::Model> parse_gltf(SortedJson json) {
    if (const auto fits = check_model_bytes(json); !fits) return passed_on(fits);
    keep_known_members(json);
    settle_numbers(json, false);
    HeldBack held = hold_back(json);
    complete_views(json);
    tinygltf::Model model;
    if (const auto parsed = run_tinygltf(json.dump(), model); !parsed) return passed_on(parsed);
    if (!has_all_items(json, model) || !put_back(std::move(held), model))
        return failure("tinygltf lost a part of the model");
    if (model.defaultScene < 0 && !model.scenes.empty()) model.defaultScene = 0;
    return model;
}

}  // namespace patina::io
