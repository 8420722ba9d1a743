// SPDX-License-Identifier: MIT

/// Spheres and rectangles in pictures: what draws converge to is the integral of the BRDF over the
/// lamp, in double precision; what is drawn while things move is near it.

#include <cmath>
#include <functional>

#include "core/formulae/formulae.h"
#include "render/light_block.h"
#include "render/reflected_light.h"
#include "render/render_test.h"
#include "shaders/vectors.h"

namespace patina::render {
namespace {

Light sphere_light() {
    return {.kind = Light::Kind::Sphere,
            .name = "sphere",
            .color_linear = {1.0f, 0.8f, 0.6f},
            .intensity = 4.0f,
            .position_world = {1.0f, 1.6f, 1.4f},
            .radius_m = 0.4f};
}

Light rectangle_light() {
    return {.kind = Light::Kind::Rectangle,
            .name = "rectangle",
            .color_linear = {0.6f, 0.8f, 1.0f},
            .intensity = 4.0f,
            .position_world = {-0.9f, 1.3f, 1.2f},
            .direction_world = glm::normalize(glm::vec3(0.8f, -0.7f, -1.0f)),
            .width_m = 1.2f,
            .height_m = 0.5f,
            .turn_radians = 0.4f};
}

/// Calls `each(point, share)`: places on a lamp, and the solid angle that each stands for, seen
/// from `from`.
void for_each_part(const Light& light, const glm::dvec3& from,
                   const std::function<void(const glm::dvec3&, double)>& each) {
    constexpr int kSide = 96;
    const glm::dvec3 to_middle = glm::dvec3(light.position_world) - from;
    if (light.kind == Light::Kind::Rectangle) {
        const glm::dvec3 shines(light.direction_world);
        const glm::dvec3 across(rectangle_across(light));
        const glm::dvec3 up = glm::cross(shines, across);
        for (int i = 0; i < kSide; ++i)
            for (int j = 0; j < kSide; ++j) {
                const glm::dvec3 to = to_middle +
                                      across * double{light.width_m} * ((i + 0.5) / kSide - 0.5) +
                                      up * double{light.height_m} * ((j + 0.5) / kSide - 0.5);
                const double distance = glm::length(to);
                const double leaving = -glm::dot(to, shines) / distance;
                const double area = double{light.width_m} * double{light.height_m};
                if (leaving > 0.0)
                    each(to / distance, area * leaving / (distance * distance * kSide * kSide));
            }
        return;
    }
    const double distance = glm::length(to_middle);
    const glm::dvec3 z = to_middle / distance;
    const glm::dvec3 x = glm::normalize(glm::cross(z, glm::dvec3(0.31, 0.59, -0.74)));
    const glm::dvec3 y = glm::cross(z, x);
    const double sine = double{light.radius_m} / distance;
    const double height = 1.0 - std::sqrt(1.0 - sine * sine);
    for (int i = 0; i < kSide; ++i)
        for (int j = 0; j < kSide; ++j) {
            const double c = 1.0 - height * (i + 0.5) / kSide;
            const double s = std::sqrt(1.0 - c * c);
            const double phi = 2.0 * kPi * (j + 0.5) / kSide;
            each(c * z + s * (std::cos(phi) * x + std::sin(phi) * y),
                 2.0 * kPi * height / (kSide * kSide));
        }
}

glm::dvec3 radiance_of(const Light& light) {
    const double area = light.kind == Light::Kind::Sphere
                            ? kPi * double{light.radius_m} * double{light.radius_m}
                            : double{light.width_m} * double{light.height_m};
    return glm::dvec3(light.color_linear) * double{light.intensity} / area;
}

/// What a surface sends to the eye of one lamp.
glm::dvec3 reflected(const Light& light, const glm::dvec3& point, const glm::dvec3& n,
                     const glm::dvec3& v, const ReflectingMaterial& m) {
    const formulae::BrdfTerms terms = {};
    const formulae::Real3 base = real3(m.base_color_linear);
    const formulae::Real3 dielectric(0.04f);
    const formulae::Real3 f0 = formulae::material_f0(dielectric, base, m.metalness);
    glm::dvec3 sum(0.0);
    for_each_part(light, point, [&](const glm::dvec3& l, double solid_angle) {
        if (glm::dot(l, n) <= 0.0) return;
        const formulae::ReflectionAngles angles =
            formulae::reflection_angles(real3(n), real3(v), real3(l));
        const formulae::Real3 brdf =
            formulae::brdf_diffuse(terms, angles, formulae::diffuse_color(base, m.metalness),
                                   dielectric, 1.0f, m.roughness) +
            formulae::brdf_specular(terms, angles, f0, 1.0f, m.roughness);
        sum += glm::dvec3(brdf.x, brdf.y, brdf.z) * (glm::dot(l, n) * solid_angle);
    });
    return sum * radiance_of(light);
}

class AreaLightTest : public RenderTest {
  protected:
    /// So fine that a highlight hardly changes within a pixel.
    static constexpr int kSide = 192;

