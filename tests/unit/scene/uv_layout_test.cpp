// SPDX-License-Identifier: MIT
#include "scene/uv_layout.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <random>

#include "scene/small_surface.h"

namespace patina {
namespace {

UvSurfacePtr laid_out(const std::vector<glm::vec2>& uvs, int uv_set = 0) {
    return surface_of({FlatPart{.uvs = uvs}}, uv_set);
}

std::vector<glm::vec2> joined(std::vector<glm::vec2> a, const std::vector<glm::vec2>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

TEST(UvLayout, AQuadOverTheWholeTextureUsesItOnce) {
    const UvLayout layout = uv_layout(*laid_out(uv_quad({0, 0}, {1, 1})), 64);
    EXPECT_EQ(layout.used, 1.0);
    EXPECT_EQ(layout.overlapped, 0.0);
    EXPECT_TRUE(layout.within_a_tile());
    EXPECT_EQ(layout.triangles, 2u);
}

TEST(UvLayout, WhatTwoQuadsShareIsOverlappedBeItMirroredOrATileAway) {
    const auto own = uv_quad({0.0f, 0.0f}, {0.5f, 1.0f});
    for (const auto& other :
         {uv_quad({0.25f, 0.0f}, {0.75f, 1.0f}), uv_quad({0.75f, 1.0f}, {0.25f, 0.0f}),
          uv_quad({0.75f, 0.0f}, {0.25f, 1.0f}), uv_quad({-2.75f, 3.0f}, {-2.25f, 4.0f})}) {
        const UvLayout layout = uv_layout(*laid_out(joined(own, other)), 64);
        EXPECT_EQ(layout.used, 0.75);
        EXPECT_NEAR(layout.overlapped, 1.0 / 3.0, 1e-12);
    }
    EXPECT_FALSE(uv_layout(*laid_out(uv_quad({-2.75f, 3.0f}, {-2.25f, 4.0f}))).within_a_tile());
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
        for (const std::uint8_t count : uv_coverage(*laid_out(uvs), 97).counts) ASSERT_EQ(count, 1);
    }
}

TEST(UvLayout, TrianglesWithoutUvsAreCountedApart) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const UvLayout broken = uv_layout(*laid_out({{0, 0}, {1, 0}, {nan, 1}}), 16);
    EXPECT_EQ(broken.without_uvs, 1u);
    EXPECT_EQ(broken.used, 0.0);
    EXPECT_EQ(uv_layout(*laid_out(uv_quad({0, 0}, {1, 1}), 1), 16).without_uvs, 2u);
}

TEST(UvLayout, WhatReachesOverManyTilesCoversAllOfThemSeveralTimes) {
    const UvLayout layout = uv_layout(*laid_out(uv_quad({0, 0}, {40, 30})), 16);
    EXPECT_EQ(layout.used, 1.0);
    EXPECT_EQ(layout.overlapped, 1.0);
}

TEST(UvLayout, SoManyLargeTrianglesThatItWouldTakeMinutesAreOnlyCounted) {
    std::vector<glm::vec2> uvs;
    for (int i = 0; i < 20000; ++i) uvs = joined(std::move(uvs), uv_quad({-3, -3}, {4, 4}));
    const UvLayout layout = uv_layout(*laid_out(uvs));
    EXPECT_FALSE(layout.measured);
    EXPECT_EQ(layout.triangles, 40000u);
    EXPECT_EQ(layout.high, glm::vec2(4.0f));
    EXPECT_EQ(laid_out(uvs)->map(1024), nullptr);
}

}  // namespace
}  // namespace patina
