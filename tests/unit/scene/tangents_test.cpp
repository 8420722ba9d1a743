// SPDX-License-Identifier: MIT
#include "scene/tangents.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "io/load.h"
#include "scene/normals.h"

namespace patina {
namespace {

/// Two triangles that make the unit square in the xy plane, facing +z, with v down as in glTF.
Primitive square() {
    Primitive primitive;
    primitive.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    primitive.normals.assign(4, glm::vec3(0, 0, 1));
    primitive.uvs[0] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    primitive.indices = {0, 1, 2, 0, 2, 3};
    return primitive;
}

float angle_degrees(const glm::vec4& a, const glm::vec4& b) {
    const float cosine = glm::dot(glm::vec3(a), glm::vec3(b));
    return glm::degrees(std::acos(std::min(1.0f, std::max(-1.0f, cosine))));
}

TEST(Tangents, OfASquareRunAlongUAndUpTheTexture) {
    Primitive primitive = square();
    generate_tangents(primitive, 0);
    ASSERT_EQ(primitive.positions.size(), 4u);
    for (const glm::vec4& tangent : primitive.tangents) {
        EXPECT_NEAR(tangent.x, 1.0f, 1e-6f);
        // Up in the texture is +y here: w * cross(z, x) = +y.
        EXPECT_EQ(tangent.w, 1.0f);
    }
}

TEST(Tangents, OfAMirroredChartAreTurned) {
    Primitive primitive = square();
    for (glm::vec2& uv : primitive.uvs[0]) uv.x = 1.0f - uv.x;
    generate_tangents(primitive, 0);
    for (const glm::vec4& tangent : primitive.tangents) {
        EXPECT_NEAR(tangent.x, -1.0f, 1e-6f);
        EXPECT_EQ(tangent.w, -1.0f);
    }
}

TEST(Tangents, SplitAVertexWhereMirroredChartsMeet) {
    // A third triangle on the edge x = 1 whose UVs come back: u falls where x grows.
    Primitive primitive = square();
    primitive.positions.push_back({2, 0, 0});
    primitive.normals.push_back({0, 0, 1});
    primitive.uvs[0].push_back({0, 1});
    primitive.indices.insert(primitive.indices.end(), {1, 4, 2});
    generate_tangents(primitive, 0);
    EXPECT_EQ(primitive.positions.size(), 7u);  // vertices 1 and 2 twice
    EXPECT_EQ(primitive.tangents.size(), 7u);
    EXPECT_EQ(primitive.uvs[0].size(), 7u);
    for (std::size_t corner = 0; corner < 6; ++corner)
        EXPECT_GT(primitive.tangents[primitive.indices[corner]].x, 0.9f);
    for (std::size_t corner = 6; corner < 9; ++corner)
        EXPECT_LT(primitive.tangents[primitive.indices[corner]].x, -0.9f);
}

TEST(Tangents, OfTrianglesWithoutUvAreaAreUnitAndAcrossTheNormal) {
    Primitive primitive = square();
    primitive.uvs[0].assign(4, glm::vec2(0.5f));
    generate_tangents(primitive, 0);
    for (std::size_t i = 0; i < primitive.tangents.size(); ++i) {
        const glm::vec3 tangent(primitive.tangents[i]);
        EXPECT_NEAR(glm::length(tangent), 1.0f, 1e-6f);
        EXPECT_NEAR(glm::dot(tangent, primitive.normals[i]), 0.0f, 1e-6f);
        EXPECT_EQ(std::abs(primitive.tangents[i].w), 1.0f);
    }
}

TEST(Tangents, OfATriangleWithTwoCornersAtOnePlaceAreThoseOfItsNeighbours) {
    Primitive primitive = square();
    primitive.positions.push_back(primitive.positions[0]);
    primitive.normals.push_back(primitive.normals[0]);
    primitive.uvs[0].push_back(primitive.uvs[0][0]);
    primitive.indices.insert(primitive.indices.end(), {4, 0, 1});
    generate_tangents(primitive, 0);
    EXPECT_NEAR(primitive.tangents[4].x, 1.0f, 1e-6f);
}

TEST(Tangents, TakeTimeInProportionToTheTrianglesEvenOnOneSharedEdge) {
    // 200 000 triangles on one edge: pairing each with each would take minutes.
    Primitive primitive;
    constexpr std::uint32_t kTriangles = 200'000;
    primitive.positions = {{0, 0, 0}, {1, 0, 0}};
    primitive.uvs[0] = {{0, 0}, {1, 0}};
    for (std::uint32_t i = 0; i < kTriangles; ++i) {
        const float at = static_cast<float>(i + 1);
        primitive.positions.emplace_back(0.0f, 1.0f, at);
        primitive.uvs[0].emplace_back(0.0f, at);
        primitive.indices.insert(primitive.indices.end(), {0, 1, i + 2});
    }
    primitive.normals.assign(primitive.positions.size(), glm::vec3(0, 0, 1));
    generate_tangents(primitive, 0);
    EXPECT_EQ(primitive.indices.size(), 3u * kTriangles);
}

struct ReferenceModel {
    const char* model;
    const char* tangents;  ///< in mikktspace/, for each corner x, y, z and w as signed bytes of 127
};

/// What the mikktspace package of npm, version 1.1.1 (the published code, compiled), makes of
/// models without their tangents; w is turned to glTF's convention. A byte rounds by 0.4 degrees.
class MikkTSpaceReference : public testing::TestWithParam<ReferenceModel> {};

TEST_P(MikkTSpaceReference, IsMetWithinADegreeAtNearlyAllCorners) {
    const std::filesystem::path source = PATINA_SOURCE_DIR;
    const auto path = source / ".." / "shared" / "assets" / "models" / GetParam().model;
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
    const auto loaded = io::load_document(path);
    ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
    const auto reference =
        read_file(source / "tests" / "unit" / "scene" / "mikktspace" / GetParam().tangents);
    ASSERT_TRUE(reference.has_value()) << reference.error().message;

    Primitive made = loaded->document->scene->meshes.front().primitives.front();
    made.tangents.clear();
    generate_tangents(made, 0);
    ASSERT_EQ(4 * made.indices.size(), reference->size());
    std::size_t equal = 0;
    for (std::size_t i = 0; i < made.indices.size(); ++i) {
        glm::vec4 expected;
        for (int axis = 0; axis < 4; ++axis)
            expected[axis] = std::to_integer<std::int8_t>((*reference)[4 * i + axis]);
        const glm::vec4 unit(glm::normalize(glm::vec3(expected)), expected.w);
        const glm::vec4& tangent = made.tangents[made.indices[i]];
        if (tangent.w == unit.w && angle_degrees(tangent, unit) <= 1.0f) ++equal;
    }
    EXPECT_GE(static_cast<double>(equal), 0.99 * static_cast<double>(made.indices.size()));
}

INSTANTIATE_TEST_SUITE_P(Models, MikkTSpaceReference,
                         testing::Values(ReferenceModel{"Avocado/Avocado.gltf", "avocado.bin"},
                                         ReferenceModel{"Suzanne/Suzanne.gltf", "suzanne.bin"},
                                         ReferenceModel{"CesiumMan.glb", "cesium_man.bin"}));

TEST(Normals, OfAMeshWithoutAnyAreFlat) {
    Primitive primitive = square();
    primitive.normals.clear();
    primitive.positions[3].z = 1.0f;
    make_flat_normals(primitive);
    EXPECT_EQ(primitive.positions.size(), 6u);
    EXPECT_EQ(primitive.normals[0], glm::vec3(0, 0, 1));
    EXPECT_EQ(primitive.normals[3], primitive.normals[5]);
    EXPECT_NE(primitive.normals[3], primitive.normals[0]);
}

TEST(Normals, OfNoLengthBecomeThoseOfTheTrianglesAround) {
    Primitive primitive = square();
    primitive.normals[1] = glm::vec3(0.0f);
    primitive.normals[2] = glm::vec3(0, 0, 5);
    repair_normals(primitive);
    for (const glm::vec3& normal : primitive.normals) EXPECT_EQ(normal, glm::vec3(0, 0, 1));
}

}  // namespace
}  // namespace patina
