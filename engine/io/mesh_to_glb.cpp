// SPDX-License-Identifier: MIT
#include "io/mesh_to_glb.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string_view>

#include "core/json.h"

namespace patina::io {
namespace {

// The numbers of the glTF 2.0 specification, 5.1.3 (componentType) and 5.11.5 (target).
constexpr int kFloat = 5126;
constexpr int kUnsignedInt = 5125;
constexpr int kArrayBuffer = 34962;
constexpr int kElementArrayBuffer = 34963;

void append(Bytes& bytes, std::span<const std::byte> more) {
    bytes.insert(bytes.end(), more.begin(), more.end());
}

void append_u32(Bytes& bytes, std::size_t number) {
    const auto word = static_cast<std::uint32_t>(number);
    for (unsigned shift = 0; shift < 32; shift += 8)
        bytes.push_back(static_cast<std::byte>(word >> shift));
}

/// GLB chunks are whole words; JSON is padded with spaces, binary with zeros.
void pad(Bytes& bytes, char filler) {
    while (bytes.size() % 4 != 0) bytes.push_back(static_cast<std::byte>(filler));
}

/// The JSON of the file and its binary chunk, as they grow.
struct GrowingGlb {
    Json json;
    Bytes binary;

    /// Adds an array of numbers as a buffer view with one accessor; returns the accessor's index.
    template <typename T>
    std::size_t add(const std::vector<T>& values, std::string_view type, int component,
                    int target) {
        const auto bytes = std::as_bytes(std::span(values));
        json["bufferViews"].push_back({{"buffer", 0},
                                       {"byteOffset", binary.size()},
                                       {"byteLength", bytes.size()},
                                       {"target", target}});
        append(binary, bytes);
        json["accessors"].push_back({{"bufferView", json["bufferViews"].size() - 1},
                                     {"componentType", component},
                                     {"count", values.size()},
                                     {"type", type}});
        return json["accessors"].size() - 1;
    }
};

Json to_json(glm::vec3 v) {
    return {v.x, v.y, v.z};
}

Json primitive_json(GrowingGlb& parts, const Primitive& primitive) {
    assert(!primitive.positions.empty());
    Json attributes;
    const auto add = [&](const char* name, const auto& values, const char* type) {
        if (values.empty()) return;
        assert(values.size() == primitive.positions.size());
        attributes[name] = parts.add(values, type, kFloat, kArrayBuffer);
    };
    add("POSITION", primitive.positions, "VEC3");
    Bounds bounds;
    for (const glm::vec3& position : primitive.positions) bounds.include(position);
    Json& accessor = parts.json["accessors"].back();
    accessor["min"] = to_json(bounds.low);
    accessor["max"] = to_json(bounds.high);
    add("NORMAL", primitive.normals, "VEC3");
    add("TANGENT", primitive.tangents, "VEC4");
    add("TEXCOORD_0", primitive.uvs[0], "VEC2");
    add("TEXCOORD_1", primitive.uvs[1], "VEC2");
    add("COLOR_0", primitive.colors, "VEC4");
    Json json = {{"attributes", attributes}};
    if (!primitive.indices.empty())
        json["indices"] = parts.add(primitive.indices, "SCALAR", kUnsignedInt, kElementArrayBuffer);
    if (primitive.source_material >= 0) json["material"] = primitive.source_material;
    return json;
}

Json material_json(const PlainMaterial& material) {
    const glm::vec3 color = material.base_color_linear;
    return {{"name", material.name},
            {"pbrMetallicRoughness",
             {{"baseColorFactor", {color.x, color.y, color.z, 1.0f}},
              {"metallicFactor", material.metalness},
              {"roughnessFactor", material.roughness}}}};
}

Bytes assemble(std::string_view json, const Bytes& binary) {
    constexpr std::size_t kHeader = 12;
    constexpr std::size_t kChunkHeader = 8;
    Bytes text;
    append(text, bytes_of(json));
    pad(text, ' ');
    Bytes glb;
    append(glb, bytes_of("glTF"));
    append_u32(glb, 2);
    append_u32(glb, kHeader + kChunkHeader + text.size() + kChunkHeader + binary.size());
    append_u32(glb, text.size());
    append(glb, bytes_of("JSON"));
    append(glb, text);
    append_u32(glb, binary.size());
    append(glb, bytes_of(std::string_view("BIN\0", 4)));
    append(glb, binary);
    return glb;
}

}  // namespace

Bytes mesh_to_glb(const Mesh& mesh, std::span<const PlainMaterial> materials) {
    GrowingGlb parts;
    parts.json = {{"asset", {{"version", "2.0"}, {"generator", "Patina"}}},
                  {"scene", 0},
                  {"scenes", Json::array({{{"name", mesh.name}, {"nodes", {0}}}})},
                  {"nodes", Json::array({{{"name", mesh.name}, {"mesh", 0}}})}};
    Json primitives = Json::array();
    for (const Primitive& primitive : mesh.primitives) {
        assert(primitive.source_material < static_cast<int>(materials.size()));
        primitives.push_back(primitive_json(parts, primitive));
    }
    parts.json["meshes"] = Json::array({{{"name", mesh.name}, {"primitives", primitives}}});
    for (const PlainMaterial& material : materials)
        parts.json["materials"].push_back(material_json(material));
    pad(parts.binary, '\0');
    parts.json["buffers"] = Json::array({{{"byteLength", parts.binary.size()}}});
    return assemble(parts.json.dump(), parts.binary);
}

Bytes shape_to_glb(Shape shape) {
    // In the order of Primitive::source_material.
    const std::array materials = {
        PlainMaterial{.name = "Ball", .roughness = 0.4f},
        PlainMaterial{.name = "Stand", .base_color_linear = glm::vec3(0.06f), .roughness = 0.55f},
    };
    const Mesh mesh = shape_mesh(shape);
    if (mesh.primitives.size() > 1) return mesh_to_glb(mesh, materials);
    PlainMaterial only = materials.front();
    only.name = mesh.name;
    return mesh_to_glb(mesh, std::span(&only, 1));
}

}  // namespace patina::io
