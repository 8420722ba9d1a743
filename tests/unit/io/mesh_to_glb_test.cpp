// SPDX-License-Identifier: MIT
#include "io/mesh_to_glb.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <nlohmann/json.hpp>

#include "sample_gltf.h"
#include "scene/shapes.h"

namespace patina::io {
namespace {

using test::word_at;

const std::array kMaterials = {
    PlainMaterial{.name = "Ball", .base_color_linear = {0.25f, 0.5f, 1.0f}, .roughness = 0.25f},
    PlainMaterial{.name = "Stand", .metalness = 1.0f},
};

struct OpenedGlb {
    nlohmann::json json;
    std::span<const std::byte> binary;
};

OpenedGlb opened(const Bytes& glb) {
    const std::uint32_t json_length = word_at(glb, 12);
    const auto* text = reinterpret_cast<const char*>(glb.data() + 20);
    return {nlohmann::json::parse(text, text + json_length),
            std::span(glb).subspan(20 + json_length + 8)};
}

TEST(MeshToGlb, HasTheHeaderAndTheLengthsOfTheContainer) {
    const Bytes glb = mesh_to_glb(shape_mesh(Shape::ShaderBall), kMaterials);
    EXPECT_EQ(std::memcmp(glb.data(), "glTF", 4), 0);
    EXPECT_EQ(word_at(glb, 4), 2u);
    EXPECT_EQ(word_at(glb, 8), glb.size());
    const std::size_t second = 20 + word_at(glb, 12);
    EXPECT_EQ(std::memcmp(glb.data() + 16, "JSON", 4), 0);
    EXPECT_EQ(std::memcmp(glb.data() + second + 4, "BIN\0", 4), 0);
    EXPECT_EQ(second % 4, 0u);
    EXPECT_EQ(second + 8 + word_at(glb, second), glb.size());
}

TEST(MeshToGlb, KeepsEveryNumberOfTheMesh) {
    const Mesh mesh = shape_mesh(Shape::ShaderBall);
    const Bytes glb = mesh_to_glb(mesh, kMaterials);
    const auto [json, binary] = opened(glb);
    const auto expect_same = [&json = json, &binary = binary](const nlohmann::json& accessor_index,
                                                              const auto& values) {
        const auto& accessor = json["accessors"][accessor_index.get<std::size_t>()];
        const auto& view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
        ASSERT_EQ(accessor["count"], values.size());
        const auto bytes = std::as_bytes(std::span(values));
        ASSERT_EQ(view["byteLength"], bytes.size());
        const auto stored = binary.subspan(view["byteOffset"].get<std::size_t>(), bytes.size());
        EXPECT_TRUE(std::equal(bytes.begin(), bytes.end(), stored.begin()));
    };
    const auto& primitives = json["meshes"][0]["primitives"];
    ASSERT_EQ(primitives.size(), mesh.primitives.size());
    for (std::size_t i = 0; i < mesh.primitives.size(); ++i) {
        const auto& attributes = primitives[i]["attributes"];
        expect_same(attributes["POSITION"], mesh.primitives[i].positions);
        expect_same(attributes["NORMAL"], mesh.primitives[i].normals);
        expect_same(attributes["TANGENT"], mesh.primitives[i].tangents);
        expect_same(attributes["TEXCOORD_0"], mesh.primitives[i].uvs[0]);
        expect_same(primitives[i]["indices"], mesh.primitives[i].indices);
        EXPECT_FALSE(attributes.contains("COLOR_0"));
        EXPECT_EQ(primitives[i]["material"], i);
    }
    EXPECT_EQ(json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"][2], 1.0f);
    EXPECT_EQ(json["materials"][1]["name"], "Stand");
}

TEST(MeshToGlb, GivesEqualBytesForEqualMeshes) {
    EXPECT_EQ(mesh_to_glb(shape_mesh(Shape::Torus), kMaterials),
              mesh_to_glb(shape_mesh(Shape::Torus), kMaterials));
}

}  // namespace
}  // namespace patina::io
