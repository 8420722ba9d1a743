// SPDX-License-Identifier: MIT

/// Saving materials that were added, and parts that were assigned others.

#include <gtest/gtest.h>

#include <algorithm>

#include "document/edits.h"
#include "document/record.h"
#include "io/json_splice.h"
#include "io/save_fixture.h"

namespace patina::io {
namespace {

/// A material with noise in base colour and roughness, drawn on a part.
Document with_new_material_on(const Document& before, std::size_t part) {
    const std::size_t index = before.materials.size();
    Document document = with(before, add_material("Brass"));
    const auto added = std::find_if(document.materials.begin(), document.materials.end(),
                                    [](const MaterialPtr& each) { return each->name == "Brass"; });
    const Material brass = **added;
    document = with(
        document, add_layer(brass, procedural_layer(ProceduralKind::PerlinNoise), top_of_stack()));
    document = with(document, set_material_resolution(brass, kMinResolution));
    document = with(document, assign_material(brass, patina::parts_of(document).at(part)));
    EXPECT_EQ(document.materials.size(), index + 1);
    return document;
}

TEST_F(Save, AnAddedMaterialIsAppendedAndItsPartNamesIt) {
    const auto document = quad(true, {{.name = "Quad"}, {.name = "Other"}});
    const Document edited = with_new_material_on(*document.document, 0);
    const auto path = folder_ / "a.glb";
    EXPECT_EQ(saved(edited, *document.images, path).materials_written, 1);
    const Json json = Json::parse(json_of(path));
    ASSERT_EQ(json["materials"].size(), 3u);
    EXPECT_EQ(json["materials"][2]["name"], "Brass");
    EXPECT_EQ(json["meshes"][0]["primitives"][0]["material"], 2);
    const Json before = Json::parse(document.document->source->json_text);
    EXPECT_EQ(json["materials"][0], before["materials"][0]);
    EXPECT_EQ(json["materials"][1], before["materials"][1]);
    const auto reopened = loaded(path);
    EXPECT_TRUE(serialise(*reopened.document) == serialise(edited));
    EXPECT_TRUE(reopened.document->assigned.empty()) << "the file says it now";
    // Saved again from where it was opened, it is the same file.
    saved(*reopened.document, *reopened.images, folder_ / "b.glb");
    EXPECT_EQ(read_file(path).value(), read_file(folder_ / "b.glb").value());
}

TEST_F(Save, AssigningMaterialsOfTheFileChangesNothingButTheReference) {
    const auto document = quad(true, {{.name = "Quad"}, {.name = "Other"}});
    const Document edited =
        with(*document.document, assign_material(material_at(*document.document, 1),
                                                 patina::parts_of(*document.document)[0]));
    const auto path = folder_ / "a.glb";
    EXPECT_EQ(saved(edited, *document.images, path).materials_written, 0);
    Json json = Json::parse(json_of(path));
    EXPECT_EQ(json["meshes"][0]["primitives"][0]["material"], 1);
    json["meshes"][0]["primitives"][0]["material"] = 0;
    EXPECT_EQ(json, Json::parse(document.document->source->json_text));
    EXPECT_TRUE(serialise(*loaded(path).document) == serialise(edited));
}

TEST_F(Save, ACopyTakesAlongWhatPatinaDoesNotKnow) {
    const auto plain = quad(true);
    const auto model = folder_ / "lacquer.gltf";
    Json json = Json::parse(plain.document->source->json_text);
    json["materials"][0]["extensions"]["KHR_materials_clearcoat"]["clearcoatFactor"] = 0.75;
    json["materials"][0]["doubleSided"] = true;
    json["extensionsUsed"] = {"KHR_materials_clearcoat"};
    const auto first = folder_ / "first.gltf";
    saved(*plain.document, *plain.images, first);
    Json as_gltf = Json::parse(json_of(first));
    as_gltf["materials"] = json["materials"];
    as_gltf["extensionsUsed"] = json["extensionsUsed"];
    ASSERT_TRUE(write_file_atomically(model, std::string_view(as_gltf.dump())));
    const auto document = loaded(model);
    Document edited =
        with(*document.document, duplicate_material(material_at(*document.document, 0)));
    const Material copy = *edited.materials.back();
    edited = with(edited, set_material_double_sided(copy, false));
    edited = with(edited, assign_material(copy, patina::parts_of(edited)[0]));
    const auto path = folder_ / "copy.gltf";
    saved(edited, *document.images, path);
    const Json written = Json::parse(json_of(path));
    ASSERT_EQ(written["materials"].size(), 2u);
    EXPECT_EQ(written["materials"][0], as_gltf["materials"][0]);
    EXPECT_EQ(written["materials"][1]["name"], "Quad copy");
    EXPECT_EQ(written["materials"][1]["extensions"]["KHR_materials_clearcoat"]["clearcoatFactor"],
              0.75);
    EXPECT_FALSE(written["materials"][1].value("doubleSided", false));
    EXPECT_TRUE(serialise(*loaded(path).document) == serialise(edited));
}

TEST_F(Save, AnAddedMaterialOnAPartWithoutUvsGetsAPlainCopy) {
    const auto document = quad(false);
    const Document edited = with_new_material_on(*document.document, 0);
    const auto path = folder_ / "a.glb";
    EXPECT_EQ(saved(edited, *document.images, path).warnings.size(), 1u);
    const Json json = Json::parse(json_of(path));
    ASSERT_EQ(json["materials"].size(), 3u);
    EXPECT_EQ(json["meshes"][0]["primitives"][0]["material"], 2);
    EXPECT_FALSE(json["materials"][2]["pbrMetallicRoughness"].contains("baseColorTexture"));
    EXPECT_TRUE(serialise(*loaded(path).document) == serialise(edited));
}

TEST_F(Save, APartCanTakeAndLeaveTheDefaultMaterial) {
    const auto document = quad(true, {});
    const Document edited = with_new_material_on(*document.document, 0);
    const auto path = folder_ / "a.glb";
    saved(edited, *document.images, path);
    const Json json = Json::parse(json_of(path));
    ASSERT_EQ(json["materials"].size(), 1u) << "the default one is in no file";
    EXPECT_EQ(json["meshes"][0]["primitives"][0]["material"], 0);
}

TEST_F(Save, AnAddedMaterialBesideAnEditedDefaultOneKeepsBothIds) {
    auto document = quad(true, {});
    Document edited = with_noise_layer(*document.document, 0);
    edited = with(edited, add_material("Brass"));
    const auto path = folder_ / "a.glb";
    saved(edited, *document.images, path);
    EXPECT_TRUE(serialise(*loaded(path).document) == serialise(edited));
}

}  // namespace
}  // namespace patina::io
