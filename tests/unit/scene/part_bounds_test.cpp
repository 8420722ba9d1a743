// SPDX-License-Identifier: MIT
#include "scene/part_bounds.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

namespace patina {
namespace {

Primitive triangle(PartRef source) {
    Primitive primitive;
    // The last corner is of no triangle.
    primitive.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {9, 9, 9}};
    primitive.indices = {0, 1, 2};
    primitive.source = source;
    return primitive;
}

TEST(PartBounds, HoldEveryInstanceOfThePartsAndNothingElse) {
    Scene scene;
    scene.meshes = {{.name = "a", .primitives = {triangle({0, 0}), triangle({0, 1})}},
                    {.name = "b", .primitives = {triangle({1, 0})}}};
    const auto moved = [](float x) { return glm::translate(glm::mat4(1.0f), {x, 0, 0}); };
    scene.instances = {{.mesh = 0, .world_from_local = moved(2), .name = {}},
                       {.mesh = 0, .world_from_local = moved(-3), .name = {}},
                       {.mesh = 1, .world_from_local = moved(50), .name = {}}};
    const Bounds bounds = bounds_world_of(scene, {{0, 1}});
    EXPECT_EQ(bounds.low, glm::vec3(-3, 0, 0));
    EXPECT_EQ(bounds.high, glm::vec3(3, 1, 0));
    EXPECT_TRUE(bounds_world_of(scene, {{7, 0}}).empty());
}

}  // namespace
}  // namespace patina
