// SPDX-License-Identifier: MIT
#include "scene/uv_layout.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <random>

namespace patina {
namespace {

/// A scene of one primitive with these UVs, three a triangle.
Scene scene_of(const std::vector<glm::vec2>& uvs, int material = 0) {
    Primitive primitive;
    primitive.source_material = material;
    primitive.uvs[0] = uvs;
    for (std::uint32_t i = 0; i < uvs.size(); ++i) primitive.indices.push_back(i);
    Scene scene;
    scene.meshes = {Mesh{.name = "mesh", .primitives = {primitive}}};
    return scene;
}

/// Two triangles.
std::vector<glm::vec2> quad(const glm::vec2& low, const glm::vec2& high) {
    return {low, {high.x, low.y}, high, low, high, {low.x, high.y}};
}

std::vector<glm::vec2> joined(std::vector<glm::vec2> a, const std::vector<glm::vec2>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

TEST(UvLayout, AQuadOverTheWholeTextureUsesItOnce) {
    const UvLayout layout = uv_layout(scene_of(quad({0, 0}, {1, 1})), 0, 0, 64);
    EXPECT_EQ(layout.used, 1.0);
    EXPECT_EQ(layout.overlapped, 0.0);
    EXPECT_TRUE(layout.within_a_tile());
    EXPECT_EQ(layout.triangles, 2u);
}

TEST(UvLayout, WhatTwoQuadsShareIsOverlappedBeItMirroredOrATileAway) {
    const auto own = quad({0.0f, 0.0f}, {0.5f, 1.0f});
    for (const auto& other :
         {quad({0.25f, 0.0f}, {0.75f, 1.0f}), quad({0.75f, 1.0f}, {0.25f, 0.0f}),
          quad({0.75f, 0.0f}, {0.25f, 1.0f}), quad({-2.75f, 3.0f}, {-2.25f, 4.0f})}) {
        const UvLayout layout = uv_layout(scene_of(joined(own, other)), 0, 0, 64);
        EXPECT_EQ(layout.used, 0.75);
        EXPECT_NEAR(layout.overlapped, 1.0 / 3.0, 1e-12);
    }
    EXPECT_FALSE(uv_layout(scene_of(quad({-2.75f, 3.0f}, {-2.25f, 4.0f})), 0, 0).within_a_tile());
}

/// A net over the square, its knots moved at random.
TEST(UvLayout, TrianglesThatShareEdgesShareNoTexel) {
    constexpr int kCells = 12;
    std::mt19937 random(7);
    const auto moved = [&](int i) {
        const float shift = static_cast<float>(random() % 1000) / 1000.0f * 0.4f - 0.2f;
        return (static_cast<float>(i) + (i % kCells == 0 ? 0.0f : shift)) / kCells;
    };
    for (int round = 0; round < 50; ++round) {
        std::array<std::array<glm::vec2, kCells + 1>, kCells + 1> knots;
        for (int y = 0; y <= kCells; ++y)
            for (int x = 0; x <= kCells; ++x)
                knots[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] = {moved(x),
                                                                                   moved(y)};
        std::vector<glm::vec2> uvs;
        for (std::size_t y = 0; y < kCells; ++y)
            for (std::size_t x = 0; x < kCells; ++x) {
                const glm::vec2 a = knots[y][x], b = knots[y][x + 1];
                const glm::vec2 c = knots[y + 1][x + 1], d = knots[y + 1][x];
                uvs.insert(uvs.end(), {a, b, c, d, a, c});
            }
        for (const std::uint8_t count : uv_coverage(scene_of(uvs), 0, 0, 97).counts)
            ASSERT_EQ(count, 1);
    }
}

TEST(UvLayout, OtherMaterialsAndTrianglesWithoutUvsDoNotCount) {
    EXPECT_EQ(uv_layout(scene_of(quad({0, 0}, {1, 1}), 3), 0, 0, 16).triangles, 0u);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const UvLayout broken = uv_layout(scene_of({{0, 0}, {1, 0}, {nan, 1}}), 0, 0, 16);
    EXPECT_EQ(broken.without_uvs, 1u);
    EXPECT_EQ(broken.used, 0.0);
    EXPECT_EQ(uv_layout(scene_of(quad({0, 0}, {1, 1})), 0, 1, 16).without_uvs, 2u);
}

TEST(UvLayout, WhatReachesOverManyTilesCoversAllOfThemSeveralTimes) {
    const UvLayout layout = uv_layout(scene_of(quad({0, 0}, {40, 30})), 0, 0, 16);
    EXPECT_EQ(layout.used, 1.0);
    EXPECT_EQ(layout.overlapped, 1.0);
}

}  // namespace
}  // namespace patina
