// SPDX-License-Identifier: MIT

/// Shadows of lights that are far away, and of lamps at a place.

#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "render/light_block.h"
#include "render/render_test.h"

namespace patina::render {
namespace {

constexpr PictureSize kPicture = {128, 128};

class ShadowTest : public RenderTest {
  protected:
    void SetUp() override {
        RenderTest::SetUp();
        ASSERT_TRUE(renderer().set_material(0, constant_surface(glm::vec3(0.8f), 0.0f, 1.0f)));
        view_.environment_intensity = 0.0f;
    }
    /// A floor of 6 m with a sphere of 1 m lying on it.
    static std::shared_ptr<Scene> sphere_over_floor() {
        auto scene = std::make_shared<Scene>();
        scene->meshes = {shape_mesh(Shape::Plane), shape_mesh(Shape::Sphere)};
        scene->instances = {
            {.mesh = 0,
             .world_from_local = glm::scale(glm::mat4(1.0f), glm::vec3(6.0f, 1.0f, 6.0f)),
             .name = "floor"},
            {.mesh = 1,
             .world_from_local = glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, 0.5f, 0.0f)),
             .name = "sphere"}};
        return scene;
    }
    void show_sphere_over_floor() {
        show(sphere_over_floor());
        view_.camera.position = {0.0f, 4.0f, 6.0f};
        view_.camera.target = {0.0f, 0.5f, 0.0f};
    }
    Image raw(ChannelView channel, bool shadows, int samples = 1) {
        View view = view_;
        view.channel = channel;
        view.shadows = shadows;
        return value_of(renderer().still_linear(view, kPicture, samples));
    }
    /// Of direct light, where there is any without shadows.
    struct Seen {
        int pixel;
        glm::vec3 position;
        float share;  ///< of the light that it would have without shadows
    };
    std::vector<Seen> seen(ChannelView light, int samples = 1) {
        const Image position = raw(ChannelView::Position, false);
        const Image without = raw(light, false, samples);
        const Image with = raw(light, true, samples);
        std::vector<Seen> result;
        for (int y = 0; y < kPicture.height; ++y)
            for (int x = 0; x < kPicture.width; ++x) {
                const glm::vec4 at = pixel_of(position, x, y);
                const float whole = pixel_of(without, x, y).g;
                if (at.a < 1.0f || whole < 0.02f) continue;
                result.push_back(
                    {y * kPicture.width + x, glm::vec3(at), pixel_of(with, x, y).g / whole});
            }
        return result;
    }
};

TEST_F(ShadowTest, ALampLeavesInTheDarkWhatTheSphereHidesAndNothingElse) {
    show_sphere_over_floor();
    for (const glm::vec3& travel : {glm::vec3(0.0f, -1.0f, 0.0f), glm::vec3(0.5f, -1.0f, -0.3f),
                                    glm::vec3(-1.5f, -1.0f, 0.2f)}) {
        view_.lights = {{.kind = Light::Kind::Directional,
                         .name = "lamp",
                         .intensity = 3.0f,
                         .direction_world = travel}};
        const glm::vec3 towards = -glm::normalize(travel);
        int dark = 0;
        int lit = 0;
        for (const Seen& each : seen(ChannelView::DiffuseDirect)) {
            if (each.position.y > 0.01f) {  // the sphere hides nothing of itself
                EXPECT_NEAR(each.share, 1.0f, 1e-3f)
                    << each.position.x << " " << each.position.y << " " << each.position.z;
                continue;
            }
            const glm::vec3 from_middle = each.position - glm::vec3(0.0f, 1.0f, 0.0f);
            const float aside = glm::length(from_middle - glm::dot(from_middle, towards) * towards);
            if (std::abs(aside - 0.5f) < 0.03f) continue;  // the edge
            EXPECT_NEAR(each.share, aside < 0.5f ? 0.0f : 1.0f, 1e-3f)
                << aside << " m beside the middle of the shadow";
            ++(aside < 0.5f ? dark : lit);
        }
        EXPECT_GT(dark, 50);
        EXPECT_GT(lit, 1000);
    }
}

