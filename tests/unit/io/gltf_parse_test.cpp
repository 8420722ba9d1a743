// SPDX-License-Identifier: MIT
// What tinygltf by itself refuses, misreads or reads too much of: Patina puts it in front of the
// parser in a form that is read right.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/json.h"
#include "sample_gltf.h"

namespace patina::io {
namespace {

using test::first_primitive;

TEST(GltfParse, TakesWholeNumbersWithAPointForIntegers) {
    auto sample = test::sample_gltf();
    // Positions from the normals' view: an offset that is not read would show the old ones.
    sample.json["bufferViews"][0]["byteLength"] = 72.0;
    sample.json["accessors"][0]["byteOffset"] = 36.0;
    sample.json["accessors"][0]["count"] = 3.0;
    sample.json["nodes"][0]["mesh"] = 0.0;
    sample.json["nodes"][0].erase("skin");
    const auto loaded = test::load_from(sample.json, sample.binary);
    ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
    EXPECT_EQ(first_primitive(loaded).positions[1], glm::vec3(0, 0, 1));
}

TEST(GltfParse, KeepsNumbersInExtensionsThatNoIntHolds) {
    auto sample = test::sample_gltf();
    sample.json["materials"][0]["extensions"]["KHR_materials_emissive_strength"] = {
        {"emissiveStrength", 3000000000}};
    const auto loaded = test::load_from(sample.json, sample.binary);
    ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
    EXPECT_EQ(loaded->document->materials[0]->emissive_strength, 1e6f);  // the largest shown
}

TEST(GltfParse, ReadsIndicesWithoutAViewAndStridesThatAreOdd) {
    auto sample = test::sample_gltf();
    sample.json["accessors"][3] = {{"componentType", 5123},
                                   {"count", 3},
                                   {"type", "SCALAR"},
                                   {"sparse",
                                    {{"count", 2},
                                     {"indices", {{"bufferView", 10}, {"componentType", 5123}}},
                                     {"values", {{"bufferView", 11}}}}}};
    sample.binary.resize((sample.binary.size() + 3) / 4 * 4);
    const std::size_t start = sample.binary.size();
    test::append<std::uint16_t>(sample.binary, {1, 2});
    test::append<std::uint16_t>(sample.binary, {2, 1});
    sample.json["bufferViews"].push_back(test::view(start, 4));
    sample.json["bufferViews"].push_back(test::view(start + 4, 4));
    sample.json["buffers"][0]["byteLength"] = sample.binary.size();
    sample.json["bufferViews"][4]["byteStride"] = 4;
    sample.json["bufferViews"][7]["byteStride"] = 3;  // of a sparse part: has no meaning
    const auto loaded = test::load_from(sample.json, sample.binary);
    ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
    EXPECT_THAT(first_primitive(loaded).indices, testing::ElementsAre(0u, 2u, 1u));
}

TEST(GltfParse, KeepsThePlaceOfAPrimitiveWithoutAttributes) {
    auto sample = test::sample_gltf();
    SortedJson& primitives = sample.json["meshes"][0]["primitives"];
    primitives[0].erase("targets");
    primitives.insert(primitives.begin(), SortedJson::object());
    const auto loaded = test::load_from(sample.json, sample.binary);
    ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
    ASSERT_EQ(loaded->warnings.size(), 1u);
    EXPECT_THAT(loaded->warnings[0],
                testing::HasSubstr("/meshes/0/primitives/0: has no positions"));
    EXPECT_THAT(first_primitive(loaded).indices, testing::ElementsAre(0u, 1u, 2u));
}

TEST(GltfParse, ShowsACameraOfWhichOnlyTheKindIsKnown) {
    auto sample = test::sample_gltf();
    sample.json["cameras"][0] = {{"type", "perspective"}};
    const auto loaded = test::load_from(sample.json, sample.binary);
    ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
    EXPECT_EQ(loaded->document->scene->cameras.at(0).fov_y_radians, SceneCamera().fov_y_radians);
}

TEST(GltfParse, OpensAnImageThatHasNeitherUriNorView) {
    auto sample = test::sample_gltf();
    sample.json["images"][0] = {{"name", "Nowhere"}};
    const auto loaded = test::load_from(sample.json, sample.binary);
    ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
    EXPECT_EQ(loaded->document->images.begin()->second->name, "Nowhere");
}

TEST(GltfParse, RefusesListsThatWouldGrowBeyondTheLimitInMemory) {
    auto sample = test::sample_gltf();
    // Three bytes of text each; some 2 KiB each once parsed.
    sample.json["materials"] = SortedJson::array();
    for (int i = 0; i < 700'000; ++i) sample.json["materials"].push_back(SortedJson::object());
    const auto loaded = test::load_from(sample.json, sample.binary);
    ASSERT_FALSE(loaded.has_value());
    EXPECT_THAT(loaded.error().message, testing::HasSubstr("more than the limit of 1024 MiB"));
}

}  // namespace
}  // namespace patina::io
