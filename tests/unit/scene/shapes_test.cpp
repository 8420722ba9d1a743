// SPDX-License-Identifier: MIT
#include "scene/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace patina {
namespace {

using Corners = std::array<std::uint32_t, 3>;

std::vector<Corners> triangles(const Primitive& primitive) {
    std::vector<Corners> result;
    for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3)
        result.push_back(
            {primitive.indices[i], primitive.indices[i + 1], primitive.indices[i + 2]});
    return result;
}

float cross(glm::vec2 a, glm::vec2 b) {
    return a.x * b.y - a.y * b.x;
}

/// How often each texel's middle is covered by the triangles' UVs.
std::vector<int> times_covered(const Primitive& primitive, int size) {
    std::vector<int> counts(static_cast<std::size_t>(size) * size);
    for (const auto& [a, b, c] : triangles(primitive)) {
        const auto& uv = primitive.uvs[0];
        const std::array<glm::vec2, 3> corner = {uv[a], uv[b], uv[c]};
        const glm::vec2 low = glm::min(corner[0], glm::min(corner[1], corner[2]));
        const glm::vec2 high = glm::max(corner[0], glm::max(corner[1], corner[2]));
        const glm::ivec2 first(glm::clamp(low, 0.0f, 1.0f) * static_cast<float>(size));
        const glm::ivec2 last(glm::clamp(high, 0.0f, 1.0f) * static_cast<float>(size));
        for (int y = first.y; y <= std::min(last.y, size - 1); ++y)
            for (int x = first.x; x <= std::min(last.x, size - 1); ++x) {
                const glm::vec2 middle = (glm::vec2(x, y) + 0.5f) / static_cast<float>(size);
                bool inside = true;
                for (std::size_t i = 0; i < 3; ++i)
                    inside = inside &&
                             cross(corner[(i + 1) % 3] - corner[i], middle - corner[i]) < -1e-9f;
                if (inside) ++counts[static_cast<std::size_t>(y) * size + x];
            }
    }
    return counts;
}

class ShapeMeshes : public testing::TestWithParam<ShapeInfo> {
  protected:
    Mesh mesh_ = shape_mesh(GetParam().shape);
};

TEST_P(ShapeMeshes, FillEveryAttributeWithFiniteUnitVectors) {
    for (const Primitive& primitive : mesh_.primitives) {
        const std::size_t count = primitive.positions.size();
        ASSERT_GT(count, 0u);
        ASSERT_EQ(primitive.normals.size(), count);
        ASSERT_EQ(primitive.tangents.size(), count);
        ASSERT_EQ(primitive.uvs[0].size(), count);
        ASSERT_EQ(primitive.indices.size() % 3, 0u);
        ASSERT_LT(*std::max_element(primitive.indices.begin(), primitive.indices.end()), count);
        for (std::size_t i = 0; i < count; ++i) {
            const glm::vec3 tangent(primitive.tangents[i]);
            EXPECT_NEAR(glm::length(primitive.normals[i]), 1.0f, 1e-4f);
            EXPECT_NEAR(glm::length(tangent), 1.0f, 1e-4f);
            EXPECT_NEAR(glm::dot(tangent, primitive.normals[i]), 0.0f, 1e-4f);
            EXPECT_EQ(primitive.tangents[i].w, 1.0f);
        }
    }
}

TEST_P(ShapeMeshes, FaceOutwardsAsTheirNormalsSay) {
    for (const Primitive& primitive : mesh_.primitives)
        for (const auto& [a, b, c] : triangles(primitive)) {
            const auto& p = primitive.positions;
            const glm::vec3 face = glm::cross(p[b] - p[a], p[c] - p[a]);
            ASSERT_GT(glm::length(face), 0.0f) << "a triangle without area";
            const glm::vec3 mean =
                primitive.normals[a] + primitive.normals[b] + primitive.normals[c];
            EXPECT_GT(glm::dot(glm::normalize(face), glm::normalize(mean)), 0.95f);
        }
}

// Where u grows on the surface is where the tangent points, and the bitangent is up the texture.
TEST_P(ShapeMeshes, HaveTheTangentsOfTheirUvs) {
    for (const Primitive& primitive : mesh_.primitives)
        for (const auto& [a, b, c] : triangles(primitive)) {
            const auto& p = primitive.positions;
            const auto& uv = primitive.uvs[0];
            const glm::vec2 uv_ab = uv[b] - uv[a];
            const glm::vec2 uv_ac = uv[c] - uv[a];
            const float area = cross(uv_ab, uv_ac);
            ASSERT_LT(area, 0.0f) << "counter-clockwise triangles turn so in UV space, v down";
            const glm::vec3 along_u = ((p[b] - p[a]) * uv_ac.y - (p[c] - p[a]) * uv_ab.y) / area;
            for (const std::uint32_t corner : {a, b, c})
                EXPECT_GT(glm::dot(glm::normalize(along_u), glm::vec3(primitive.tangents[corner])),
                          0.9f);
        }
}