/// A plate whose edge is the line x = 0, z = any, high above a floor.
TEST_F(ShadowTest, TheEdgeOfASunsShadowIsAsSoftAsTheSunIsWide) {
    constexpr float kHeight = 2.0f;
    constexpr float kRadius = 0.04f;
    auto scene = std::make_shared<Scene>();
    scene->meshes = {shape_mesh(Shape::Plane)};
    scene->instances = {
        {.mesh = 0,
         .world_from_local = glm::scale(glm::mat4(1.0f), glm::vec3(3.0f, 1.0f, 3.0f)),
         .name = "floor"},
        {.mesh = 0,
         .world_from_local =
             glm::scale(glm::translate(glm::mat4(1.0f), glm::vec3(-1.5f, kHeight, 0.0f)),
                        glm::vec3(3.0f, 1.0f, 6.0f)),
         .name = "plate"}};
    show(scene);
    FilteredEnvironment sun = filtered_builtin("white");
    sun.suns = {{.towards_map = {0.0f, 1.0f, 0.0f},
                 .irradiance_linear = glm::vec3(100.0f),
                 .radius_radians = kRadius}};
    ASSERT_TRUE(renderer().set_environment(sun));
    view_.environment_intensity = 1.0f;
    view_.camera = {.position = {0.9f, 0.9f, 0.0f}, .target = {0.0f, 0.0f, 0.0f}};
    double error = 0.0;
    int count = 0;
    float softest = 0.0f;
    for (const Seen& each : seen(ChannelView::DiffuseAmbient, 32)) {
        const float t = std::clamp(each.position.x / (kHeight * std::tan(kRadius)), -1.0f, 1.0f);
        const float expected =
            0.5f + (std::asin(t) + t * std::sqrt(1.0f - t * t)) / glm::pi<float>();
        // The white map's own light is a thirtieth of the sun's.
        const float share = (each.share * (100.0f + glm::pi<float>()) - glm::pi<float>()) / 100.0f;
        error += (share - expected) * (share - expected);
        softest = std::max(softest, 0.5f - std::abs(share - 0.5f));
        ++count;
    }
    EXPECT_GT(count, 1000);
    EXPECT_GT(softest, 0.4f);
    EXPECT_LT(std::sqrt(error / count), 0.05);
}

TEST_F(ShadowTest, TheKeyLightOfPhongCastsOneToo) {
    show_sphere_over_floor();
    view_.left.model = ShadingModel::Phong;
    FilteredEnvironment above = filtered_builtin("white");
    above.keys = {{.direction_map = {0.0f, -1.0f, 0.0f}, .irradiance_linear = glm::vec3(3.0f)}};
    ASSERT_TRUE(renderer().set_environment(above));
    view_.environment_intensity = 1.0f;
    for (const Seen& each : seen(ChannelView::DiffuseDirect)) {
        const float aside = glm::length(glm::vec2(each.position.x, each.position.z));
        if (each.position.y > 0.01f || std::abs(aside - 0.5f) < 0.06f) continue;
        EXPECT_NEAR(each.share, aside < 0.5f ? 0.0f : 1.0f, 1e-3f) << aside;
    }
}

/// Whether the sphere of 0.5 m lies between two points.
bool sphere_hides(const glm::vec3& from, const glm::vec3& to) {
    const glm::vec3 middle(0.0f, 1.0f, 0.0f);
    const glm::vec3 way = to - from;
    const float at = std::clamp(glm::dot(middle - from, way) / glm::dot(way, way), 0.0f, 1.0f);
    return glm::length(from + at * way - middle) < 0.5f;
}

TEST_F(ShadowTest, ALampAtAPlaceLeavesInTheDarkWhatTheSphereHidesAndNothingElse) {
    show_sphere_over_floor();
    // The last stands amid the scene and shines towards its middle.
    for (const glm::vec3& place :
         {glm::vec3(0.5f, 9.0f, 1.0f), glm::vec3(-5.0f, 4.0f, 3.0f), glm::vec3(1.0f, 2.5f, 0.5f)})
        for (const Light::Kind kind : {Light::Kind::Point, Light::Kind::Spot}) {
            view_.lights = {{.kind = kind,
                             .name = "lamp",
                             .intensity = 300.0f,
                             .position_world = place,
                             .direction_world = glm::normalize(glm::vec3(0.0f, 1.0f, 0.0f) - place),
                             .outer_cone_radians = 0.6f}};
            int dark = 0;
            int lit = 0;
            int wrong = 0;
            for (const Seen& each : seen(ChannelView::DiffuseDirect)) {
                if (each.position.y > 0.01f) {  // the sphere hides nothing of itself
                    EXPECT_NEAR(each.share, 1.0f, 1e-3f);
                    continue;
                }
                const bool hidden = sphere_hides(each.position, place);
                ++(hidden ? dark : lit);
                wrong += std::abs(each.share - (hidden ? 0.0f : 1.0f)) > 1e-3f ? 1 : 0;
            }
            EXPECT_GT(dark, 30);
            EXPECT_GT(lit, 300);
            // The edge, which is a step over two texels of the map.
            EXPECT_LT(wrong, 0.025 * (dark + lit)) << place.x << " " << static_cast<int>(kind);
        }
}

