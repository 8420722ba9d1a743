// SPDX-License-Identifier: MIT
#include "io/load.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/json.h"
#include "document/record.h"
#include "sample_gltf.h"

namespace patina::io {
namespace {

using test::first_primitive;
using test::lowest_channel;

/// The colours of COLOR_0 as floats, stored as `numbers` of some component type.
template <typename T>
std::vector<glm::vec4> loaded_colors(int component_type, const char* type, bool normalized,
                                     std::initializer_list<T> numbers) {
    auto sample = test::sample_gltf();
    const std::size_t start = sample.binary.size();
    test::append<T>(sample.binary, numbers);
    sample.json["bufferViews"].push_back(test::view(start, sample.binary.size() - start));
    sample.json["buffers"][0]["byteLength"] = sample.binary.size();
    SortedJson accessor = test::accessor(10, component_type, 3, type);
    if (normalized) accessor["normalized"] = true;
    sample.json["accessors"].push_back(accessor);
    sample.json["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = 9;
    const auto loaded = test::load_from(sample.json, sample.binary);
    if (!loaded) ADD_FAILURE() << loaded.error().message;
    return first_primitive(loaded).colors;
}

TEST(Load, ReadsEveryComponentTypeOfVertexColours) {
    const glm::vec4 first(1.0f, 0.0f, 0.2f, 1.0f);
    const auto u8 =
        loaded_colors<std::uint8_t>(5121, "VEC4", true, {255, 0, 51, 255, 0, 0, 0, 0, 0, 0, 0, 0});
    ASSERT_EQ(u8.size(), 3u);
    EXPECT_LT(glm::distance(u8[0], first), 1e-6f);
    const auto u16 = loaded_colors<std::uint16_t>(5123, "VEC4", true,
                                                  {65535, 0, 13107, 65535, 0, 0, 0, 0, 0, 0, 0, 0});
    EXPECT_LT(glm::distance(u16[0], first), 1e-6f);
    const auto f32 = loaded_colors<float>(5126, "VEC3", false, {1, 0, 0.2f, 0, 0, 0, 0, 0, 1});
    EXPECT_LT(glm::distance(f32[0], first), 1e-6f);
    EXPECT_EQ(f32[2], glm::vec4(0, 0, 1, 1));
}

TEST(Load, ReadsSignedNormalisedAndPlainIntegersAsQuantisedMeshesHaveThem) {
    auto sample = test::sample_gltf();
    const std::size_t start = sample.binary.size();
    test::append<std::int8_t>(sample.binary, {-128, 127, 0, 0, -127, 0, 0, 0, 64, 0, 0, 0});
    sample.json["bufferViews"].push_back(test::view(start, 12));
    sample.json["bufferViews"][10]["byteStride"] = 4;
    sample.json["buffers"][0]["byteLength"] = sample.binary.size();
    sample.json["accessors"][0] = test::accessor(10, 5120, 3, "VEC3");
    sample.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    sample.json["nodes"][0].erase("skin");
    auto loaded = test::load_from(sample.json, sample.binary);
    ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
    EXPECT_EQ(first_primitive(loaded).positions[0], glm::vec3(-128, 127, 0));
    sample.json["accessors"][0]["normalized"] = true;
    loaded = test::load_from(sample.json, sample.binary);
    EXPECT_EQ(first_primitive(loaded).positions[0], glm::vec3(-1, 1, 0));
    EXPECT_EQ(first_primitive(loaded).positions[1].x, -1.0f);
}

TEST(Load, ReadsIndicesOfEveryTypeAndInterleavedAttributes) {
    for (const int type : {5121, 5123, 5125}) {
        auto sample = test::sample_gltf();
        const std::size_t start = sample.binary.size();
        if (type == 5121) test::append<std::uint8_t>(sample.binary, {2, 1, 0});
        if (type == 5123) test::append<std::uint16_t>(sample.binary, {2, 1, 0});
        if (type == 5125) test::append<std::uint32_t>(sample.binary, {2, 1, 0});
        sample.json["bufferViews"].push_back(test::view(start, sample.binary.size() - start));
        // Position and normal, one after the other.
        const std::size_t interleaved = sample.binary.size();
        test::append<float>(sample.binary, {5, 0, 0, 0, 0, 1, 6, 0, 0, 0, 0, 1, 7, 1, 0, 0, 0, 1});
        sample.json["bufferViews"].push_back(test::view(interleaved, 72));
        sample.json["bufferViews"][11]["byteStride"] = 24;
        sample.json["buffers"][0]["byteLength"] = sample.binary.size();
        sample.json["accessors"][3] = test::accessor(10, type, 3, "SCALAR");
        sample.json["accessors"][0] = test::accessor(11, 5126, 3, "VEC3");
        sample.json["accessors"][1] = test::accessor(11, 5126, 3, "VEC3");
        sample.json["accessors"][1]["byteOffset"] = 12;
        const auto loaded = test::load_from(sample.json, sample.binary);
        ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
        const Primitive primitive = first_primitive(loaded);
        EXPECT_THAT(primitive.indices, testing::ElementsAre(2u, 1u, 0u));
        EXPECT_EQ(primitive.positions[1], glm::vec3(6, 0, 0));
        EXPECT_EQ(primitive.normals[2], glm::vec3(0, 0, 1));
    }
}

TEST(Load, TurnsStripsAndFansIntoTrianglesThatFaceTheSameWay) {
    auto sample = test::sample_gltf();
    sample.binary.clear();
    test::append<float>(sample.binary, {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0});
    sample.json["bufferViews"] = SortedJson::array({test::view(0, 60)});
    sample.json["buffers"][0]["byteLength"] = 60;
    sample.json["accessors"] = SortedJson::array({test::accessor(0, 5126, 5, "VEC3")});
    for (const char* member :
         {"skins", "animations", "images", "textures", "materials", "extensions", "cameras"})
        sample.json.erase(member);
    sample.json["nodes"] = {{{"mesh", 0}}};
    sample.json["scenes"] = {{{"nodes", {0}}}};
    SortedJson primitive = {{"attributes", {{"POSITION", 0}}}, {"mode", 5}};
    sample.json["meshes"] = SortedJson::array({{{"primitives", SortedJson::array({primitive})}}});
    auto loaded = test::load_from(sample.json, sample.binary);
    ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
    EXPECT_EQ(first_primitive(loaded).indices.size(), 9u);
    for (const glm::vec3& normal : first_primitive(loaded).normals)
        EXPECT_EQ(normal, glm::vec3(0, 0, 1));

    sample.json["meshes"][0]["primitives"][0]["mode"] = 6;
    loaded = test::load_from(sample.json, sample.binary);
    ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
    const Primitive fan = first_primitive(loaded);
    ASSERT_EQ(fan.indices.size(), 9u);
    // glTF 2.0, 3.7.2.1: p(i+1), p(i+2), p(0).
    EXPECT_EQ(fan.positions[0], glm::vec3(1, 0, 0));
    EXPECT_EQ(fan.positions[2], glm::vec3(0, 0, 0));

    // The default material follows; points are left out with a word.
    ASSERT_EQ(loaded->document->materials.size(), 1u);
    EXPECT_FALSE(loaded->document->materials[0]->source_material.has_value());
    sample.json["meshes"][0]["primitives"].push_back(
        {{"attributes", {{"POSITION", 0}}}, {"mode", 0}});
    loaded = test::load_from(sample.json, sample.binary);
    ASSERT_EQ(loaded->warnings.size(), 1u);
    EXPECT_EQ(loaded->document->scene->meshes[0].primitives.size(), 1u);
}

TEST(Load, PosesMorphsAtTheWeightsOfTheNodeElseOfTheMesh) {
    auto sample = test::sample_gltf();
    sample.json["nodes"][0].erase("skin");
    sample.json["meshes"][0]["weights"] = {0.5};
    auto loaded = test::load_from(sample.json, sample.binary);
    ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
    // The sparse target moves vertices 0 and 2 by one along z.
    EXPECT_EQ(first_primitive(loaded).positions[0], glm::vec3(0, 0, 0.5f));
    EXPECT_EQ(first_primitive(loaded).positions[1], glm::vec3(1, 0, 0));
    EXPECT_EQ(first_primitive(loaded).positions[2], glm::vec3(0, 1, 0.5f));
    sample.json["nodes"][0]["weights"] = {2.0};
    loaded = test::load_from(sample.json, sample.binary);
    EXPECT_EQ(first_primitive(loaded).positions[0], glm::vec3(0, 0, 2));
}

TEST(Load, PosesSkinsByTheirJointsAndLeavesTheNodeOutOfIt) {
    auto sample = test::sample_gltf();
    sample.json["nodes"][0]["translation"] = {100, 0, 0};
    sample.json["nodes"][2]["translation"] = {0, 5, 0};
    sample.json["nodes"][2]["rotation"] = {0, 0, std::sqrt(0.5), std::sqrt(0.5)};
    const auto loaded = test::load_from(sample.json, sample.binary);
    ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
    const Primitive primitive = first_primitive(loaded);
    EXPECT_LT(glm::distance(primitive.positions[1], glm::vec3(0, 6, 0)), 1e-6f);
    EXPECT_LT(glm::distance(primitive.normals[1], glm::vec3(0, 0, 1)), 1e-6f);
    EXPECT_EQ(loaded->document->scene->instances[0].world_from_local, glm::mat4(1.0f));
    EXPECT_LT(loaded->document->scene->bounds_world.high.x, 10.0f);
}

TEST(Load, FlattensTheNodesWithTheirCamerasAndLights) {
    auto sample = test::sample_gltf();
    sample.json["nodes"][0].erase("skin");
    sample.json["nodes"][0]["scale"] = {-2, 2, 2};
    sample.json["nodes"][1]["translation"] = {1, 0, 0};
    const auto loaded = test::load_from(sample.json, sample.binary);
    ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
    const Scene& scene = *loaded->document->scene;
    ASSERT_EQ(scene.instances.size(), 1u);
    EXPECT_EQ(scene.instances[0].name, "Body");
    EXPECT_LT(glm::determinant(scene.instances[0].world_from_local), 0.0f);
    ASSERT_EQ(scene.lights.size(), 1u);
    EXPECT_EQ(scene.lights[0].position_world, glm::vec3(-2, 0, 0));
    EXPECT_EQ(scene.lights[0].intensity, 20.0f);
    EXPECT_EQ(loaded->document->lights, scene.lights);
    ASSERT_EQ(scene.cameras.size(), 1u);
    EXPECT_EQ(scene.cameras[0].fov_y_radians, 0.5f);
}

TEST(Load, SharesAMeshAmongNodesAndShowsAFileWithoutNodes) {
    auto sample = test::sample_gltf();
    sample.json["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}}, SortedJson::object()};
    sample.json["scenes"][0]["nodes"] = {0, 1};
    auto loaded = test::load_from(sample.json, sample.binary);
    ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
    EXPECT_EQ(loaded->document->scene->meshes.size(), 1u);
    EXPECT_EQ(loaded->document->scene->instances.size(), 2u);
    for (const char* member : {"nodes", "scenes", "scene", "skins", "animations"})
        sample.json.erase(member);
    loaded = test::load_from(sample.json, sample.binary);
    ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
    EXPECT_EQ(loaded->document->scene->instances.size(), 1u);
}

TEST(Load, MakesAMaterialsMapsAndFactorsItsLowestLayer) {
    auto sample = test::sample_gltf();
    SortedJson& source = sample.json["materials"][0];
    source["pbrMetallicRoughness"]["baseColorFactor"] = {0.5, 0.25, 1.0, 0.75};
    source["pbrMetallicRoughness"]["metallicRoughnessTexture"] = {{"index", 0}};
    source["pbrMetallicRoughness"]["roughnessFactor"] = 0.5;
    source["normalTexture"]["scale"] = 2.0;
    source["occlusionTexture"]["strength"] = 0.25;
    source["emissiveFactor"] = {1, 0.5, 0};
    source["alphaMode"] = "BLEND";
    source["doubleSided"] = true;
    source["pbrMetallicRoughness"]["baseColorTexture"]["extensions"] = {
        {"KHR_texture_transform",
         {{"offset", {0.1, 0.2}}, {"scale", {2, 3}}, {"rotation", 1.5707963}, {"texCoord", 1}}}};
    source["extensions"] = {{"KHR_materials_ior", {{"ior", 1.33}}},
                            {"KHR_materials_specular",
                             {{"specularFactor", 0.5},
                              {"specularColorFactor", {1, 0.5, 0.25}},
                              {"specularTexture", {{"index", 0}, {"texCoord", 1}}},
                              {"specularColorTexture", {{"index", 0}}}}},
                            {"KHR_materials_emissive_strength", {{"emissiveStrength", 4}}},
                            {"KHR_materials_unlit", SortedJson::object()}};
    const auto loaded = test::load_from(sample.json, sample.binary);
    ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
    const Material& material = *loaded->document->materials.at(0);
    EXPECT_EQ(material.name, "Paint");
    ASSERT_EQ(material.stack.size(), 1u);
    EXPECT_EQ(material.stack[0]->name, "Imported textures");
    EXPECT_EQ(material.resolution, 256);
    EXPECT_EQ(material.uv_set, 1);
    EXPECT_EQ(material.source_material, 0);
    EXPECT_TRUE(material.double_sided && material.unlit);
    EXPECT_FLOAT_EQ(material.ior, 1.33f);
    EXPECT_FLOAT_EQ(material.specular_factor, 0.5f);
    EXPECT_EQ(material.specular_color_linear, glm::vec3(1, 0.5f, 0.25f));
    ASSERT_TRUE(material.specular_map && material.specular_color_map);
    EXPECT_EQ(material.specular_map->uv_set, 1);
    EXPECT_EQ(material.specular_map->color_space, ColorSpace::Linear);
    EXPECT_EQ(material.specular_color_map->color_space, ColorSpace::Srgb);
    EXPECT_FLOAT_EQ(material.emissive_strength, 4.0f);

    const auto base = std::get<ImageSource>(lowest_channel(material, Channel::BaseColor).source);
    EXPECT_EQ(base.color_space, ColorSpace::Srgb);
    EXPECT_EQ(base.multiply, glm::vec3(0.5f, 0.25f, 1.0f));
    EXPECT_EQ(base.uv_set, 1);
    EXPECT_EQ(base.transform.offset, glm::vec2(0.1f, 0.2f));
    EXPECT_EQ(base.transform.scale, glm::vec2(2, 3));
    EXPECT_NEAR(base.transform.rotation_degrees, 90.0f, 1e-4f);
    EXPECT_EQ(base.wrap_u, Wrap::Clamp);
    EXPECT_EQ(base.wrap_v, Wrap::Mirror);
    EXPECT_EQ(base.filter, Filter::Nearest);
    const auto metal = std::get<ImageSource>(lowest_channel(material, Channel::Metalness).source);
    EXPECT_EQ(metal.pick, ChannelPick::Blue);
    EXPECT_EQ(metal.multiply.x, 1.0f);
    const auto rough = std::get<ImageSource>(lowest_channel(material, Channel::Roughness).source);
    EXPECT_EQ(rough.pick, ChannelPick::Green);
    EXPECT_EQ(rough.multiply.x, 0.5f);
    const auto normal = std::get<ImageSource>(lowest_channel(material, Channel::Normal).source);
    EXPECT_EQ(normal.multiply, glm::vec3(2, 2, 1));
    const auto occlusion =
        std::get<ImageSource>(lowest_channel(material, Channel::Occlusion).source);
    EXPECT_EQ(occlusion.pick, ChannelPick::Red);
    EXPECT_EQ(occlusion.multiply.x, 0.25f);
    EXPECT_EQ(occlusion.add.x, 0.75f);
    const auto emissive = std::get<ImageSource>(lowest_channel(material, Channel::Emissive).source);
    EXPECT_EQ(emissive.color_space, ColorSpace::Srgb);
    EXPECT_EQ(emissive.multiply, glm::vec3(1, 0.5f, 0));
    // The PNG has no alpha, so the factor alone is the opacity.
    EXPECT_EQ(std::get<ConstantSource>(lowest_channel(material, Channel::Opacity).source).value.x,
              0.75f);
    EXPECT_FALSE(lowest_channel(material, Channel::Height).enabled);

    ASSERT_EQ(loaded->document->images.size(), 1u);
    const ImageAsset& image = *loaded->document->images.begin()->second;
    EXPECT_EQ(image.source_image, 0);
    EXPECT_EQ(image.mime_type, "image/png");
    EXPECT_EQ(image.width, 4);
    EXPECT_EQ((*loaded->images->pixels(image.hash))->data[1], std::byte{100});
}

TEST(Load, ShowsMapsOfUvSetsThatItDoesNotReadByTheFirstAndSaysSoOnce) {
    auto sample = test::sample_gltf();
    SortedJson& source = sample.json["materials"][0];
    source["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"] = 2;
    source["normalTexture"]["extensions"]["KHR_texture_transform"]["texCoord"] = 15;
    source["extensions"]["KHR_materials_specular"]["specularTexture"] = {{"index", 0},
                                                                         {"texCoord", 3}};
    const auto loaded = test::load_from(sample.json, sample.binary);
    ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
    ASSERT_EQ(loaded->warnings.size(), 1u);
    EXPECT_EQ(loaded->warnings.front(),
              "model.glb: /materials/0: its maps name TEXCOORD_2, which Patina does not read; "
              "TEXCOORD_0 is used");
    const Material& material = *loaded->document->materials.at(0);
    EXPECT_EQ(material.uv_set, 0);
    EXPECT_EQ(material.specular_map->uv_set, 0);
    for (const Channel channel : {Channel::BaseColor, Channel::Normal})
        EXPECT_EQ(std::get<ImageSource>(lowest_channel(material, channel).source).uv_set, 0);
}

TEST(Load, GivesPrimitivesWithoutMaterialTheDefaultOfTheStandard) {
    auto sample = test::sample_gltf();
    sample.json["meshes"][0]["primitives"][0].erase("material");
    const auto loaded = test::load_from(sample.json, sample.binary);
    ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
    ASSERT_EQ(loaded->document->materials.size(), 2u);
    const Material& material = *loaded->document->materials[1];
    EXPECT_FALSE(material.source_material.has_value());
    const auto constant = [&](Channel channel) {
        return std::get<ConstantSource>(lowest_channel(material, channel).source).value.x;
    };
    EXPECT_EQ(constant(Channel::BaseColor), 1.0f);
    EXPECT_EQ(constant(Channel::Metalness), 1.0f);
    EXPECT_EQ(constant(Channel::Roughness), 1.0f);
    EXPECT_EQ(material_of(*loaded->document, -1), loaded->document->materials[1]);
}

TEST(Load, KeepsTheFileWholeAndTheDocumentAsItWasOpened) {
    const auto sample = test::sample_gltf();
    const Bytes glb = sample.glb();
    const auto loaded = load_document_from_memory(glb, "model.glb");
    ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
    const Document& document = *loaded->document;
    EXPECT_EQ(document.source->file, glb);
    EXPECT_EQ(document.source->json_text, sample.json.dump());
    EXPECT_EQ(document.source->container, Container::Glb);
    ASSERT_NE(document.opened, nullptr);
    EXPECT_EQ(document.opened->opened, nullptr);
    EXPECT_EQ(serialise(*document.opened), serialise(document));
}

TEST(Load, OpensTheSameModelAsTextWithDataUris) {
    auto sample = test::sample_gltf();
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string base64;
    sample.binary.resize((sample.binary.size() + 2) / 3 * 3);
    for (std::size_t i = 0; i < sample.binary.size(); i += 3) {
        const auto byte = [&](std::size_t k) {
            return std::to_integer<unsigned>(sample.binary[i + k]);
        };
        const unsigned word = byte(0) << 16 | byte(1) << 8 | byte(2);
        for (const unsigned shift : {18u, 12u, 6u, 0u}) base64 += digits[word >> shift & 63u];
    }
    sample.json["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64;
    const auto loaded =
        load_document_from_memory(test::bytes_from(sample.json.dump(2)), "model.gltf");
    ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
    EXPECT_EQ(loaded->document->source->container, Container::Gltf);
    EXPECT_EQ(first_primitive(loaded).positions[1], glm::vec3(1, 0, 0));
    EXPECT_EQ(loaded->document->images.size(), 1u);
}

TEST(Load, ShowsAPlaceholderForAnImageThatCannotBeDecodedAndKeepsItsBytes) {
    auto sample = test::sample_gltf();
    const std::size_t at = sample.json["bufferViews"][9]["byteOffset"];
    sample.binary[at + 1] = std::byte{'X'};  // no PNG any more
    const auto loaded = test::load_from(sample.json, sample.binary);
    ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
    ASSERT_EQ(loaded->warnings.size(), 1u);
    EXPECT_THAT(loaded->warnings[0], testing::HasSubstr("/images/0"));
    ASSERT_EQ(loaded->document->images.size(), 1u);
    const auto& [hash, image] = *loaded->document->images.begin();
    EXPECT_TRUE(loaded->images->pixels(hash).has_value());
    ASSERT_NE(image->encoded.bytes(), nullptr);
    EXPECT_EQ((*image->encoded.bytes())[1], std::byte{'X'});
    EXPECT_EQ(image->source_image, 0);
}

TEST(Load, StopsWhenItIsCancelled) {
    const auto sample = test::sample_gltf();
    const Progress progress;
    progress.cancel();
    const auto loaded = load_document_from_memory(sample.glb(), "model.glb", {}, progress);
    ASSERT_FALSE(loaded.has_value());
    EXPECT_THAT(loaded.error().message, testing::HasSubstr("cancelled"));
}

/// A record of the sample's material with one more layer, as a save would write it.
MaterialRecord sample_record(const Document& document) {
    const Material& material = *document.materials.at(0);
    MaterialRecord record = material_record(document, material);
    Layer rust = *material.stack[0];
    rust.id = LayerId{77};
    rust.name = "Rust";
    rust.opacity = 0.5f;
    record.stack.push_back(std::make_shared<const Layer>(rust));
    record.resolution = 512;
    return record;
}

TEST(Load, ReopensAMaterialWithItsLayersFromTheRecord) {
    auto sample = test::sample_gltf();
    const auto first = test::load_from(sample.json, sample.binary);
    ASSERT_TRUE(first.has_value()) << first.error().message;
    MaterialRecord record = sample_record(*first->document);
    record.baked["base-color"] = first->document->images.begin()->first;
    sample.json["materials"][0]["extras"]["patina"] = to_json(record);
    const auto loaded = test::load_from(sample.json, sample.binary);
    ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
    EXPECT_TRUE(loaded->warnings.empty()) << loaded->warnings.front();
    const Material& material = *loaded->document->materials[0];
    ASSERT_EQ(material.stack.size(), 2u);
    EXPECT_EQ(material.stack[1]->name, "Rust");
    EXPECT_EQ(material.stack[1]->id, LayerId{77});
    EXPECT_EQ(material.resolution, 512);
    EXPECT_EQ(material.id, record.id);
    EXPECT_GT(loaded->document->next_id, 77u);
}

TEST(Load, ShowsTheMapsWhereTheyWereEditedElsewhere) {
    auto sample = test::sample_gltf();
    const auto first = test::load_from(sample.json, sample.binary);
    MaterialRecord record = sample_record(*first->document);
    record.baked["base-color"] = Hash128{1, 2};
    sample.json["materials"][0]["extras"]["patina"] = to_json(record);
    const auto loaded = test::load_from(sample.json, sample.binary);
    ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
    ASSERT_EQ(loaded->warnings.size(), 1u);
    EXPECT_THAT(loaded->warnings[0], testing::HasSubstr("edited elsewhere"));
    ASSERT_EQ(loaded->document->materials[0]->stack.size(), 1u);
    EXPECT_EQ(loaded->document->materials[0]->stack[0]->name, "Imported textures");
}

TEST(Load, ShowsTheMapsOfANewerRecordAndOfOneThatCannotBeRead) {
    auto sample = test::sample_gltf();
    for (const char* text : {R"({"version":99,"stack":"from the future"})",
                             R"({"version":1,"oops":1})", "no JSON", "{}"}) {
        sample.json["materials"][0]["extras"]["patina"] = text;
        const auto loaded = test::load_from(sample.json, sample.binary);
        ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
        EXPECT_EQ(loaded->warnings.size(), 1u) << text;
        EXPECT_EQ(loaded->document->materials[0]->stack[0]->name, "Imported textures");
    }
    sample.json["materials"][0]["extras"] = {"an", "array"};
    const auto loaded = test::load_from(sample.json, sample.binary);
    ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
    EXPECT_TRUE(loaded->warnings.empty());
}

TEST(Load, ShowsTheMaterialItselfWhereAPlainCopyStandsForIt) {
    auto sample = test::sample_gltf();
    const auto first = test::load_from(sample.json, sample.binary);
    const MaterialRecord record = sample_record(*first->document);
    MaterialRecord copy;
    copy.id = MaterialId{500};
    copy.stands_for = record.id;
    sample.json["materials"][0]["extras"]["patina"] = to_json(record);
    sample.json["materials"].push_back(
        {{"name", "Paint"}, {"extras", {{"patina", to_json(copy)}}}});
    sample.json["meshes"][0]["primitives"][0]["material"] = 1;
    const auto loaded = test::load_from(sample.json, sample.binary);
    ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
    EXPECT_TRUE(loaded->warnings.empty()) << loaded->warnings.front();
    EXPECT_EQ(loaded->document->materials.size(), 1u);
    EXPECT_EQ(first_primitive(loaded).source_material, 0);
}

TEST(Load, TakesEnvironmentAndLightsFromTheScenesRecord) {
    auto sample = test::sample_gltf();
    SceneRecord record;
    record.environment.rotation_degrees = 45.0f;
    record.environment.sun_elevation_degrees = 12.0f;
    record.lights = std::vector<Light>{Light{}, Light{}};
    sample.json["scenes"][0]["extras"]["patina"] = to_json(record);
    const auto loaded = test::load_from(sample.json, sample.binary);
    ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
    EXPECT_EQ(loaded->document->environment.rotation_degrees, 45.0f);
    EXPECT_EQ(loaded->document->environment.sun_elevation_degrees, 12.0f);
    EXPECT_EQ(loaded->document->lights.size(), 2u);
    EXPECT_EQ(loaded->document->scene->lights.size(), 1u);
}

}  // namespace
}  // namespace patina::io