    void SetUp() override {
        RenderTest::SetUp();
        view_.environment_intensity = 0.0f;
    }

    /// How far pictures of so many draws are from the integral in the middle of their pixels.
    double error_of(const Light& light, const ReflectingMaterial& material, int draws) {
        view_.lights = {light};
        EXPECT_TRUE(renderer().set_material(
            0,
            constant_surface(material.base_color_linear, material.metalness, material.roughness)));
        const PictureSize size = {kSide, kSide};
        const Image normals = channel(ChannelView::NormalWorld, size);
        const Image positions = channel(ChannelView::Position, size);
        const Image picture = value_of(renderer().still_linear(view_, size, draws));
        RelativeError error;
        for (int y = 6; y < kSide; y += 12)
            for (int x = 6; x < kSide; x += 12) {
                if (pixel_of(picture, x, y).a < 1.0f) continue;
                const glm::dvec3 point(glm::vec3(pixel_of(positions, x, y)));
                const glm::dvec3 n = glm::normalize(glm::dvec3(glm::vec3(pixel_of(normals, x, y))));
                const glm::dvec3 v = glm::normalize(glm::dvec3(view_.camera.position) - point);
                // Edge-on a pixel is still wider than what changes in it.
                if (glm::dot(n, v) < 0.3) continue;
                error.add(glm::dvec3(glm::vec3(pixel_of(picture, x, y))),
                          reflected(light, point, n, v, material));
            }
        return error.value();
    }
};

const std::vector<ReflectingMaterial>& lit_materials() {
    static const std::vector<ReflectingMaterial> list = {{{0.8f, 0.4f, 0.2f}, 0.0f, 0.3f},
                                                         {{0.8f, 0.4f, 0.2f}, 0.0f, 1.0f},
                                                         {{0.9f, 0.7f, 0.4f}, 1.0f, 0.3f},
                                                         {{0.9f, 0.7f, 0.4f}, 1.0f, 0.5f},
                                                         {{0.9f, 0.7f, 0.4f}, 1.0f, 1.0f}};
    return list;
}

TEST_F(AreaLightTest, ManyDrawsConvergeToTheIntegralOverTheLamp) {
    for (const Light& light : {sphere_light(), rectangle_light()})
        for (const ReflectingMaterial& material : lit_materials())
            EXPECT_LT(error_of(light, material, 64), 0.03)
                << light.name << " " << material.metalness << " " << material.roughness;
}

TEST_F(AreaLightTest, OneDrawIsNearTheIntegral) {
    for (const Light& light : {sphere_light(), rectangle_light()})
        for (const ReflectingMaterial& material : lit_materials()) {
            const double error = error_of(light, material, 1);
            std::printf("%-10s metalness %.0f roughness %.1f: %.4f\n", light.name.c_str(),
                        double{material.metalness}, double{material.roughness}, error);
            EXPECT_LT(error, material.metalness > 0.5f ? 0.04 : 0.1)
                << light.name << " " << material.metalness << " " << material.roughness;
        }
}

TEST_F(AreaLightTest, FarAwayALampIsAsBrightAsAPointOfItsIntensity) {
    ASSERT_TRUE(renderer().set_material(0, constant_surface({0.8f, 0.4f, 0.2f}, 0.3f, 0.5f)));
    const glm::vec3 away(0.0f, 15.0f, 30.0f);
    const glm::vec3 direction = -glm::normalize(away - glm::vec3(0.0f, 0.5f, 0.0f));
    for (const int draws : {1, 64}) {
        view_.lights = {{.kind = Light::Kind::Point,
                         .name = "point",
                         .intensity = 700.0f,
                         .position_world = away}};
        const auto seen = [&] {
            return pixel_of(value_of(renderer().still_linear(view_, kSize, draws)), 32, 32);
        };
        const glm::vec4 point = seen();
        for (const Light::Kind kind : {Light::Kind::Sphere, Light::Kind::Rectangle}) {
            view_.lights[0].kind = kind;
            view_.lights[0].direction_world = direction;
            view_.lights[0].radius_m = 0.1f;
            view_.lights[0].width_m = 0.2f;
            view_.lights[0].height_m = 0.1f;
            const glm::vec4 lamp = seen();
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(lamp[c] / point[c], 1.0f, 0.01f)
                    << draws << " " << static_cast<int>(kind);
        }
    }
}

TEST_F(AreaLightTest, ALampThatCoversTheWholeLobeShowsItsOwnRadiance) {
    ASSERT_TRUE(renderer().set_material(0, constant_surface(glm::vec3(1.0f), 1.0f, 0.1f)));
    // Where the middle of the sphere mirrors it.
    Light light = rectangle_light();
    light.color_linear = glm::vec3(1.0f);
    light.position_world = {0.0f, 0.5f, 1.6f};
    light.direction_world = {0.0f, 0.0f, -1.0f};
    light.radius_m = 0.4f;
    for (const Light::Kind kind : {Light::Kind::Sphere, Light::Kind::Rectangle}) {
        light.kind = kind;
        view_.lights = {light};
        EXPECT_NEAR(middle(ChannelView::Final).g / radiance_of(light).g, 1.0, 0.03)
            << static_cast<int>(kind);
    }
}

TEST_F(AreaLightTest, TheDrawnTurnIsThatOfTheWidthFromTheLevel) {
    Light light = rectangle_light();
    light.turn_radians = 0.0f;
    EXPECT_NEAR(rectangle_across(light).y, 0.0f, 1e-6f);
    light.turn_radians = 0.5f * static_cast<float>(kPi);
    EXPECT_NEAR(glm::dot(rectangle_across(light), light.direction_world), 0.0f, 1e-6f);
    EXPECT_GT(std::abs(rectangle_across(light).y), 0.5f);
    light.direction_world = {0.0f, -1.0f, 0.0f};
    EXPECT_NEAR(glm::length(rectangle_across(light)), 1.0f, 1e-6f);
}

TEST_F(AreaLightTest, EveryOneOfAllLightsLights) {
    ASSERT_TRUE(renderer().set_material(0, constant_surface(glm::vec3(0.5f), 0.0f, 1.0f)));
    const Light point{.kind = Light::Kind::Point,
                      .name = "point",
                      .intensity = 0.01f,
                      .position_world = {0.0f, 0.5f, 2.0f}};
    view_.lights = {point};
    const float one = middle(ChannelView::DiffuseDirect).g;
    ASSERT_GT(one, 0.0f);
    view_.lights.assign(kMaxLights, point);
    EXPECT_NEAR(middle(ChannelView::DiffuseDirect).g / one, static_cast<float>(kMaxLights), 0.5f);
}

}  // namespace
}  // namespace patina::render
