// SPDX-License-Identifier: MIT

/// The floor of the studio: what a model hides from it of the sky, of suns and of lamps.

#include "render/ground_shadow.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/constants.hpp>

#include "render/render_test.h"

namespace patina::render {
namespace {

/// Black but for a patch in that direction, some ten degrees wide.
RadianceMap patch_towards(const glm::vec3& direction) {
    RadianceMap map{128, 64, std::vector<glm::vec3>(std::size_t{128} * 64, glm::vec3(0.0f))};
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x)
            if (glm::dot(texel_direction(map, x, y), glm::normalize(direction)) > 0.99f)
                map.texels[static_cast<std::size_t>(y * map.width + x)] = glm::vec3(5.0f);
    return map;
}

GroundShadow shadow_of_sphere() {
    Bounds bounds;
    bounds.include({-0.5f, 0.0f, -0.5f});
    bounds.include({0.5f, 1.0f, 0.5f});
    const Mesh sphere = shape_mesh(Shape::Sphere);
    return ground_shadow({{.primitive = &sphere.primitives[0]}}, bounds);
}

/// What reaches the floor at a place beside the sphere's foot, 0 to 1.
float light_at(const GroundShadow& shadow, const std::vector<std::uint8_t>& light, float x,
               float z) {
    const auto texel = [&](float metres) {
        return static_cast<std::size_t>((metres / shadow.extent * 0.5f + 0.5f) *
                                        static_cast<float>(shadow.side));
    };
    return static_cast<float>(light[texel(z) * static_cast<std::size_t>(shadow.side) + texel(x)]) /
           255.0f;
}

TEST(GroundShadow, TheSharesOfASkyAddUpToOneAndLieWhereItsLightIs) {
    const SkyShares shares = sky_shares(patch_towards({1.0f, 1.0f, 0.0f}), {});
    float total = 0.0f;
    float there = 0.0f;
    for (std::size_t a = 0; a < kSkyAzimuths; ++a)
        for (std::size_t k = 0; k < kSkyBands; ++k) {
            total += shares[a][k];
            // Towards +X is the middle of the azimuths; 45 degrees is half of the bands.
            if (a >= 28 && a < 36 && k >= 8 && k < 24) there += shares[a][k];
        }
    EXPECT_NEAR(total, 1.0f, 1e-4f);
    EXPECT_NEAR(there, 1.0f, 1e-4f);
}

TEST(GroundShadow, ASunIsNoPartOfTheSky) {
    const glm::vec3 towards = glm::normalize(glm::vec3(1.0f, 1.0f, 0.0f));
    EXPECT_EQ(
        sky_shares(patch_towards(towards), {{.towards_map = towards, .radius_radians = 0.2f}}),
        even_sky());
}

TEST(GroundShadow, UnderAnEvenSkyItIsDeepestAtTheFootAndTheSameAllAround) {
    const GroundShadow shadow = shadow_of_sphere();
    const auto light = floor_light(shadow, even_sky(), 0.0f);
    EXPECT_LT(light_at(shadow, light, 0.0f, 0.0f), 0.15f);
    EXPECT_GT(light_at(shadow, light, 1.3f, 0.0f), 0.9f);
    for (int i = 1; i < 8; ++i) {
        const float turn = static_cast<float>(i) * 0.25f * glm::pi<float>();
        EXPECT_NEAR(light_at(shadow, light, 0.6f * std::cos(turn), 0.6f * std::sin(turn)),
                    light_at(shadow, light, 0.6f, 0.0f), 0.06f);
    }
}

TEST(GroundShadow, LightFromOneSideLeavesItAtTheOtherAndTurnsWithTheEnvironment) {
    const GroundShadow shadow = shadow_of_sphere();
    const SkyShares sky = sky_shares(patch_towards({1.0f, 1.0f, 0.0f}), {});
    // The middle of the sphere is 0.5 m up, and the light comes at 45 degrees.
    const auto light = floor_light(shadow, sky, 0.0f);
    EXPECT_LT(light_at(shadow, light, -0.5f, 0.0f), 0.1f);
    EXPECT_GT(light_at(shadow, light, 0.7f, 0.0f), 0.95f);
    // A quarter counter-clockwise from above takes +X to -Z.
    const auto turned = floor_light(shadow, sky, 90.0f);
    EXPECT_LT(light_at(shadow, turned, 0.0f, 0.5f), 0.1f);
    EXPECT_GT(light_at(shadow, turned, 0.0f, -0.7f), 0.95f);
    EXPECT_GT(light_at(shadow, turned, -0.9f, 0.0f), 0.95f);
}

class FloorTest : public RenderTest {
  protected:
    void SetUp() override {
        RenderTest::SetUp();
        view_.background.kind = Background::Kind::Studio;
        view_.camera = {.position = {0.0f, 5.0f, 4.0f}, .target = {0.0f, 0.0f, 0.0f}};
    }
    /// The floor in the picture at a place beside the sphere's foot.
    float floor_at(const Image& picture, float x, float z) {
        const glm::vec4 clip =
            clip_from_view(view_.camera, 1.0f,
                           depth_range(view_.camera, renderer().bounds_world())) *
            (view_from_world(view_.camera) * glm::vec4(x, 0.0f, z, 1.0f));
        const glm::vec2 place = glm::vec2(clip) / clip.w * 0.5f + 0.5f;
        return pixel_of(picture, static_cast<int>(place.x * kSize.width),
                        static_cast<int>((1.0f - place.y) * kSize.height))
            .g;
    }
    /// How much darker shadows make the floor at +0.6 m and at -0.6 m of x.
    std::pair<float, float> darkened(int samples) {
        const auto picture = [&](bool shadows) {
            View view = view_;
            view.ground_shadow = shadows;
            return value_of(renderer().still_linear(view, kSize, samples));
        };
        const Image with = picture(true);
        const Image without = picture(false);
        return {floor_at(with, 0.8f, 0.0f) / floor_at(without, 0.8f, 0.0f),
                floor_at(with, -0.8f, 0.0f) / floor_at(without, -0.8f, 0.0f)};
    }
};

TEST_F(FloorTest, ItIsInTheShadowOfALampAndOfASun) {
    const glm::vec3 travel = glm::normalize(glm::vec3(1.0f, -1.0f, 0.0f));
    for (const Light::Kind kind : {Light::Kind::Directional, Light::Kind::Point,
                                   Light::Kind::Sphere, Light::Kind::Rectangle})
        for (const int samples : {1, 64}) {
            view_.environment_intensity = 0.1f;
            view_.lights = {{.kind = kind,
                             .name = "lamp",
                             .intensity = kind == Light::Kind::Directional ? 5.0f : 100.0f,
                             .position_world = -4.0f * travel,
                             .direction_world = travel,
                             .radius_m = 0.2f,
                             .width_m = 0.4f,
                             .height_m = 0.4f}};
            const auto [behind, before] = darkened(samples);
            EXPECT_LT(behind, 0.4f) << static_cast<int>(kind) << " " << samples;
            EXPECT_GT(before, 0.9f) << static_cast<int>(kind) << " " << samples;
        }
    view_.lights = {};
    view_.environment_intensity = 1.0f;
    FilteredEnvironment sun = filtered_builtin("white");
    sun.suns = {
        {.towards_map = -travel, .irradiance_linear = glm::vec3(50.0f), .radius_radians = 0.01f}};
    ASSERT_TRUE(renderer().set_environment(sun));
    const auto [behind, before] = darkened(4);
    EXPECT_LT(behind, 0.4f);
    EXPECT_GT(before, 0.9f);
    view_.shadows = false;
    EXPECT_GT(darkened(4).first, 0.7f);
}

TEST_F(FloorTest, WhatBlendsLeavesNoShadowOnItOfAnyKindOfLight) {
    SurfaceMaterial glass = constant_surface(glm::vec3(0.8f), 0.0f, 0.2f);
    const glm::vec3 travel = glm::normalize(glm::vec3(1.0f, -1.0f, 0.0f));
    view_.lights = {{.name = "lamp", .intensity = 2.0f, .direction_world = travel}};
    EXPECT_LT(darkened(1).first, 0.9f);
    glass.alpha_mode = AlphaMode::Blend;
    ASSERT_TRUE(renderer().set_material(0, glass));
    EXPECT_FLOAT_EQ(darkened(1).first, 1.0f);
    EXPECT_FLOAT_EQ(darkened(1).second, 1.0f);
    glass.alpha_mode = AlphaMode::Opaque;
    ASSERT_TRUE(renderer().set_material(0, glass));
    EXPECT_LT(darkened(1).first, 0.9f);
}

TEST_F(FloorTest, ItIsDarkerWhereTheModelHidesTheLightOfTheEnvironment) {
    FilteredEnvironment side = filtered_builtin("white");
    side.sky = sky_shares(patch_towards({-1.0f, 1.0f, 0.0f}), {});
    ASSERT_TRUE(renderer().set_environment(side));
    const auto [behind, before] = darkened(4);
    EXPECT_LT(behind, 0.5f);
    EXPECT_GT(before, 0.9f);
}

}  // namespace
}  // namespace patina::render
