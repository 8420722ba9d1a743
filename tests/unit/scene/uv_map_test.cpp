// SPDX-License-Identifier: MIT
#include "scene/uv_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/parallel.h"
#include "scene/small_surface.h"

namespace patina {
namespace {

/// Triangles of any size, some of them across the border of the texture.
UvSurfacePtr random_surface(unsigned seed, int triangles) {
    std::mt19937 random(seed);
    const auto number = [&] { return static_cast<float>(random() % 4096) / 4096.0f; };
    FlatPart part;
    for (int i = 0; i < triangles; ++i) {
        const glm::vec2 middle(number() * 1.4f - 0.2f, number() * 1.4f - 0.2f);
        const float side = number() * number() * 0.3f;
        for (int k = 0; k < 3; ++k)
            part.uvs.push_back(middle + side * glm::vec2(number() - 0.5f, number() - 0.5f));
    }
    return surface_of({part});
}

int apart(int a, int b, int size) {
    const int distance = std::abs(a - b);
    return std::min(distance, size - distance);
}

/// Whether a place lies on the same side of all three edges.
bool holds(const UvCorners& corners, const glm::dvec2& place) {
    bool any_below = false, any_above = false;
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec2 from = corners[k], to = corners[(k + 1) % 3];
        const double side =
            (to.x - from.x) * (place.y - from.y) - (to.y - from.y) * (place.x - from.x);
        any_below = any_below || side < 0;
        any_above = any_above || side > 0;
    }
    return !(any_below && any_above);
}

TEST(UvMap, ATexelThatNoTriangleTouchesAnswersForTheNearestThatOneDoesAcrossTheBorders) {
    for (unsigned seed = 0; seed < 8; ++seed) {
        const int size = 15 + 4 * static_cast<int>(seed);
        const UvMapPtr map = random_surface(seed, 1 + static_cast<int>(seed) % 5)->map(size);
        if (map == nullptr) continue;
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                int least = size * size;
                for (int other_y = 0; other_y < size; ++other_y)
                    for (int other_x = 0; other_x < size; ++other_x) {
                        if (!map->touched(other_x, other_y)) continue;
                        const int dx = apart(x, other_x, size), dy = apart(y, other_y, size);
                        least = std::min(least, dx * dx + dy * dy);
                    }
                const UvMap::Texel texel = map->at(x, y);
                const int dx = apart(x, texel.x, size), dy = apart(y, texel.y, size);
                ASSERT_EQ(dx * dx + dy * dy, least) << seed << ": " << x << ", " << y;
                ASSERT_TRUE(map->touched(texel.x, texel.y));
                ASSERT_EQ(map->at(texel.x, texel.y).triangle, texel.triangle);
            }
    }
}

TEST(UvMap, EveryTexelThatATriangleReachesIntoIsTouchedAndNoOther) {
    constexpr int kSize = 16;
    constexpr int kSamples = 12;
    for (unsigned seed = 0; seed < 10; ++seed) {
        const UvSurfacePtr surface = random_surface(seed, 3);
        const UvMapPtr map = surface->map(kSize);
        ASSERT_NE(map, nullptr);
        const auto reached = [&](int x, int y) {
            for (std::uint32_t triangle = 0; triangle < surface->triangle_count(); ++triangle)
                for (int sample = 0; sample < kSamples * kSamples; ++sample)
                    for (int tile = 0; tile < 9; ++tile) {
                        const glm::dvec2 inside((sample % kSamples + 0.5) / kSamples,
                                                (sample / kSamples + 0.5) / kSamples);
                        const glm::dvec2 place = (glm::dvec2(x, y) + inside) / double{kSize} +
                                                 glm::dvec2(tile % 3 - 1, tile / 3 - 1);
                        if (holds(*surface->corners_of(triangle), place)) return true;
                    }
            return false;
        };
        int only_touched = 0, touched = 0;
        for (int y = 0; y < kSize; ++y)
            for (int x = 0; x < kSize; ++x) {
                const bool is_reached = reached(x, y);
                if (is_reached) {
                    ASSERT_TRUE(map->touched(x, y)) << seed << ": " << x << ", " << y;
                }
                touched += map->touched(x, y);
                only_touched += map->touched(x, y) && !is_reached;
            }
        // Slivers between the samples, and corners rounded to steps.
        EXPECT_LE(only_touched, 3 + touched / 20) << seed;
    }
}

TEST(UvMap, ATexelShowsATriangleThatHoldsItsMiddleWhereThereIsOne) {
    // One that only touches is the first in the list; the second has the middles.
    const UvMapPtr map = surface_of({{.uvs = {{0.0f, 0.0f}, {0.3f, 0.0f}, {0.0f, 0.3f}}},
                                     {.uvs = uv_quad({0.1f, 0.1f}, {1.0f, 1.0f})}})
                             ->map(4);
    EXPECT_EQ(map->at(0, 0).triangle, 0u);
    EXPECT_GE(map->at(1, 0).triangle, 1u);
    EXPECT_GE(map->at(1, 1).triangle, 1u);
}

