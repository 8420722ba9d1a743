// SPDX-License-Identifier: MIT
// Each guard of gltf_check.h: a valid file with one thing wrong is refused with one line that names
// the JSON pointer.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/json.h"
#include "io/load.h"
#include "sample_gltf.h"

namespace patina::io {
namespace {

using testing::HasSubstr;

TEST(GltfGuards, LetAFileThatHoldsOneOfEverythingPass) {
    const auto sample = test::sample_gltf();
    const auto loaded = test::load_from(sample.json, sample.binary);
    ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
    EXPECT_TRUE(loaded->warnings.empty()) << loaded->warnings.front();
}

struct Breach {
    const char* pointer;  ///< of the member that is replaced or added
    SortedJson value;
    const char* named;  ///< what the message must contain
};

class GltfBreach : public testing::TestWithParam<Breach> {};

TEST_P(GltfBreach, IsRefusedWithOneLineThatNamesThePlace) {
    auto sample = test::sample_gltf();
    sample.json[SortedJson::json_pointer(GetParam().pointer)] = GetParam().value;
    const auto loaded = test::load_from(sample.json, sample.binary);
    ASSERT_FALSE(loaded.has_value());
    const std::string& message = loaded.error().message;
    EXPECT_THAT(message, testing::StartsWith("model.glb: "));
    EXPECT_THAT(message, HasSubstr(GetParam().named));
    EXPECT_THAT(message, HasSubstr("; "));  // what to do
    EXPECT_EQ(message.find('\n'), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(
    Indices, GltfBreach,
    testing::Values(
        Breach{"/scene", 1, "/scene: is 1"}, Breach{"/scene", -1, "/scene"},
        Breach{"/scene", 0.5, "/scene"}, Breach{"/scene", "0", "/scene"},
        Breach{"/scenes/0/nodes", {0, 3}, "/scenes/0/nodes"},
        Breach{"/scenes/0/nodes", {0, 0}, "/scenes/0/nodes"},
        Breach{"/scenes/0/nodes", {0, 1}, "/scenes/0/nodes"},
        Breach{"/nodes/0/children", {7}, "/nodes/0/children"},
        Breach{"/nodes/0/children", {-1}, "/nodes/0/children"},
        Breach{"/nodes/0/mesh", 1, "/nodes/0/mesh"}, Breach{"/nodes/0/skin", 1, "/nodes/0/skin"},
        Breach{"/nodes/1/camera", 1, "/nodes/1/camera"},
        Breach{"/nodes/1/extensions/KHR_lights_punctual/light", 1,
               "/nodes/1/extensions/KHR_lights_punctual/light"},
        Breach{"/skins/0/joints", {3}, "/skins/0/joints"},
        Breach{"/skins/0/skeleton", 3, "/skins/0/skeleton"},
        Breach{"/skins/0/inverseBindMatrices", 99, "/skins/0/inverseBindMatrices"},
        Breach{"/animations/0/samplers/0/input", 99, "/animations/0/samplers/0/input"},
        Breach{"/animations/0/samplers/0/output", -2, "/animations/0/samplers/0/output"},
        Breach{"/animations/0/channels/0/sampler", 1, "/animations/0/channels/0/sampler"},
        Breach{"/animations/0/channels/0/target/node", 3, "/animations/0/channels/0/target/node"},
        Breach{"/meshes/0/primitives/0/attributes/POSITION", 99,
               "/meshes/0/primitives/0/attributes/POSITION"},
        Breach{"/meshes/0/primitives/0/indices", 99, "/meshes/0/primitives/0/indices"},
        Breach{"/meshes/0/primitives/0/material", 1, "/meshes/0/primitives/0/material"},
        Breach{"/meshes/0/primitives/0/targets/0/POSITION", 99,
               "/meshes/0/primitives/0/targets/0/POSITION"},
        Breach{"/meshes/0/primitives/0/extensions/KHR_materials_variants/mappings/0/variants",
               {1},
               "/meshes/0/primitives/0/extensions/KHR_materials_variants/mappings/0/variants"},
        Breach{"/accessors/0/bufferView", 99, "/accessors/0/bufferView"},
        Breach{"/accessors/7/sparse/indices/bufferView", 99,
               "/accessors/7/sparse/indices/bufferView"},
        Breach{"/accessors/7/sparse/values/bufferView", 99,
               "/accessors/7/sparse/values/bufferView"},
        Breach{"/bufferViews/0/buffer", 1, "/bufferViews/0/buffer"},
        Breach{"/images/0/bufferView", 99, "/images/0/bufferView"},
        Breach{"/textures/0/source", 1, "/textures/0/source"},
        Breach{"/textures/0/sampler", 1, "/textures/0/sampler"},
        Breach{"/materials/0/normalTexture/index", 1, "/materials/0/normalTexture/index"},
        Breach{"/materials/0/pbrMetallicRoughness/baseColorTexture/index", 4294967296,
               "/materials/0/pbrMetallicRoughness/baseColorTexture/index"},
        Breach{"/materials/0/extensions/KHR_materials_clearcoat/clearcoatTexture/index", 5,
               "/materials/0/extensions/KHR_materials_clearcoat/clearcoatTexture/index"}));

INSTANTIATE_TEST_SUITE_P(
    Extents, GltfBreach,
    testing::Values(
        Breach{"/accessors/0/count", 4, "/accessors/0"},
        Breach{"/accessors/0/count", 0, "/accessors/0/count"},
        Breach{"/accessors/0/count", -1, "/accessors/0/count"},
        Breach{"/accessors/0/count", 4294967296, "/accessors/0/count"},
        Breach{"/accessors/0/byteOffset", 4, "/accessors/0"},
        Breach{"/accessors/0/byteOffset", -4, "/accessors/0/byteOffset"},
        Breach{"/accessors/0/byteOffset", 9007199254740991, "/accessors/0"},
        Breach{"/accessors/0/byteOffset", 18446744073709551615u, "/accessors/0/byteOffset"},
        Breach{"/accessors/0/componentType", 5124, "/accessors/0/componentType"},
        Breach{"/accessors/0/type", "VEC5", "/accessors/0/type"},
        Breach{"/accessors/6/count", 2, "/accessors/6"},
        Breach{"/bufferViews/0/byteLength", 0, "/bufferViews/0/byteLength"},
        Breach{"/bufferViews/0/byteLength", 1000000, "/bufferViews/0"},
        Breach{"/bufferViews/0/byteOffset", 1000000, "/bufferViews/0"},
        Breach{"/bufferViews/0/byteStride", 4, "/accessors/0/bufferView"},
        Breach{"/bufferViews/0/byteStride", 1000, "/bufferViews/0/byteStride"},
        Breach{"/bufferViews/0/byteStride", -4, "/bufferViews/0/byteStride"},
        Breach{"/buffers/0/byteLength", 100000, "/buffers/0"},
        Breach{"/buffers/0/byteLength", -1, "/buffers/0/byteLength"},
        Breach{"/accessors/7/sparse/count", 3, "/accessors/7/sparse"},
        Breach{"/accessors/7/sparse/count", 4, "/accessors/7/sparse/count"},
        Breach{"/accessors/7/sparse/count", 0, "/accessors/7/sparse/count"},
        Breach{"/accessors/7/sparse/indices/byteOffset", 2, "/accessors/7/sparse/indices"},
        Breach{"/accessors/7/sparse/indices/componentType", 5126,
               "/accessors/7/sparse/indices/componentType"},
        Breach{"/meshes/0/primitives/0/attributes/NORMAL", 6, "/meshes/0/primitives/0/attributes"},
        Breach{"/meshes/0/primitives/0/attributes/NORMAL", 2,
               "/meshes/0/primitives/0/attributes/NORMAL"},
        Breach{"/meshes/0/primitives/0/targets/0/POSITION", 6, "/meshes/0/primitives/0/targets/0"},
        Breach{"/meshes/0/primitives/0/indices", 0, "/meshes/0/primitives/0/indices"},
        Breach{"/meshes/0/primitives/0/mode", 7, "/meshes/0/primitives/0/mode"},
        Breach{"/skins/0/joints", {0, 2}, "/skins/0/inverseBindMatrices"},
        Breach{"/skins/0/joints", SortedJson::array(), "/skins/0/joints"}));

INSTANTIATE_TEST_SUITE_P(
    TreesAndVersions, GltfBreach,
    testing::Values(
        Breach{"/nodes/1/children", {0}, "/nodes"},  // a cycle of two
        Breach{"/nodes/2/children", {2}, "/nodes"},  // its own child
        Breach{"/nodes/2/children", {1}, "/nodes: node 1 is a child of both"},
        Breach{"/nodes/2/children", {1, 1}, "/nodes"},
        Breach{"/nodes/0/matrix", {1, 2, 3}, "/nodes/0/matrix"},
        Breach{"/nodes/0/translation", {1e39, 0, 0}, "/nodes/0/translation"},
        Breach{"/nodes/0/translation", {"1", 0, 0}, "/nodes/0/translation"},
        Breach{"/nodes/0/children", {{"a", 1}}, "/nodes/0/children"},
        Breach{"/nodes/0", 3, "/nodes/0: must be an object"},
        Breach{"/nodes", "many", "/nodes: must be an array"},
        Breach{"/asset/version", "1.0", "/asset/version"},
        Breach{"/asset/version", "2.0 ", "/asset/version"},
        Breach{"/asset/version", 2, "/asset/version"},
        Breach{"/asset/minVersion", "2.1", "/asset/minVersion"},
        Breach{"/asset", SortedJson::array(), "/asset"},
        Breach{"/extensionsRequired", {"KHR_draco_mesh_compression"}, "KHR_draco_mesh_compression"},
        Breach{"/extensionsRequired", {"EXT_meshopt_compression"}, "EXT_meshopt_compression"},
        Breach{"/extensionsRequired", {"KHR_texture_basisu"}, "KHR_texture_basisu"},
        Breach{"/extensionsRequired", {"EVIL_\x1b[31m"}, "EVIL_\\x1b[31m"},
        Breach{"/samplers/0/wrapS", 1, "/samplers/0/wrapS"},
        Breach{"/materials/0/alphaMode", "SOLID", "/materials/0/alphaMode"},
        Breach{"/materials/0/pbrMetallicRoughness", 1, "/materials/0/pbrMetallicRoughness"},
        Breach{"/extensions/KHR_lights_punctual/lights/0/type", "sun",
               "/extensions/KHR_lights_punctual/lights/0/type"},
        Breach{"/buffers/0/uri", "data:application/octet-stream;base64,AAAA", "/buffers/0"},
        Breach{"/buffers/0/uri", "data:application/octet-stream;base64,****", "/buffers/0"},
        Breach{"/buffers/0/uri", "http://example.org/a.bin", "/buffers/0"},
        Breach{"/buffers/0/uri", "model.bin", "/buffers/0"},
        Breach{"/images/0/uri", "file:///etc/passwd", "/images/0"},
        Breach{"/images/0/uri", "/etc/passwd", "/images/0"}));

TEST(GltfGuards, RefuseAVertexIndexBeyondTheVerticesAndRestartValues) {
    for (const std::uint16_t index : {std::uint16_t{3}, std::uint16_t{0xFFFF}}) {
        auto sample = test::sample_gltf();
        const std::size_t at = sample.json["bufferViews"][3]["byteOffset"];
        std::memcpy(sample.binary.data() + at, &index, sizeof index);
        const auto loaded = test::load_from(sample.json, sample.binary);
        ASSERT_FALSE(loaded.has_value());
        EXPECT_THAT(loaded.error().message, HasSubstr("/meshes/0/primitives/0/indices"));
    }
}

TEST(GltfGuards, RefuseSparseIndicesThatDoNotAscendOrLieBeyondTheEnd) {
    for (const auto& indices : {std::array<std::uint16_t, 2>{2, 2}, {2, 0}, {0, 3}}) {
        auto sample = test::sample_gltf();
        sample.json["meshes"][0]["weights"] = {1.0};
        const std::size_t at = sample.json["bufferViews"][7]["byteOffset"];
        std::memcpy(sample.binary.data() + at, indices.data(), sizeof indices);
        const auto loaded = test::load_from(sample.json, sample.binary);
        ASSERT_FALSE(loaded.has_value());
        EXPECT_THAT(loaded.error().message, HasSubstr("/accessors/7/sparse/indices"));
    }
}

TEST(GltfGuards, RefuseAJointBeyondTheSkin) {
    auto sample = test::sample_gltf();
    const std::size_t at = sample.json["bufferViews"][4]["byteOffset"];
    sample.binary[at] = std::byte{1};
    const auto loaded = test::load_from(sample.json, sample.binary);
    ASSERT_FALSE(loaded.has_value());
    EXPECT_THAT(loaded.error().message, HasSubstr("JOINTS_0"));
}

TEST(GltfGuards, TakeNumbersThatAreNotFiniteAsZeroAndSaySo) {
    auto sample = test::sample_gltf();
    const float bad = std::numeric_limits<float>::quiet_NaN();
    std::memcpy(sample.binary.data(), &bad, sizeof bad);
    const auto loaded = test::load_from(sample.json, sample.binary);
    ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
    ASSERT_EQ(loaded->warnings.size(), 1u);
    EXPECT_THAT(loaded->warnings.front(), HasSubstr("/meshes/0/primitives/0"));
    EXPECT_EQ(loaded->document->scene->meshes[0].primitives[0].positions[0], glm::vec3(0.0f));
}

TEST(GltfGuards, RefuseTransformsThatMultiplyToInfinity) {
    auto sample = test::sample_gltf();
    sample.json["nodes"][0]["scale"] = {1e38, 1e38, 1e38};
    sample.json["nodes"][1]["scale"] = {1e38, 1e38, 1e38};
    const auto loaded = test::load_from(sample.json, sample.binary);
    ASSERT_FALSE(loaded.has_value());
    EXPECT_THAT(loaded.error().message, HasSubstr("/nodes/1"));
}

TEST(GltfGuards, RefuseNodesNestedDeeperThanTheLimit) {
    auto sample = test::sample_gltf();
    SortedJson& nodes = sample.json["nodes"];
    for (int i = 2; i < 1100; ++i) {
        nodes[static_cast<std::size_t>(i)]["children"] = {i + 1};
        nodes.push_back(SortedJson::object());
    }
    const auto loaded = test::load_from(sample.json, sample.binary);
    ASSERT_FALSE(loaded.has_value());
    EXPECT_THAT(loaded.error().message, HasSubstr("/nodes: are nested deeper than 1000"));
}

TEST(GltfGuards, RefuseWithoutDelayATreeWhoseSharingIsExponential) {
    // Each node lists the next one twice: 2^60 paths.
    auto sample = test::sample_gltf();
    SortedJson& nodes = sample.json["nodes"];
    for (int i = 2; i < 62; ++i) {
        nodes[static_cast<std::size_t>(i)]["children"] = {i + 1, i + 1};
        nodes.push_back(SortedJson::object());
    }
    EXPECT_FALSE(test::load_from(sample.json, sample.binary).has_value());
}

TEST(GltfGuards, RefuseMoreGeometryThanTheLimitBeforeTakingMemoryForIt) {
    // Four thousand million zeros asked for by forty bytes.
    auto sample = test::sample_gltf();
    sample.json["accessors"][0] = {
        {"componentType", 5126}, {"count", 2147483647}, {"type", "VEC3"}};
    sample.json["meshes"][0]["primitives"][0] = {{"attributes", {{"POSITION", 0}}}};
    auto loaded = test::load_from(sample.json, sample.binary);
    ASSERT_FALSE(loaded.has_value());
    EXPECT_THAT(loaded.error().message, HasSubstr("/meshes/0/primitives/0"));
    EXPECT_THAT(loaded.error().message, HasSubstr("limit"));
    // A million primitives that share one accessor.
    sample.json["accessors"][0]["count"] = 1000000;
    SortedJson& primitives = sample.json["meshes"][0]["primitives"];
    for (int i = 0; i < 1000; ++i) primitives.push_back(primitives[0]);
    loaded = load_document_from_memory(sample.glb(), "model.glb",
                                       {.geometry_bytes = std::uint64_t{64} << 20});
    ASSERT_FALSE(loaded.has_value());
    EXPECT_THAT(loaded.error().message, HasSubstr("limit"));
}

TEST(GltfGuards, RefuseMoreNodesThanTheLimit) {
    const auto sample = test::sample_gltf();
    const auto loaded = load_document_from_memory(sample.glb(), "model.glb", {.nodes = 2});
    ASSERT_FALSE(loaded.has_value());
    EXPECT_THAT(loaded.error().message, HasSubstr("/nodes: are 3, more than the limit of 2"));
}

TEST(GltfGuards, OpenAFileThatRequiresAnExtensionWhichIsOnlyKeptAndSaySo) {
    auto sample = test::sample_gltf();
    sample.json["extensionsRequired"] = {"KHR_materials_clearcoat"};
    const auto loaded = test::load_from(sample.json, sample.binary);
    ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
    ASSERT_EQ(loaded->warnings.size(), 1u);
    EXPECT_THAT(loaded->warnings.front(), HasSubstr("KHR_materials_clearcoat"));
}

}  // namespace
}  // namespace patina::io
