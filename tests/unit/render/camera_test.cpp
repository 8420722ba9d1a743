// SPDX-License-Identifier: MIT
#include "render/camera.h"

#include <gtest/gtest.h>

#include <rapidcheck.h>

namespace patina::render {
namespace {

const Bounds kBox = {.low = {-1.0f, 0.0f, -0.5f}, .high = {2.0f, 1.5f, 0.5f}};

glm::vec3 clip_position(const Camera& camera, const Bounds& bounds, float aspect,
                        const glm::vec3& world) {
    const glm::vec4 clip = clip_from_view(camera, aspect, depth_range(camera, bounds)) *
                           view_from_world(camera) * glm::vec4(world, 1.0f);
    return glm::vec3(clip) / clip.w;
}

/// How far from the middle of the picture the corners lie at most; 1 is its edge.
float reach_of_corners(const Camera& camera, const Bounds& bounds, float aspect) {
    float reach = 0.0f;
    for (unsigned i = 0; i < 8; ++i) {
        const glm::vec3 corner((i & 1u) != 0 ? bounds.high.x : bounds.low.x,
                               (i & 2u) != 0 ? bounds.high.y : bounds.low.y,
                               (i & 4u) != 0 ? bounds.high.z : bounds.low.z);
        const glm::vec3 clip = clip_position(camera, bounds, aspect, corner);
        EXPECT_LE(std::abs(clip.z), 1.0f);
        reach = std::max({reach, std::abs(clip.x), std::abs(clip.y)});
    }
    return reach;
}

TEST(Camera, FramingShowsEveryCornerFromEveryDirection) {
    for (const ViewDirection direction :
         {ViewDirection::ThreeQuarter, ViewDirection::Front, ViewDirection::Back,
          ViewDirection::Left, ViewDirection::Right, ViewDirection::Top, ViewDirection::Bottom})
        for (const float aspect : {0.5f, 1.0f, 16.0f / 9.0f}) {
            const Camera camera = framed(kBox, aspect, direction);
            const float reach = reach_of_corners(camera, kBox, aspect);
            EXPECT_LE(reach, 0.92f);
            EXPECT_GE(reach, 0.85f) << "no larger margin than needed";
        }
}

/// Metres from bottom to top of the picture where the target is.
float height_of_view(const Camera& camera) {
    if (camera.orthographic_height > 0.0f) return camera.orthographic_height;
    return 2.0f * glm::distance(camera.position, camera.target) *
           std::tan(0.5f * glm::radians(camera.fov_y_degrees));
}

TEST(Camera, AnotherFieldOfViewOrProjectionLeavesTheTargetAsLargeAsItWas) {
    const Camera camera = framed(kBox, 1.5f);
    for (const float fov : {5.0f, 30.0f, 120.0f}) {
        const Camera wider = with_fov(camera, fov);
        EXPECT_FLOAT_EQ(wider.fov_y_degrees, fov);
        EXPECT_NEAR(height_of_view(wider), height_of_view(camera), 1e-4f);
        const Camera flat = with_other_projection(wider);
        EXPECT_GT(flat.orthographic_height, 0.0f);
        EXPECT_NEAR(height_of_view(flat), height_of_view(camera), 1e-4f);
        const Camera back = with_other_projection(dollied(flat, 1.0f));
        EXPECT_EQ(back.orthographic_height, 0.0f);
        EXPECT_NEAR(height_of_view(back), 0.5f * height_of_view(camera), 1e-4f);
    }
}

TEST(Camera, LooksFromAnotherDirectionInTheProjectionThatItHad) {
    const Camera flat = with_other_projection(framed(kBox, 1.5f, ViewDirection::Front, 50.0f));
    const Camera top = framed_from_direction(flat, kBox, 1.5f, ViewDirection::Top);
    EXPECT_GT(top.position.y, kBox.high.y);
    EXPECT_FLOAT_EQ(top.fov_y_degrees, 50.0f);
    EXPECT_NEAR(top.orthographic_height, 1.1f * 3.0f / 1.5f, 0.05f);
}

TEST(Camera, FrontLooksAlongMinusZWithYUp) {
    const Camera camera = framed(kBox, 1.0f, ViewDirection::Front);
    const glm::vec3 right =
        clip_position(camera, kBox, 1.0f, kBox.center() + glm::vec3(0.1f, 0, 0));
    const glm::vec3 above =
        clip_position(camera, kBox, 1.0f, kBox.center() + glm::vec3(0, 0.1f, 0));
    EXPECT_GT(right.x, 0.0f);
    EXPECT_NEAR(right.y, 0.0f, 1e-5f);
    EXPECT_GT(above.y, 0.0f);
    EXPECT_GT(camera.position.z, kBox.high.z);
}

TEST(Camera, OrbitKeepsTheDistanceToTheTarget) {
    EXPECT_TRUE(rc::check("distance is kept", [] {
        const Camera before = framed(kBox, 1.0f);
        const auto degrees = [] { return static_cast<float>(*rc::gen::inRange(-400, 400)); };
        const Camera after = orbited(before, degrees(), degrees());
        RC_ASSERT(std::abs(glm::distance(after.position, after.target) -
                           glm::distance(before.position, before.target)) < 1e-4f);
        RC_ASSERT(after.target == before.target);
    }));
}

TEST(Camera, OrbitByPositiveYawGoesCounterClockwiseFromAbove) {
    const Camera front = framed(kBox, 1.0f, ViewDirection::Front);
    EXPECT_GT(orbited(front, 90.0f, 0.0f).position.x, kBox.high.x);
}

TEST(Camera, OrbitStopsShortOfThePoles) {
    const Camera camera = orbited(framed(kBox, 1.0f), 0.0f, 500.0f);
    const glm::vec3 offset = glm::normalize(camera.position - camera.target);
    EXPECT_GT(offset.y, 0.99f);
    EXPECT_LT(offset.y, 1.0f);
}

TEST(Camera, ATurntableTurnsWhatIsUpInThePictureToo) {
    const Camera lying = {
        .position = {0.0f, 1.0f, 5.0f}, .target = {0.0f, 1.0f, 0.0f}, .up = {1.0f, 0.0f, 0.0f}};
    const Camera quarter = turned(lying, 90.0f);
    EXPECT_NEAR(glm::distance(quarter.position, glm::vec3(5.0f, 1.0f, 0.0f)), 0.0f, 1e-5f);
    EXPECT_NEAR(glm::distance(quarter.up, glm::vec3(0.0f, 0.0f, -1.0f)), 0.0f, 1e-6f);
    // What turns with the camera stays where it was in the picture.
    const glm::vec3 seen = glm::vec3(view_from_world(lying) * glm::vec4(0.3f, 1.2f, 0.1f, 1.0f));
    const glm::vec3 after =
        glm::vec3(view_from_world(quarter) * glm::vec4(0.1f, 1.2f, -0.3f, 1.0f));
    EXPECT_NEAR(glm::distance(seen, after), 0.0f, 1e-5f);
}

TEST(Camera, PannedByHalfTheHeightPutsTheOldTargetAtTheEdge) {
    const Camera before = framed(kBox, 1.0f, ViewDirection::Front);
    const Camera after = panned(before, 0.0f, 0.5f);
    EXPECT_NEAR(clip_position(after, kBox, 1.0f, before.target).y, 1.0f, 1e-4f);
}

TEST(Camera, OneDollyStepHalvesTheDistance) {
    const Camera before = framed(kBox, 1.0f);
    const Camera after = dollied(before, 1.0f);
    EXPECT_NEAR(glm::distance(after.position, after.target),
                0.5f * glm::distance(before.position, before.target), 1e-5f);
}

TEST(Camera, FramingAroundAnotherTargetShowsEveryCornerAndKeepsTargetAndUp) {
    Camera aimed;
    aimed.target = kBox.high;
    aimed.position = kBox.high + glm::vec3(1.0f, 0.5f, 2.0f);
    aimed.up = glm::normalize(glm::vec3(1.0f, 1.0f, 0.0f));
    const Camera camera = framed_around(aimed, kBox, 1.5f);
    EXPECT_EQ(camera.target, aimed.target);
    EXPECT_EQ(camera.up, aimed.up);
    const float reach = reach_of_corners(camera, kBox, 1.5f);
    EXPECT_LE(reach, 0.92f);
    EXPECT_GE(reach, 0.85f) << "no farther than needed";
}

TEST(Camera, OneOfTheFileThatIsScaledToNothingStillLooksSomewhere) {
    SceneCamera flat;
    flat.world_from_camera = glm::mat4(0.0f);
    flat.world_from_camera[3] = glm::vec4(0.0f, 0.0f, 4.0f, 1.0f);
    flat.fov_y_radians = 3.1f;
    const Camera camera = camera_of(flat, kBox);
    EXPECT_EQ(camera.position, glm::vec3(0.0f, 0.0f, 4.0f));
    EXPECT_LT(camera.target.z, 4.0f);
    EXPECT_EQ(camera.up, glm::vec3(0.0f, 1.0f, 0.0f));
    EXPECT_LE(camera.fov_y_degrees, 160.0f);
}

TEST(Camera, AFlatSceneLiesBetweenThePlanesOfACameraThatFacesIt) {
    const Bounds flat = {.low = {-1.0f, -1.0f, 0.0f}, .high = {1.0f, 1.0f, 0.0f}};
    const Camera perspective = framed(flat, 1.0f, ViewDirection::Front);
    for (const Camera& camera : {perspective, with_other_projection(perspective),
                                 dollied(perspective, 8.0f), dollied(perspective, -8.0f)}) {
        const DepthRange range = depth_range(camera, flat);
        EXPECT_LT(range.near_m, 0.9999f * camera.position.z);
        EXPECT_GT(range.far_m, 1.0001f * camera.position.z);
        EXPECT_LT(std::abs(clip_position(camera, flat, 1.0f, {0.5f, 0.0f, 0.0f}).z), 0.999f);
    }
}

TEST(Camera, AMetreTakesAsManyPixelsAsItIsLongInThePicture) {
    const Camera perspective = framed(kBox, 1.0f, ViewDirection::Front);
    for (const Camera& camera : {perspective, with_other_projection(perspective)}) {
        const glm::vec3 low = clip_position(camera, kBox, 1.0f, {0.0f, 0.25f, 0.5f});
        const glm::vec3 high = clip_position(camera, kBox, 1.0f, {0.0f, 1.25f, 0.5f});
        const float distance = camera.position.z - 0.5f;
        EXPECT_NEAR(pixels_per_metre(camera, 720, distance), 360.0f * (high.y - low.y), 0.1f);
    }
}

TEST(Camera, EmptyBoundsAreFramedAsAUnitBall) {
    EXPECT_EQ(framed(Bounds{}, 1.0f).target, glm::vec3(0.0f));
    EXPECT_GT(glm::length(framed(Bounds{}, 1.0f).position), 1.0f);
}

}  // namespace
}  // namespace patina::render