TEST_P(ShapeMeshes, KeepTheirUvsWithinTheSquareAndOverlapNowhere) {
    constexpr int kSize = 512;
    for (const Primitive& primitive : mesh_.primitives) {
        for (const glm::vec2 uv : primitive.uvs[0]) {
            EXPECT_GE(std::min(uv.x, uv.y), 0.0f);
            EXPECT_LE(std::max(uv.x, uv.y), 1.0f);
        }
        const std::vector<int> coverage = times_covered(primitive, kSize);
        EXPECT_LE(*std::max_element(coverage.begin(), coverage.end()), 1);
        const auto used = std::count(coverage.begin(), coverage.end(), 1);
        EXPECT_GT(static_cast<double>(used), 0.4 * kSize * kSize) << "most of the map is wasted";
    }
}

// The map may be finer in one place than in another, but it is not stretched in one direction.
TEST_P(ShapeMeshes, AreNotStretchedByTheirUvs) {
    double area_total = 0.0;
    double area_stretched = 0.0;
    for (const Primitive& primitive : mesh_.primitives)
        for (const auto& [a, b, c] : triangles(primitive)) {
            const auto& p = primitive.positions;
            const auto& uv = primitive.uvs[0];
            const glm::vec2 d1 = uv[b] - uv[a];
            const glm::vec2 d2 = uv[c] - uv[a];
            const float det = cross(d1, d2);
            const glm::vec3 along_u = ((p[b] - p[a]) * d2.y - (p[c] - p[a]) * d1.y) / det;
            const glm::vec3 along_v = ((p[c] - p[a]) * d1.x - (p[b] - p[a]) * d2.x) / det;
            const float ratio = glm::length(along_u) / glm::length(along_v);
            const double area = glm::length(glm::cross(p[b] - p[a], p[c] - p[a]));
            area_total += area;
            if (ratio > 1.2f || ratio < 1.0f / 1.2f) area_stretched += area;
        }
    EXPECT_LT(area_stretched, 0.02 * area_total);
}

TEST_P(ShapeMeshes, StandOnTheGroundAndAreAboutAMetreAcross) {
    Bounds bounds;
    for (const Primitive& primitive : mesh_.primitives)
        for (const glm::vec3& position : primitive.positions) bounds.include(position);
    EXPECT_NEAR(bounds.low.y, 0.0f, 1e-4f);
    EXPECT_NEAR(bounds.high.x - bounds.low.x, 0.9f, 0.15f);
    EXPECT_LE(bounds.high.y, 1.36f);
}

TEST_P(ShapeMeshes, AreTheSameEveryTime) {
    const Mesh again = shape_mesh(GetParam().shape);
    for (std::size_t i = 0; i < mesh_.primitives.size(); ++i) {
        EXPECT_EQ(mesh_.primitives[i].positions, again.primitives[i].positions);
        EXPECT_EQ(mesh_.primitives[i].indices, again.primitives[i].indices);
    }
}

INSTANTIATE_TEST_SUITE_P(Shapes, ShapeMeshes, testing::ValuesIn(kShapes), [](const auto& entry) {
    std::string name(entry.param.label);
    std::erase(name, ' ');
    return name;
});

/// Edges, by the positions of their ends, that have no counterpart in the other direction.
std::size_t open_edges(const Primitive& primitive) {
    const auto key = [&](std::uint32_t corner) {
        const glm::vec3 p = primitive.positions[corner] * 1e5f;
        return std::tuple(std::lround(p.x), std::lround(p.y), std::lround(p.z));
    };
    using Key = decltype(key(0));
    std::map<std::pair<Key, Key>, int> balance;
    for (const auto& corners : triangles(primitive))
        for (std::size_t i = 0; i < 3; ++i) {
            const Key from = key(corners[i]);
            const Key to = key(corners[(i + 1) % 3]);
            if (from < to)
                ++balance[{from, to}];
            else
                --balance[{to, from}];
        }
    return static_cast<std::size_t>(
        std::count_if(balance.begin(), balance.end(), [](const auto& e) { return e.second != 0; }));
}

TEST(ShapeMesh, SolidsAreClosed) {
    for (const Shape shape : {Shape::Sphere, Shape::RoundedCube, Shape::Cylinder, Shape::Torus})
        EXPECT_EQ(open_edges(shape_mesh(shape).primitives[0]), 0u)
            << kShapes[static_cast<std::size_t>(shape)].id;
}

TEST(ShapeMesh, TheShaderBallKeepsHardEdgesHardAndRoundOnesSmooth) {
    const Primitive ball = shape_mesh(Shape::ShaderBall).primitives[0];
    // Vertices that share a place but not a normal make hard edges; seams share both.
    std::map<std::tuple<long, long, long>, std::vector<glm::vec3>> normals_at;
    for (std::size_t i = 0; i < ball.positions.size(); ++i) {
        const glm::vec3 p = ball.positions[i] * 1e5f;
        normals_at[{std::lround(p.x), std::lround(p.y), std::lround(p.z)}].push_back(
            ball.normals[i]);
    }
    std::size_t hard = 0;
    for (const auto& [place, normals] : normals_at)
        for (const glm::vec3& normal : normals)
            if (glm::dot(normal, normals.front()) < 0.9f) {
                ++hard;
                break;
            }
    // The foot of the dimple's wall and both feet of the groove's, 96 around each.
    EXPECT_EQ(hard, 3u * 96u);
}

}  // namespace
}  // namespace patina