TEST(UvMap, IsTheSameWithAnyNumberOfThreads) {
    const UvSurfacePtr surface = random_surface(99, 40);
    const auto with = [&](int threads) {
        const ThreadLimit limit(threads);
        const UvMapPtr map = UvMap::make(*surface, 300);
        Hasher hasher;
        for (int y = 0; y < 300; ++y)
            for (int x = 0; x < 300; ++x) {
                const UvMap::Texel texel = map->at(x, y);
                hasher.add(texel.triangle).add(texel.x).add(texel.y);
            }
        return hasher.finish();
    };
    EXPECT_EQ(with(1), with(2));
    EXPECT_EQ(with(1), with(16));
}

TEST(UvMap, IsKeptWhileItIsInUse) {
    const UvSurfacePtr surface = random_surface(3, 3);
    EXPECT_EQ(surface->map(64), surface->map(64));
    EXPECT_EQ(surface->map(64)->size(), 64);
}

TEST(UvMap, ASurfaceWithoutUvsHasNone) {
    const UvSurfacePtr surface = surface_of({{.uvs = uv_quad({0, 0}, {1, 1})}}, 1);
    EXPECT_FALSE(surface->has_uvs());
    EXPECT_EQ(surface->triangle_count(), 2u);
    EXPECT_EQ(surface->map(16), nullptr);
}

TEST(UvSurface, PlacesAreThoseOfTheSceneWithItsLongestSideAsOne) {
    // 4 wide, 2 high: centred in 0..1, and 0.5 high.
    FlatPart quad = front_quad({10, 0}, {14, 2}, 3, {0, 0}, {1, 1});
    const UvSurfacePtr surface = surface_of({quad});
    for (const glm::vec2 uv : {glm::vec2(0.1f, 0.6f), glm::vec2(0.8f, 0.3f)}) {
        const std::uint32_t triangle = uv.y > 1 - uv.x ? 0 : 1;
        const SurfacePoint point = surface->point_at(triangle, uv.x, uv.y);
        EXPECT_NEAR(point.position.x, uv.x, 1e-6f);
        EXPECT_NEAR(point.position.y, 0.75f - 0.5f * uv.y, 1e-6f);
        EXPECT_NEAR(point.position.z, 0.5f, 1e-6f);
        EXPECT_EQ(point.normal, glm::vec3(0, 0, 1));
        EXPECT_EQ(point.tangent, glm::vec3(1, 0, 0));
        EXPECT_EQ(point.bitangent, glm::vec3(0, 1, 0));
    }
    // What is 1 long in the texture is sqrt(1 x 0.5) in the model.
    EXPECT_NEAR(surface->length_per_uv(), std::sqrt(0.5f), 1e-6f);
}

TEST(UvSurface, FramesStandAtRightAnglesAndFollowTheUvsHoweverPartsAreTurnedAndMirrored) {
    std::mt19937 random(5);
    const auto number = [&] { return static_cast<float>(random() % 2001) / 1000.0f - 1.0f; };
    for (int round = 0; round < 40; ++round) {
        FlatPart part{.uvs = {{number(), number()}, {number(), number()}, {number(), number()}}};
        for (int k = 0; k < 3; ++k) part.places.push_back({number(), number(), number()});
        for (int column = 0; column < 3; ++column)
            for (int row = 0; row < 3; ++row) part.world_from_local[column][row] += 0.5f * number();
        if (round % 2 == 0) part.world_from_local[0] *= -1.0f;
        const UvSurfacePtr surface = surface_of({part});
        const glm::vec2 middle = (part.uvs[0] + part.uvs[1] + part.uvs[2]) / 3.0f;
        const auto at = [&](float du, float dv) {
            return surface->point_at(0, static_cast<double>(middle.x + du),
                                     static_cast<double>(middle.y + dv));
        };
        const SurfacePoint point = at(0, 0);
        EXPECT_NEAR(glm::dot(point.normal, point.tangent), 0, 1e-4f);
        EXPECT_NEAR(glm::dot(point.normal, point.bitangent), 0, 1e-4f);
        EXPECT_NEAR(glm::dot(point.tangent, point.bitangent), 0, 1e-4f);
        EXPECT_NEAR(glm::length(point.bitangent), 1, 1e-4f);
        const float step = 1e-3f;
        EXPECT_GT(glm::dot(at(step, 0).position - point.position, point.tangent), 0.0f);
        const glm::vec3 up = point.position - at(0, step).position;
        const glm::vec3 side = at(step, 0).position - point.position;
        // -v turns from u as the bitangent does from the tangent.
        const float turn = glm::dot(glm::cross(side, up), point.normal);
        const float frame_turn = glm::dot(glm::cross(point.tangent, point.bitangent), point.normal);
        EXPECT_GT(turn * frame_turn, 0.0f) << round;
        // The front is where the corners turn counter-clockwise as the file has them.
        const auto world = [&](int k) {
            return glm::vec3(part.world_from_local *
                             glm::vec4(part.places[static_cast<std::size_t>(k)], 1.0f));
        };
        const glm::vec3 face = glm::cross(world(1) - world(0), world(2) - world(0));
        const float mirrored = glm::determinant(part.world_from_local) < 0 ? -1.0f : 1.0f;
        EXPECT_GT(mirrored * glm::dot(face, point.normal), 0.0f) << round;
    }
}

}  // namespace
}  // namespace patina
