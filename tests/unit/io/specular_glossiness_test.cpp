// SPDX-License-Identifier: MIT
#include "io/specular_glossiness.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/json.h"
#include "document/edits.h"
#include "document/layer_json.h"
#include "document/record.h"
#include "io/save.h"
#include "sample_gltf.h"
#include "temporary_folder.h"

namespace patina::io {
namespace {

using test::lowest_channel;
using testing::HasSubstr;

constexpr const char* kExtension = "KHR_materials_pbrSpecularGlossiness";

TEST(SpecularGlossiness, OfADielectricIsItsDiffuseColourWithoutMetal) {
    const auto wood = metallic_roughness_of(
        {.diffuse = {0.5f, 0.25f, 0.1f, 0.75f}, .specular = glm::vec3(0.04f), .glossiness = 0.3f});
    EXPECT_NEAR(wood.metallic, 0.0f, 1e-6f);
    EXPECT_LT(glm::distance(wood.base_color, glm::vec4(0.5f, 0.25f, 0.1f, 0.75f)), 1e-5f);
    EXPECT_FLOAT_EQ(wood.roughness, 0.7f);
}

TEST(SpecularGlossiness, OfAMetalIsItsSpecularColour) {
    const glm::vec3 gold(1.0f, 0.766f, 0.336f);
    const auto metal =
        metallic_roughness_of({.diffuse = {0, 0, 0, 1}, .specular = gold, .glossiness = 1.0f});
    EXPECT_NEAR(metal.metallic, 1.0f, 1e-5f);
    EXPECT_LT(glm::distance(glm::vec3(metal.base_color), gold), 1e-4f);
    EXPECT_EQ(metal.roughness, 0.0f);
}

TEST(SpecularGlossiness, GivesBackWhatAMetallicRoughnessOfGreysIsMadeFrom) {
    // The other way is exact (same source): diffuse = base (1 - 0.04) (1 - metallic) over
    // 1 - specular, specular = mix(0.04, base, metallic).
    for (const float base : {0.2f, 0.5f, 0.9f})
        for (const float metallic : {0.0f, 0.25f, 0.5f, 1.0f}) {
            const float specular = glm::mix(0.04f, base, metallic);
            const float diffuse = base * 0.96f * (1.0f - metallic) / (1.0f - specular);
            const auto back = metallic_roughness_of(
                {.diffuse = glm::vec4(glm::vec3(diffuse), 1.0f), .specular = glm::vec3(specular)});
            EXPECT_NEAR(back.metallic, metallic, 2e-3f) << base << " " << metallic;
            EXPECT_NEAR(back.base_color.r, base, 2e-3f) << base << " " << metallic;
        }
}

test::SampleGltf glossy_sample(const SortedJson& extension) {
    auto sample = test::sample_gltf();
    sample.json["extensionsUsed"].push_back(kExtension);
    sample.json["extensionsRequired"] = {kExtension};
    sample.json["materials"][0].erase("pbrMetallicRoughness");
    sample.json["materials"][0]["extensions"][kExtension] = extension;
    return sample;
}

TEST(SpecularGlossiness, WithoutMapsLoadsAsConstants) {
    const auto sample = glossy_sample({{"diffuseFactor", {0, 0, 0, 1}},
                                       {"specularFactor", {0.9, 0.9, 0.9}},
                                       {"glossinessFactor", 0.75}});
    const auto loaded = test::load_from(sample.json, sample.binary);
    ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
    EXPECT_TRUE(loaded->warnings.empty());
    const auto constant = [&](Channel channel) {
        return std::get<ConstantSource>(
                   lowest_channel(*loaded->document->materials.at(0), channel).source)
            .value.x;
    };
    EXPECT_NEAR(constant(Channel::Metalness), 1.0f, 1e-4f);
    EXPECT_NEAR(constant(Channel::Roughness), 0.25f, 1e-6f);
    EXPECT_NEAR(constant(Channel::BaseColor), 0.9f, 1e-3f);
}

TEST(SpecularGlossiness, WithMapsLoadsAsMapsOfItsOwnThatKeepTheirPlace) {
    const auto sample = glossy_sample(
        {{"diffuseTexture",
          {{"index", 0}, {"extensions", {{"KHR_texture_transform", {{"scale", {2.0, 3.0}}}}}}}},
         {"specularFactor", {0.04, 0.04, 0.04}},
         {"glossinessFactor", 0.4}});
    const auto loaded = test::load_from(sample.json, sample.binary);
    ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
    const auto& source = std::get<ImageSource>(
        lowest_channel(*loaded->document->materials.at(0), Channel::BaseColor).source);
    EXPECT_EQ(source.transform.scale, glm::vec2(2.0f, 3.0f));
    EXPECT_EQ(source.wrap_v, Wrap::Mirror);
    const auto color = loaded->images->pixels(source.image);
    ASSERT_TRUE(color.has_value());
    // The specular of 0.04 leaves the diffuse colour as it is.
    EXPECT_EQ((*color)->data[0], std::byte{200});
    EXPECT_EQ((*color)->data[1], std::byte{100});
    EXPECT_EQ((*color)->data[2], std::byte{50});
    const auto& roughness = std::get<ImageSource>(
        lowest_channel(*loaded->document->materials.at(0), Channel::Roughness).source);
    const auto surface = loaded->images->pixels(roughness.image);
    ASSERT_TRUE(surface.has_value());
    EXPECT_EQ((*surface)->data[1], std::byte{153});  // 0.6 of 255
    EXPECT_EQ((*surface)->data[2], std::byte{0});
}

std::string stack_text(const Document& document) {
    return compact_text(layers_to_json(document.materials.at(0)->stack, JsonIds::Kept));
}

class SpecularGlossinessFile : public testing::Test {
  protected:
    void SetUp() override {
        const auto sample = glossy_sample(
            {{"diffuseTexture", {{"index", 0}}}, {"specularGlossinessTexture", {{"index", 0}}}});
        const Bytes glb = sample.glb();
        ASSERT_TRUE(write_file_atomically(path(), std::span(glb)).has_value());
        auto loaded = load_document(path());
        ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
        loaded_ = std::move(*loaded);
    }
    std::filesystem::path path() const { return folder_.path() / "glossy.glb"; }
    std::filesystem::path saved() const { return folder_.path() / "saved.glb"; }

