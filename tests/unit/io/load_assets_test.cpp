// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <filesystem>

#include "io/load.h"

namespace patina::io {
namespace {

const std::filesystem::path kModels =
    std::filesystem::path(PATINA_SOURCE_DIR) / ".." / "shared" / "assets" / "models";

struct Expected {
    const char* file;
    std::size_t materials;
    std::size_t meshes;
    std::size_t instances;
    std::size_t triangles;  ///< of all meshes, each once
    std::size_t images;
};

class LoadAssets : public testing::TestWithParam<Expected> {};

TEST_P(LoadAssets, GivesTheCountsOfTheFile) {
    const auto path = kModels / GetParam().file;
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
    const auto loaded = load_document(path);
    ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
    const Document& document = *loaded->document;
    std::size_t triangles = 0;
    for (const Mesh& mesh : document.scene->meshes)
        for (const Primitive& primitive : mesh.primitives)
            triangles += primitive.indices.size() / 3;
    EXPECT_EQ(document.materials.size(), GetParam().materials);
    EXPECT_EQ(document.scene->meshes.size(), GetParam().meshes);
    EXPECT_EQ(document.scene->instances.size(), GetParam().instances);
    EXPECT_EQ(triangles, GetParam().triangles);
    EXPECT_EQ(document.images.size(), GetParam().images);
    EXPECT_TRUE(loaded->warnings.empty()) << loaded->warnings.front();
    EXPECT_FALSE(document.scene->bounds_world.empty());
    for (const auto& [hash, image] : document.images)
        EXPECT_TRUE(loaded->images->pixels(hash).has_value());
}

INSTANTIATE_TEST_SUITE_P(Models, LoadAssets,
                         testing::Values(Expected{"AnimatedMorphCube.glb", 1, 1, 1, 12, 0},
                                         Expected{"Avocado/Avocado.gltf", 1, 1, 1, 682, 3},
                                         Expected{"BoxVertexColors.glb", 1, 1, 1, 12, 0},
                                         Expected{"CesiumMan.glb", 1, 1, 1, 4672, 1},
                                         Expected{"CesiumMilkTruck.glb", 4, 2, 3, 2856, 1},
                                         Expected{"NormalTangentTest.glb", 1, 1, 1, 7774, 3},
                                         Expected{"Suzanne/Suzanne.gltf", 1, 1, 1, 3936, 2},
                                         Expected{"TextureSettingsTest.glb", 10, 10, 10, 72, 3},
                                         Expected{"TwoSidedPlane/TwoSidedPlane.gltf", 1, 1, 1, 2,
                                                  3}));

}  // namespace
}  // namespace patina::io
