// SPDX-License-Identifier: MIT
#include "document/uv_rows.h"

#include <gtest/gtest.h>

namespace patina {
namespace {

TEST(UvRows, QuarterTurnsAreExact) {
    for (const float degrees : {90.0f, -270.0f, 450.0f}) {
        const UvRows rows = uv_rows({.rotation_degrees = degrees});
        EXPECT_EQ(rows.u, glm::vec3(0.0f, 1.0f, 0.0f));
        EXPECT_EQ(rows.v, glm::vec3(-1.0f, 0.0f, 0.0f));
    }
    EXPECT_EQ(uv_rows({.rotation_degrees = 180.0f}).u, glm::vec3(-1.0f, 0.0f, 0.0f));
    EXPECT_EQ(uv_rows({}).v, glm::vec3(0.0f, 1.0f, 0.0f));
}

TEST(UvRows, ScaleComesBeforeRotationAndTheOffsetLast) {
    // As KHR_texture_transform multiplies its three matrices.
    const UvRows rows =
        uv_rows({.offset = {0.25f, 0.5f}, .scale = {2.0f, 3.0f}, .rotation_degrees = 30.0f});
    const float c = 0.8660254f, s = 0.5f;
    const glm::vec3 u(2.0f * c, 3.0f * s, 0.25f), v(-2.0f * s, 3.0f * c, 0.5f);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(rows.u[i], u[i], 1e-6f);
        EXPECT_NEAR(rows.v[i], v[i], 1e-6f);
    }
}

}  // namespace
}  // namespace patina