    TemporaryFolder folder_;
    LoadedDocument loaded_;
};

TEST_F(SpecularGlossinessFile, ThatIsNotEditedIsSavedAsItCame) {
    const auto report = save_document(*loaded_.document, *loaded_.images, saved());
    ASSERT_TRUE(report.has_value()) << report.error().message;
    EXPECT_EQ(*read_file(path()), *read_file(saved()));
}

TEST_F(SpecularGlossinessFile, ThatIsEditedBecomesMetallicRoughnessAndSaysSo) {
    const MaterialPtr material = loaded_.document->materials.at(0);
    const auto edited =
        set_layer_opacity(*material, *material->stack[0], 0.5f).apply(*loaded_.document);
    ASSERT_TRUE(edited.has_value());
    const auto report = save_document(*edited, *loaded_.images, saved());
    ASSERT_TRUE(report.has_value()) << report.error().message;
    EXPECT_THAT(report->warnings, testing::Contains(HasSubstr("converted to metallic-roughness")));
    const auto again = load_document(saved());
    ASSERT_TRUE(again.has_value()) << again.error().message;
    const std::string text = again->document->source->json_text;
    EXPECT_EQ(text.find(kExtension), std::string::npos);
    EXPECT_EQ(stack_text(*again->document), stack_text(*edited));
    // The converted maps that its layer reads went into the file.
    for (const Hash128& hash : images_of(again->document->materials.at(0)->stack))
        EXPECT_TRUE(again->document->images.contains(hash));
}

TEST_F(SpecularGlossinessFile, IsConvertedByAnEditOfAnotherSlotToo) {
    const MaterialPtr material = loaded_.document->materials.at(0);
    Material changed = *material;
    changed.double_sided = true;
    Document document = *loaded_.document;
    document.materials[0] = std::make_shared<const Material>(changed);
    const auto report = save_document(document, *loaded_.images, saved());
    ASSERT_TRUE(report.has_value()) << report.error().message;
    const auto again = load_document(saved());
    ASSERT_TRUE(again.has_value()) << again.error().message;
    EXPECT_EQ(again->document->source->json_text.find(kExtension), std::string::npos);
    EXPECT_EQ(stack_text(*again->document), stack_text(*loaded_.document));
}

}  // namespace
}  // namespace patina::io