/// What of a lamp that has a size a point of the floor sees, weighted as a white Lambert surface
/// weighs it, against all of it.
float seen_share(const Light& light, const glm::vec3& point) {
    constexpr int kSide = 24;
    const glm::vec3 across = rectangle_across(light);
    const glm::vec3 up = glm::cross(light.direction_world, across);
    double seen = 0.0;
    double whole = 0.0;
    for (int i = 0; i < kSide; ++i)
        for (int j = 0; j < kSide; ++j) {
            const glm::vec3 place =
                light.position_world +
                across * light.width_m * ((static_cast<float>(i) + 0.5f) / kSide - 0.5f) +
                up * light.height_m * ((static_cast<float>(j) + 0.5f) / kSide - 0.5f);
            const glm::vec3 way = place - point;
            const float distance = glm::length(way);
            const double received = double{way.y / distance} *
                                    std::max(-glm::dot(way, light.direction_world), 0.0f) /
                                    (distance * distance * distance);
            whole += received;
            if (!sphere_hides(point, place)) seen += received;
        }
    return static_cast<float>(seen / whole);
}

TEST_F(ShadowTest, ManyDrawsOfARectanglesShadowConvergeToWhatEachPointSeesOfIt) {
    show_sphere_over_floor();
    const Light light{.kind = Light::Kind::Rectangle,
                      .name = "rectangle",
                      .intensity = 100.0f,
                      .position_world = {-2.5f, 4.0f, 1.0f},
                      .direction_world = glm::normalize(glm::vec3(2.5f, -3.5f, -1.0f)),
                      .width_m = 1.6f,
                      .height_m = 0.8f};
    view_.lights = {light};
    const auto error_of = [&](int draws) {
        double error = 0.0;
        int half_dark = 0;
        int count = 0;
        for (const Seen& each : seen(ChannelView::DiffuseDirect, draws)) {
            if (each.position.y > 0.01f) continue;
            const float expected = seen_share(light, each.position);
            half_dark += expected > 0.1f && expected < 0.9f ? 1 : 0;
            error += (each.share - expected) * (each.share - expected);
            ++count;
        }
        EXPECT_GT(half_dark, 100);
        return std::sqrt(error / count);
    };
    const double soft = error_of(1);
    const double converged = error_of(256);
    std::printf("one draw %.4f, 256 draws %.4f\n", soft, converged);
    EXPECT_LT(soft, 0.1);
    EXPECT_LT(converged, 0.02);
}

/// How one mean of draws differs from another where both see the same, and how much of either is
/// half in the dark.
struct Softness {
    double error = 0.0;  ///< root mean square
    int half_dark = 0;
    int half_dark_truly = 0;
};

/// Close lamps, whose maps are wide: of each the shadow's edge is as wide as the sphere.
const std::array<Light, 2> kCloseLamps = {
    Light{.kind = Light::Kind::Sphere,
          .name = "sphere",
          .intensity = 100.0f,
          .position_world = {-2.0f, 2.2f, 1.0f},
          .radius_m = 0.3f},
    Light{.kind = Light::Kind::Rectangle,
          .name = "rectangle",
          .intensity = 100.0f,
          .position_world = {1.6f, 2.4f, 0.8f},
          .direction_world = glm::normalize(glm::vec3(-1.6f, -1.4f, -0.8f)),
          .width_m = 0.8f,
          .height_m = 0.6f}};

TEST_F(ShadowTest, FewDrawsOfACloseLampsShadowAreAsSoftAsManyAre) {
    show_sphere_over_floor();
    for (const Light& lamp : kCloseLamps) {
        view_.lights = {lamp};
        const std::vector<Seen> truth = seen(ChannelView::DiffuseDirect, 128);
        for (const int draws : {1, 16}) {
            const std::vector<Seen> few = seen(ChannelView::DiffuseDirect, draws);
            Softness found;
            std::size_t j = 0;
            std::size_t count = 0;
            for (const Seen& each : truth) {
                while (j < few.size() && few[j].pixel < each.pixel) ++j;
                if (j == few.size()) break;
                if (few[j].pixel != each.pixel) continue;
                const auto half = [](float share) { return share > 0.15f && share < 0.85f; };
                found.half_dark += half(few[j].share) ? 1 : 0;
                found.half_dark_truly += half(each.share) ? 1 : 0;
                const double off = few[j].share - each.share;
                found.error += off * off;
                ++count;
            }
            found.error = std::sqrt(found.error / static_cast<double>(count));
            std::printf("%s, %d draws: off by %.4f, half dark %d of %d\n", lamp.name.c_str(), draws,
                        found.error, found.half_dark, found.half_dark_truly);
            EXPECT_LT(found.error, 0.07);
            EXPECT_GT(found.half_dark, 0.7 * found.half_dark_truly);
            EXPECT_LT(found.half_dark, 1.8 * found.half_dark_truly);
        }
    }
}

