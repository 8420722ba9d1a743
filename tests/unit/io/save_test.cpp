// SPDX-License-Identifier: MIT
#include "io/save.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "document/material_edits.h"
#include "document/record.h"
#include "document/scene_edits.h"
#include "io/json_splice.h"
#include "io/save_fixture.h"

namespace patina::io {
namespace {

TEST_F(Save, LoadingAndSavingGivesTheIdenticalFile) {
    const auto models = asset_models();
    SKIP_WITHOUT(models);
    for (const auto& model : models) {
        const auto document = loaded(model);
        const auto path = folder_ / model.filename();
        const auto report = saved(*document.document, *document.images, path);
        EXPECT_EQ(report.materials_written, 0) << model;
        EXPECT_TRUE(read_file(path).value() == read_file(model).value()) << model;
        EXPECT_TRUE(load_document(path)) << model << ": what it refers to was not copied";
    }
}

TEST_F(Save, AnEditUndoneAndSavedGivesTheIdenticalFile) {
    const auto models = asset_models();
    SKIP_WITHOUT(models);
    for (const auto& model : models) {
        const auto path = copied(model);
        const auto document = loaded(path);
        saved(with_noise_layer(*document.document, 0), *document.images, path);
        EXPECT_FALSE(read_file(path).value() == read_file(model).value());
        // The same content in new nodes, as an edit and its opposite leave it.
        Document undone = *document.document;
        Material material = material_at(undone, 0);
        for (LayerPtr& layer : material.stack) layer = std::make_shared<const Layer>(*layer);
        undone.materials[0] = std::make_shared<const Material>(material);
        saved(undone, *document.images, path);
        EXPECT_TRUE(read_file(path).value() == read_file(model).value()) << model;
        EXPECT_EQ(files_in(path.parent_path()),
                  model.extension() == ".gltf" ? files_in(model.parent_path()) : 1u)
            << model << ": files that nothing uses were left behind";
    }
}

TEST_F(Save, AnEditOfOneMaterialLeavesEveryOtherSpanAndTheOldBinaryChunkAlone) {
    const auto models = asset_models();
    SKIP_WITHOUT(models);
    for (const auto& model : models) {
        if (model.extension() != ".glb") continue;
        const auto document = loaded(model);
        const auto path = folder_ / model.filename();
        saved(with_noise_layer(*document.document, 0), *document.images, path);
        const Glb before = parts_of(read_file(model).value());
        const Glb after = parts_of(read_file(path).value());
        ASSERT_GT(after.binary.size(), before.binary.size());
        EXPECT_TRUE(std::equal(before.binary.begin(), before.binary.end(), after.binary.begin()));
        const auto old_json = JsonSpans::scan(before.json).value();
        const auto new_json = JsonSpans::scan(after.json).value();
        // A primitive without UVs or without a material names another one now.
        const bool adds_material = new_json.children(*new_json.find("/materials")).size() >
                                   old_json.children(*old_json.find("/materials")).size();
        for (const int member : old_json.children(0)) {
            const std::string key = old_json.key_of(member);
            const auto now = new_json.member(0, key);
            ASSERT_TRUE(now) << key;
            const bool array = old_json.node(member).kind == JsonKind::Array;
            const auto old_items = old_json.children(member), new_items = new_json.children(*now);
            if (!array) {
                EXPECT_EQ(old_json.value_text(member), new_json.value_text(*now)) << key;
            }
            if (!array || key == "extensionsUsed" || key == "buffers") continue;
            if (adds_material && key == "meshes") continue;
            ASSERT_GE(new_items.size(), old_items.size()) << key;
            for (std::size_t i = key == "materials" ? 1 : 0; i < old_items.size(); ++i)
                EXPECT_EQ(old_json.value_text(old_items[i]), new_json.value_text(new_items[i]))
                    << model << " " << key << " " << i;
        }
    }
}

TEST_F(Save, WhatIsSavedReopensAsTheIdenticalDocument) {
    const auto models = asset_models();
    SKIP_WITHOUT(models);
    for (const auto& model : models) {
        const auto path = copied(model);
        const auto document = loaded(path);
        Document edited = with_noise_layer(*document.document, 0);
        edited = with(edited, set_material_ior(material_at(edited, 0), 1.4f));
        edited = with(edited, set_material_double_sided(material_at(edited, 0), true));
        edited = with(edited, rename_material(material_at(edited, 0), "Painted"));
        edited = with(edited, set_environment_rotation(30.0f));
        saved(edited, *document.images, path);
        const auto reopened = loaded(path);
        EXPECT_TRUE(serialise(*reopened.document) == serialise(edited)) << model;
        const auto again = path.parent_path() / ("again" + path.extension().string());
        saved(*reopened.document, *reopened.images, again);
        EXPECT_TRUE(read_file(again).value() == read_file(path).value()) << model;
    }
}

TEST_F(Save, TenSavesAreAsLargeAsOne) {
    const auto models = asset_models();
    SKIP_WITHOUT(models);
    for (const auto& model : models) {
        const auto path = copied(model);
        std::uint64_t first_size = 0;
        std::size_t first_files = 0;
        for (std::uint32_t i = 0; i < 10; ++i) {
            const auto document = loaded(path);
            Document edited = *document.document;
            if (i == 0) edited = with_noise_layer(edited, 0);
            // Alternately a new and the first seed.
            Material material = material_at(edited, 0);
            Layer layer = *material.stack.back();
            at(layer.channels, Channel::BaseColor).source = noise(1 + i % 2);
            material.stack.back() = std::make_shared<const Layer>(layer);
            edited.materials[0] = std::make_shared<const Material>(material);
            saved(edited, *document.images, path);
            if (i == 0) first_size = fs::file_size(path);
            if (i == 0) first_files = files_in(path.parent_path());
            EXPECT_EQ(files_in(path.parent_path()), first_files) << model;
            if (i % 2 == 0) {
                EXPECT_EQ(fs::file_size(path), first_size) << model << " save " << i;
            }
        }
    }
}

TEST_F(Save, MaterialsSavedInTurnsDoNotGrowTheFileAndKeepEachOther) {
    Mesh mesh;
    for (int i = 0; i < 3; ++i) {
        Primitive primitive;
        primitive.positions = {{0, 0, i}, {1, 0, i}, {1, 1, i}};
        primitive.normals.assign(3, {0, 0, 1});
        primitive.uvs[0] = {{0, 1}, {1, 1}, {1, 0}};
        primitive.indices = {0, 1, 2};
        primitive.source_material = i;
        mesh.primitives.push_back(primitive);
    }
    const std::vector<PlainMaterial> plain = {{.name = "A"}, {.name = "B"}, {.name = "C"}};
    const auto path = folder_ / "three.glb";
    ASSERT_TRUE(write_file_atomically(path, mesh_to_glb(mesh, plain)));
    std::mt19937 random(5);
    std::vector<std::string> stacks(3);
    for (int i = 0; i < 30; ++i) {
        const auto document = loaded(path);
        for (std::size_t k = 0; k < 3; ++k)
            if (!stacks[k].empty()) {
                EXPECT_EQ(to_json(material_record(*document.document,
                                                  material_at(*document.document, k))),
                          stacks[k]);
            }
        const std::size_t k = random() % 3;
        Document edited = *document.document;
        Material material = material_at(edited, k);
        material.resolution = kMinResolution;
        Layer layer = *material.stack.front();
        if (random() % 3 == 0)
            at(layer.channels, Channel::BaseColor) = {.enabled = true,
                                                      .source = ConstantSource{glm::vec3(0.2f)}};
        else
            at(layer.channels, Channel::BaseColor) = {.enabled = true,
                                                      .source = noise(random() % 2)};
        material.stack.front() = std::make_shared<const Layer>(layer);
        edited.materials[k] = std::make_shared<const Material>(material);
        stacks[k] = to_json(material_record(edited, material));
        saved(edited, *document.images, path);
        const Json json = Json::parse(parts_of(read_file(path).value()).json);
        const std::size_t images = json.contains("images") ? json["images"].size() : 0;
        EXPECT_LE(images, 3u) << "a map that nothing shows was kept";
        for (std::size_t m = 0; m < 3; ++m) {
            const bool varies = stacks[m].find("noise") != std::string::npos;
            const auto& slots = json["materials"][m]["pbrMetallicRoughness"];
            EXPECT_EQ(slots.contains("baseColorTexture"), varies)
                << "material " << m << " save " << i;
        }
    }
}

TEST_F(Save, AConstantStackIsFactorsAndNoTexture) {
    const auto document = quad(true);
    Document edited = *document.document;
    Material material = material_at(edited, 0);
    Layer layer = *material.stack.front();
    at(layer.channels, Channel::BaseColor).source = ConstantSource{{0.25f, 0.5f, 0.75f}};
    at(layer.channels, Channel::Roughness).source = ConstantSource{glm::vec3(0.125f)};
    material.stack.front() = std::make_shared<const Layer>(layer);
    edited.materials[0] = std::make_shared<const Material>(material);
    const auto report = saved(edited, *document.images, folder_ / "a.glb");
    EXPECT_EQ(report.maps_baked, 0);
    const Json json = Json::parse(parts_of(read_file(folder_ / "a.glb").value()).json);
    const Json& slots = json["materials"][0]["pbrMetallicRoughness"];
    EXPECT_EQ(slots["baseColorFactor"], Json({0.25, 0.5, 0.75, 1}));
    EXPECT_EQ(slots["roughnessFactor"], 0.125);
    EXPECT_FALSE(json.contains("images"));
}

TEST_F(Save, APrimitiveWithoutUvsGetsAPlainCopyOfTheMaterialAndOneWarning) {
    const auto document = quad(false);
    const Document edited = with_noise_layer(*document.document, 0);
    const auto path = folder_ / "a.glb";
    const auto report = saved(edited, *document.images, path);
    EXPECT_EQ(report.warnings.size(), 1u);
    const Json json = Json::parse(parts_of(read_file(path).value()).json);
    ASSERT_EQ(json["materials"].size(), 2u);
    EXPECT_EQ(json["meshes"][0]["primitives"][0]["material"], 1);
    const Json& plain = json["materials"][1]["pbrMetallicRoughness"];
    EXPECT_FALSE(plain.contains("baseColorTexture"));
    EXPECT_NEAR(plain["roughnessFactor"].get<double>(), 0.5, 0.1) << "the mean of the noise";
    const auto reopened = loaded(path);
    EXPECT_TRUE(serialise(*reopened.document) == serialise(edited));
    // Taking the layer off again takes the copy away.
    Document plain_again = *reopened.document;
    Material material = material_at(plain_again, 0);
    material.stack.pop_back();
    plain_again.materials[0] = std::make_shared<const Material>(material);
    saved(plain_again, *reopened.images, path);
    const Json last = Json::parse(parts_of(read_file(path).value()).json);
    EXPECT_EQ(last["materials"].size(), 1u);
    EXPECT_EQ(last["meshes"][0]["primitives"][0]["material"], 0);
}

TEST_F(Save, APrimitiveWithoutAMaterialGetsOneWhenItIsEdited) {
    const auto document = quad(true, {});
    ASSERT_EQ(document.document->materials.size(), 1u);
    const Document edited = with_noise_layer(*document.document, 0);
    const auto path = folder_ / "a.glb";
    saved(edited, *document.images, path);
    const Json json = Json::parse(parts_of(read_file(path).value()).json);
    EXPECT_EQ(json["meshes"][0]["primitives"][0]["material"], 0);
    EXPECT_TRUE(serialise(*loaded(path).document) == serialise(edited));
}

TEST_F(Save, SavingAsTheOtherContainerKeepsTheDocumentBothWays) {
    const auto models = asset_models();
    SKIP_WITHOUT(models);
    for (const auto& model : models) {
        const auto document = loaded(model);
        const bool glb = model.extension() == ".glb";
        const auto folder = folder_ / model.stem();
        fs::create_directories(folder);
        const auto there = folder / (glb ? "a.gltf" : "a.glb"),
                   back = folder / (glb ? "b.glb" : "b.gltf");
        const Document edited = with_noise_layer(*document.document, 0);
        saved(edited, *document.images, there);
        const auto other = loaded(there);
        EXPECT_TRUE(serialise(*other.document) == serialise(edited)) << model;
        saved(*other.document, *other.images, back);
        EXPECT_TRUE(serialise(*loaded(back).document) == serialise(edited)) << model;
    }
}

TEST_F(Save, AFileOfTheSameNameInAnotherFolderIsNotOverwritten) {
    const auto models = asset_models();
    const auto model = std::find_if(models.begin(), models.end(),
                                    [](const fs::path& path) { return path.stem() == "Avocado"; });
    if (model == models.end()) GTEST_SKIP() << "no Avocado in ../shared/assets";
    ASSERT_TRUE(write_file_atomically(folder_ / "Avocado.bin", "somebody else's"));
    const auto document = loaded(*model);
    saved(*document.document, *document.images, folder_ / "Avocado.gltf");
    EXPECT_EQ(read_text_file(folder_ / "Avocado.bin").value(), "somebody else's");
    EXPECT_TRUE(serialise(*loaded(folder_ / "Avocado.gltf").document) ==
                serialise(*document.document));
}

TEST_F(Save, ASaveThatFailsLeavesTheOldFileAndNothingElse) {
    const auto document = quad(true);
    const auto path = folder_ / "a.gltf";
    saved(*document.document, *document.images, path);
    const auto before = read_file(path).value();
    const std::size_t files = files_in(folder_);
    const Progress cancelled;
    cancelled.cancel();
    EXPECT_FALSE(save_document(with_noise_layer(*document.document, 0), *document.images, path, {},
                               cancelled));
    EXPECT_EQ(read_file(path).value(), before);
    EXPECT_EQ(files_in(folder_), files);
    EXPECT_FALSE(save_document(*document.document, *document.images, folder_ / "a.obj"));
    fs::create_directory(folder_ / "taken.gltf");
    const std::size_t more = files_in(folder_);
    EXPECT_FALSE(save_document(with_noise_layer(*document.document, 0), *document.images,
                               folder_ / "taken.gltf"));
    EXPECT_EQ(files_in(folder_), more) << "a side file of a failed save was left behind";
}

TEST_F(Save, ExtrasThatAreNoObjectAreLeftAloneWithAWarning) {
    const auto document = quad(true);
    const auto path = folder_ / "a.gltf";
    saved(*document.document, *document.images, path);
    const auto text = read_text_file(path).value();
    const auto spans = JsonSpans::scan(text).value();
    ASSERT_TRUE(
        write_file_atomically(path, spliced(spans, {{"/materials/0/extras", "mine"}}).value()));
    const auto reopened = loaded(path);
    const auto report = saved(with_noise_layer(*reopened.document, 0), *reopened.images, path);
    EXPECT_EQ(report.warnings.size(), 1u);
    const Json json = Json::parse(read_text_file(path).value());
    EXPECT_EQ(json["materials"][0]["extras"], "mine");
}

}  // namespace
}  // namespace patina::io