TEST_F(ShadowTest, ACloseLampLeavesNoSpecksOnASurfaceThatNothingHides) {
    for (const Shape shape : {Shape::Plane, Shape::Sphere}) {
        show(scene_of(shape_mesh(shape), glm::scale(glm::mat4(1.0f), glm::vec3(3.0f))));
        view_.camera.position = {0.0f, 5.0f, 8.0f};
        const glm::vec3 middle(0.0f, 1.5f, 0.0f);
        for (Light lamp : kCloseLamps) {
            lamp.position_world *= 1.5f;
            view_.lights = {lamp};
            for (const Seen& each : seen(ChannelView::DiffuseDirect)) {
                const glm::vec3 normal = shape == Shape::Plane
                                             ? glm::vec3(0.0f, 1.0f, 0.0f)
                                             : glm::normalize(each.position - middle);
                const glm::vec3 towards = glm::normalize(lamp.position_world - each.position);
                // More on edge than that the faces of the mesh hide some of the lamp.
                if (glm::dot(normal, towards) < 0.1f) continue;
                ASSERT_NEAR(each.share, 1.0f, 2e-3f) << lamp.name << " " << each.position.x << " "
                                                     << each.position.y << " " << each.position.z;
            }
        }
    }
}

TEST_F(ShadowTest, TheStrongestLampsCastShadowsWhateverTheirOrder) {
    show_sphere_over_floor();
    Light weak{.kind = Light::Kind::Point,
               .name = "weak",
               .intensity = 0.5f,
               .position_world = {3.0f, 4.0f, 2.0f}};
    std::vector<Light> lights(12, weak);
    lights.push_back({.kind = Light::Kind::Point,
                      .name = "strong",
                      .intensity = 500.0f,
                      .position_world = {0.0f, 6.0f, 0.0f}});
    view_.lights = lights;
    float least = 1.0f;
    for (const Seen& each : seen(ChannelView::DiffuseDirect)) least = std::min(least, each.share);
    EXPECT_LT(least, 0.1f);
}

TEST_F(ShadowTest, LampsThatShinePastTheSceneTakeNoShadowFromOneThatLightsIt) {
    show_sphere_over_floor();
    const glm::vec3 place(0.0f, 6.0f, 0.0f);
    Light past{.kind = Light::Kind::Spot,
               .name = "past",
               .intensity = 5000.0f,
               .position_world = place,
               .direction_world = {0.0f, 1.0f, 0.0f},
               .outer_cone_radians = 0.5f};
    std::vector<Light> lights(3, past);
    past.kind = Light::Kind::Rectangle;
    lights.insert(lights.end(), 3, past);
    past.kind = Light::Kind::Point;
    past.range = 2.0f;
    lights.insert(lights.end(), 3, past);
    lights.push_back({.kind = Light::Kind::Point,
                      .name = "lights it",
                      .intensity = 20.0f,
                      .position_world = place});
    view_.lights = lights;
    float least = 1.0f;
    for (const Seen& each : seen(ChannelView::DiffuseDirect)) least = std::min(least, each.share);
    EXPECT_LT(least, 0.1f);
}

TEST_F(ShadowTest, WhatAnAlphaMaskCutsOutCastsNone) {
    show_sphere_over_floor();
    view_.lights = {
        {.kind = Light::Kind::Directional, .name = "lamp", .direction_world = {0.0f, -1.0f, 0.0f}}};
    ASSERT_FALSE(seen(ChannelView::DiffuseDirect).empty());
    SurfaceMaterial gone = constant_surface(glm::vec3(0.8f), 0.0f, 1.0f);
    gone.alpha_mode = AlphaMode::Mask;
    gone[Slot::BaseColor].multiply.a = 0.2f;
    const std::shared_ptr<Scene> scene = sphere_over_floor();
    for (Primitive& primitive : scene->meshes[1].primitives) primitive.source_material = 1;
    ASSERT_TRUE(renderer().set_scene(scene));
    const auto darkest = [&] {
        float least = 1.0f;
        for (const Seen& each : seen(ChannelView::DiffuseDirect))
            least = std::min(least, each.share);
        return least;
    };
    EXPECT_EQ(darkest(), 0.0f);
    ASSERT_TRUE(renderer().set_material(1, gone));  // the map is drawn anew
    EXPECT_EQ(darkest(), 1.0f);
}

}  // namespace
}  // namespace patina::render
