// SPDX-License-Identifier: MIT

/// Light on surfaces: the passes against the shared formulae on the CPU, and what must hold.

#include <cmath>

#include "core/formulae/formulae.h"
#include "render/reflected_light.h"
#include "render/render_test.h"
#include "shaders/vectors.h"

namespace patina::render {
namespace {

class ShadingTest : public RenderTest {
  protected:
    /// One lamp in a black room.
    void light_by(const Light& light) {
        view_.environment_intensity = 0.0f;
        view_.lights = {light};
    }
};

/// The relative error that half floats and 8-bit base colours leave.
constexpr float kTolerance = 0.02f;

Light slanted_sun() {
    return {.name = "sun",
            .color_linear = {1.0f, 0.5f, 0.25f},
            .intensity = 3.0f,
            .direction_world = glm::normalize(glm::vec3(-1.0f, -2.0f, -2.0f))};
}

/// Each distribution with each masking, which share the half vector, and each Fresnel term with
/// each diffuse one, which share the energy.
std::vector<PbrTerms> combined_terms() {
    std::vector<PbrTerms> all;
    for (const auto& d : kDistributionTerms)
        for (const auto& g : kGeometryTerms)
            all.push_back({.distribution = d.value, .geometry = g.value});
    for (const auto& f : kFresnelTerms)
        for (const auto& diffuse : kDiffuseTerms)
            all.push_back({.fresnel = f.value, .diffuse = diffuse.value});
    return all;
}

TEST_F(ShadingTest, EveryTermIsTheSharedFormulaOnTheCpu) {
    const glm::vec3 base(0.8f, 0.4f, 0.2f);
    ASSERT_TRUE(renderer().set_material(0, constant_surface(base, 0.4f, 0.5f)));
    light_by(slanted_sun());
    const glm::vec3 position = middle(ChannelView::Position);
    const glm::vec3 n = middle(ChannelView::NormalWorld);
    const glm::vec3 f0 = middle(ChannelView::F0);
    const glm::vec3 base_seen = middle(ChannelView::BaseColor);
    const glm::vec3 v = glm::normalize(view_.camera.position - position);
    const glm::vec3 l = -view_.lights[0].direction_world;
    const formulae::ReflectionAngles angles =
        formulae::reflection_angles(real3(n), real3(v), real3(l));
    const glm::vec3 received =
        view_.lights[0].color_linear * view_.lights[0].intensity * angles.n_dot_l;
    for (const PbrTerms& pbr : combined_terms()) {
        view_.left.terms = pbr;
        const formulae::BrdfTerms terms = {
            static_cast<int>(pbr.distribution), static_cast<int>(pbr.geometry),
            static_cast<int>(pbr.fresnel), static_cast<int>(pbr.diffuse)};
        const glm::vec3 specular =
            received * vec3(formulae::brdf_specular(terms, angles, real3(f0), 1.0f, 0.5f));
        const glm::vec3 scattered =
            received * vec3(formulae::brdf_diffuse(terms, angles, real3(base_seen * 0.6f),
                                                   formulae::Real3(0.04f), 1.0f, 0.5f));
        const glm::vec3 final_picture = middle(ChannelView::Final);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(final_picture[c] / (specular[c] + scattered[c]), 1.0f, kTolerance)
                << "D " << terms.distribution << " G " << terms.geometry << " F " << terms.fresnel
                << " diffuse " << terms.diffuse;
    }
}

TEST_F(ShadingTest, TheTermsAloneAreThoseOfTheKeyLight) {
    ASSERT_TRUE(renderer().set_material(0, constant_surface(glm::vec3(0.5f), 1.0f, 0.6f)));
    light_by(slanted_sun());
    const glm::vec3 n = middle(ChannelView::NormalWorld);
    const glm::vec3 v = glm::normalize(view_.camera.position - middle(ChannelView::Position));
    const formulae::ReflectionAngles angles =
        formulae::reflection_angles(real3(n), real3(v), real3(-view_.lights[0].direction_world));
    EXPECT_NEAR(middle(ChannelView::DistributionTerm).x,
                formulae::distribution_ggx(angles.n_dot_h, 0.36f), 0.01f);
    const float g = 4.0f * angles.n_dot_l * angles.n_dot_v *
                    formulae::visibility_smith_separable(angles.n_dot_l, angles.n_dot_v, 0.36f);
    EXPECT_NEAR(middle(ChannelView::GeometryTerm).x, g, 0.005f);
    EXPECT_LE(middle(ChannelView::GeometryTerm).x, 1.0f);
    EXPECT_GE(middle(ChannelView::FresnelTerm).x, 0.49f);
}

TEST_F(ShadingTest, ThePartsOfTheLightAddUpToThePicture) {
    ASSERT_TRUE(renderer().set_environment(filtered_builtin("studio")));
    ASSERT_TRUE(renderer().set_material(0, constant_surface({0.8f, 0.4f, 0.2f}, 0.3f, 0.4f)));
    view_.lights = {slanted_sun()};
    for (const auto& model : kShadingModels) {
        view_.left.model = model.value;
        const glm::vec3 sum =
            middle(ChannelView::DiffuseDirect) + middle(ChannelView::SpecularDirect) +
            middle(ChannelView::DiffuseAmbient) + middle(ChannelView::SpecularAmbient);
        const glm::vec3 whole = middle(ChannelView::Final);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[c], whole[c], 1e-4f) << model.id;
    }
}

TEST_F(ShadingTest, AWhiteNonMetalInUniformLightSendsOutTheIntegralOfItsBrdf) {
    const RadianceMap white{64, 32, std::vector<glm::vec3>(64 * 32, glm::vec3(1.0f))};
    const ReflectedLight light(white);
    const Image normals = channel(ChannelView::NormalWorld);
    const Image positions = channel(ChannelView::Position);
    for (const float roughness : {0.0f, 0.3f, 0.7f, 1.0f}) {
        const ReflectingMaterial material{glm::vec3(1.0f), 0.0f, roughness};
        ASSERT_TRUE(renderer().set_material(0, constant_surface(glm::vec3(1.0f), 0.0f, roughness)));
        const Image picture = channel(ChannelView::Final);
        for (int y = 0; y < kSize.height; y += 5)
            for (int x = 0; x < kSize.width; x += 5) {
                if (pixel_of(picture, x, y).a == 0.0f) continue;
                const glm::vec3 n(pixel_of(normals, x, y));
                const glm::vec3 v =
                    glm::normalize(view_.camera.position - glm::vec3(pixel_of(positions, x, y)));
                // Edge-on a pixel is wider than what changes in it.
                if (glm::dot(n, v) < 0.25f) continue;
                glm::dvec3 sum = light.summed(n, v, material);
                if (material.is_smooth()) sum += light.mirrored(n, v, material);
                ASSERT_NEAR(pixel_of(picture, x, y).g, sum.y, 0.03) << x << " " << y;
                // Nothing is lost beyond what single scattering loses.
                ASSERT_GE(pixel_of(picture, x, y).g, 0.97f) << x << " " << y;
            }
    }
}

TEST_F(ShadingTest, AWhiteMetalLosesOnlyWhatSingleScatteringLosesAndNothingWithCompensation) {
    for (const float roughness : {0.0f, 0.3f, 0.7f, 1.0f}) {
        ASSERT_TRUE(renderer().set_material(0, constant_surface(glm::vec3(1.0f), 1.0f, roughness)));
        view_.left.terms.multiple_scattering = false;
        const float single = middle(ChannelView::Final).g;
        EXPECT_LE(single, 1.005f);
        if (roughness < 0.5f) {
            EXPECT_GE(single, 0.93f);
        }
        // The integral of the separable form head on for alpha 1: 1 - ln 2.
        if (roughness == 1.0f) {
            EXPECT_NEAR(single, 0.30685f, 0.015f);
        }
        view_.left.terms.multiple_scattering = true;
        EXPECT_NEAR(middle(ChannelView::Final).g, 1.0f, 0.01f) << roughness;
    }
}

/// What a surface sends out of uniform light of radiance 1, by its own sum in double precision:
/// diffuse in x, mirrored in y.
glm::dvec2 sent_out(const formulae::BrdfTerms& terms, float n_dot_v, float f0, float roughness) {
    const formulae::Real3 n(0.0f, 0.0f, 1.0f);
    const formulae::Real3 v(std::sqrt(1.0f - n_dot_v * n_dot_v), 0.0f, n_dot_v);
    constexpr int kSide = 400;
    glm::dvec2 sum(0.0);
    for (int i = 0; i < kSide; ++i)
        for (int j = 0; j < kSide; ++j) {
            const float z = (static_cast<float>(i) + 0.5f) / kSide;
            const float phi = 2.0f * 3.14159265f * (static_cast<float>(j) + 0.5f) / kSide;
            const float s = std::sqrt(1.0f - z * z);
            const formulae::ReflectionAngles angles =
                formulae::reflection_angles(n, v, {s * std::cos(phi), s * std::sin(phi), z});
            const formulae::Real3 f(f0);
            sum += double{z} *
                   glm::dvec2(formulae::brdf_diffuse(terms, angles, formulae::Real3(1.0f), f, 1.0f,
                                                     roughness)
                                  .x,
                              formulae::brdf_specular(terms, angles, f, 1.0f, roughness).x);
        }
    return sum * (2.0 * 3.14159265358979 / (kSide * kSide));
}

TEST_F(ShadingTest, EveryTermActsOnTheEnvironmentAsOnLamps) {
    constexpr float kRoughness = 0.6f;
    ASSERT_TRUE(renderer().set_material(0, constant_surface(glm::vec3(1.0f), 0.0f, kRoughness)));
    const Image normals = channel(ChannelView::NormalWorld);
    const Image positions = channel(ChannelView::Position);
    std::vector<PbrTerms> sets;
    for (const auto& d : kDistributionTerms) sets.push_back({.distribution = d.value});
    for (const auto& g : kGeometryTerms) sets.push_back({.geometry = g.value});
    for (const auto& f : kFresnelTerms) sets.push_back({.fresnel = f.value});
    for (const auto& d : kDiffuseTerms)
        if (d.value != DiffuseTerm::Lecture) sets.push_back({.diffuse = d.value});
    for (const PbrTerms& terms : sets) {
        view_.left.terms = terms;
        const Image diffuse = channel(ChannelView::DiffuseAmbient);
        const Image mirrored = channel(ChannelView::SpecularAmbient);
        const formulae::BrdfTerms shared = {
            static_cast<int>(terms.distribution), static_cast<int>(terms.geometry),
            static_cast<int>(terms.fresnel), static_cast<int>(terms.diffuse)};
        for (const int x : {32, 44, 50}) {
            const glm::vec3 n(pixel_of(normals, x, 32));
            const glm::vec3 v =
                glm::normalize(view_.camera.position - glm::vec3(pixel_of(positions, x, 32)));
            const glm::dvec2 sum = sent_out(shared, glm::dot(n, v), 0.04f, kRoughness);
            const auto where = [&] {
                return testing::Message()
                       << x << ": " << shared.distribution << " " << shared.geometry << " "
                       << shared.fresnel << " " << shared.diffuse;
            };
            EXPECT_NEAR(pixel_of(diffuse, x, 32).g, sum.x, 0.01) << where();
            EXPECT_NEAR(pixel_of(mirrored, x, 32).g, sum.y, 0.03 * sum.y + 0.001) << where();
        }
    }
}

TEST_F(ShadingTest, OcclusionHoldsMirroredLightBackAsFarAsItHidesTheLobe) {
    for (const float roughness : {0.1f, 0.5f}) {
        SurfaceMaterial surface = constant_surface(glm::vec3(1.0f), 1.0f, roughness);
        ASSERT_TRUE(renderer().set_material(0, surface));
        const float open = middle(ChannelView::SpecularAmbient).g;
        surface[Slot::Occlusion].multiply = glm::vec4(0.4f);
        surface[Slot::Occlusion].add = glm::vec4(0.0f);
        ASSERT_TRUE(renderer().set_material(0, surface));
        view_.occlude_reflections = true;
        EXPECT_NEAR(middle(ChannelView::SpecularAmbient).g / open,
                    formulae::mirrored_share(1.0f, 0.4f, roughness * roughness), 0.01f);
        view_.occlude_reflections = false;
        EXPECT_NEAR(middle(ChannelView::SpecularAmbient).g / open, 0.4f, 0.01f);
    }
}

/// One direction everywhere, in tangent space.
ImagePtr tilted(const glm::vec3& normal) {
    Image image{.width = 4, .height = 4, .channels = 3, .type = SampleType::U8, .data = {}};
    for (int i = 0; i < 16; ++i)
        for (int c = 0; c < 3; ++c)
            image.data.push_back(static_cast<std::byte>(std::lround(normal[c] * 127.5f + 127.5f)));
    return std::make_shared<const Image>(std::move(image));
}

TEST_F(ShadingTest, ANormalMapMirrorsNothingFromFarBelowItsSurface) {
    show(scene_of(shape_mesh(Shape::Plane)));
    const auto mirrored = [&](const glm::vec3& mapped, bool occluded, int draws) {
        SurfaceMaterial surface = constant_surface(glm::vec3(1.0f), 1.0f, 0.1f);
        surface[Slot::Normal].texture.pixels = tilted(glm::normalize(mapped));
        EXPECT_TRUE(renderer().set_material(0, surface));
        view_.occlude_reflections = occluded;
        View view = view_;
        view.channel = ChannelView::SpecularAmbient;
        return pixel_of(value_of(renderer().still_linear(view, kSize, draws)), 32, 32).g;
    };
    // From the side, against a normal that leans away from the eye: it mirrors the ground.
    view_.camera.position = view_.camera.target + glm::vec3(1.5f, 1.5f, 0.0f);
    const glm::vec3 leaning(-0.5f, 0.0f, 0.87f);
    for (const int draws : {1, 64}) {
        EXPECT_GT(mirrored(leaning, false, draws), 0.7f);
        EXPECT_LT(mirrored(leaning, true, draws), 0.6f * mirrored(leaning, false, draws)) << draws;
        // Towards the eye it mirrors the sky, as a flat one does.
        for (const glm::vec3& other : {glm::vec3(0.3f, 0.0f, 0.95f), glm::vec3(0.0f, 0.0f, 1.0f)})
            EXPECT_NEAR(mirrored(other, true, draws), mirrored(other, false, draws), 1e-3f);
    }
}

TEST_F(ShadingTest, APointLightFallsOffWithTheSquareOfDistanceAndEndsAtItsRange) {
    ASSERT_TRUE(renderer().set_material(0, constant_surface(glm::vec3(0.5f), 0.0f, 1.0f)));
    const glm::vec3 front(0.0f, 0.5f, 0.5f);
    Light lamp{
        .kind = Light::Kind::Point, .name = "lamp", .position_world = front + glm::vec3(0, 0, 1)};
    light_by(lamp);
    const float near_light = middle(ChannelView::DiffuseDirect).g;
    view_.lights[0].position_world = front + glm::vec3(0, 0, 2);
    EXPECT_NEAR(near_light / middle(ChannelView::DiffuseDirect).g, 4.0f, 0.05f);
    view_.lights[0].range = 1.9f;
    EXPECT_EQ(middle(ChannelView::DiffuseDirect).g, 0.0f);
}

TEST_F(ShadingTest, ASpotLightsOnlyItsCone) {
    ASSERT_TRUE(renderer().set_material(0, constant_surface(glm::vec3(0.5f), 0.0f, 1.0f)));
    light_by({.kind = Light::Kind::Spot,
              .name = "spot",
              .position_world = {0.0f, 0.5f, 2.5f},
              .direction_world = {0.0f, 0.0f, -1.0f},
              .inner_cone_radians = 0.02f,
              .outer_cone_radians = 0.05f});
    const Image lit = channel(ChannelView::DiffuseDirect);
    EXPECT_GT(pixel_of(lit, 32, 32).g, 0.0f);
    EXPECT_EQ(pixel_of(lit, 44, 32).g, 0.0f);
}

TEST_F(ShadingTest, TheEnvironmentTurnsCounterClockwiseFromAbove) {
    // Bright towards +X alone; turned by -90 degrees (clockwise from above) that lies towards +Z.
    Image map{.width = 64, .height = 32, .channels = 3, .type = SampleType::F32, .data = {}};
    map.data.resize(map.row_bytes() * 32, std::byte{0});
    const glm::vec3 white(1.0f);
    for (int y = 0; y < 32; ++y)
        for (int x = 24; x < 40; ++x)
            std::memcpy(map.data.data() + static_cast<std::size_t>(y) * map.row_bytes() +
                            static_cast<std::size_t>(x) * sizeof white,
                        &white, sizeof white);
    ASSERT_TRUE(
        renderer().set_environment(value_of(filter_environment(map, FilterQuality::First))));
    ASSERT_TRUE(renderer().set_material(0, constant_surface(glm::vec3(1.0f), 1.0f, 0.0f)));
    EXPECT_NEAR(middle(ChannelView::SpecularAmbient).g, 0.0f, 0.02f);
    view_.environment_rotation_degrees = -90.0f;
    EXPECT_NEAR(middle(ChannelView::SpecularAmbient).g, 1.0f, 0.02f);
    view_.environment_rotation_degrees = 90.0f;
    EXPECT_NEAR(middle(ChannelView::SpecularAmbient).g, 0.0f, 0.02f);
}

/// Grooves four texels wide, far finer than a pixel, tilted by `tilt` to either side.
ImagePtr grooves(float tilt) {
    constexpr int kSide = 1024;
    Image image{.width = kSide, .height = kSide, .channels = 3, .type = SampleType::U8, .data = {}};
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
            for (const float n :
                 {(x / 4 + y / 4) % 2 == 0 ? tilt : -tilt, 0.0f, std::sqrt(1.0f - tilt * tilt)})
                image.data.push_back(static_cast<std::byte>(std::lround(n * 127.5f + 127.5f)));
    return std::make_shared<const Image>(std::move(image));
}

TEST_F(ShadingTest, NormalsFinerThanAPixelMakeItRougherByWhatTheyVary) {
    show(scene_of(shape_mesh(Shape::Plane)));
    view_.camera = framed(renderer().bounds_world(), 1.0f, ViewDirection::Top);
    light_by({.name = "sun", .direction_world = {0.0f, -1.0f, 0.0f}});
    SurfaceMaterial surface = constant_surface(glm::vec3(1.0f), 1.0f, 0.3f);
    surface[Slot::Normal].texture.pixels = grooves(0.2f);
    ASSERT_TRUE(renderer().set_material(0, surface));
    const auto brightness = [&] { return middle(ChannelView::Final).g; };
    const float filtered = brightness();
    view_.filter_normals = false;
    const float unfiltered = brightness();
    // Head on GGX is 1 / (pi alpha^2): as 0.3^4 to 0.3^4 + 0.2^2.
    EXPECT_NEAR(filtered / unfiltered, 0.0081f / (0.0081f + 0.04f), 0.02f);
    view_.filter_normals = true;
    EXPECT_NEAR(middle(ChannelView::Roughness).x, 0.3f, 1e-3f) << "channels show what is stored";
}

TEST_F(ShadingTest, FilteredNormalsAreNearWhatManyDrawsOfTheNormalMapComeTo) {
    show(scene_of(shape_mesh(Shape::Plane)));
    view_.camera = framed(renderer().bounds_world(), 1.0f, ViewDirection::Top);
    light_by({.name = "sun", .direction_world = {0.0f, -1.0f, 0.0f}});
    SurfaceMaterial surface = constant_surface(glm::vec3(1.0f), 1.0f, 0.4f);
    surface[Slot::Normal].texture.pixels = grooves(0.1f);
    ASSERT_TRUE(renderer().set_material(0, surface));
    const float filtered = middle(ChannelView::Final).g;
    const float truth = pixel_of(value_of(renderer().still_linear(view_, kSize, 256)), 32, 32).g;
    view_.filter_normals = false;
    const float unfiltered = middle(ChannelView::Final).g;
    EXPECT_LT(std::abs(filtered - truth), 0.6f * std::abs(unfiltered - truth));
}

TEST_F(ShadingTest, TheBackgroundShowsTheEnvironmentBehindTheCamerasTarget) {
    Image map{.width = 64, .height = 32, .channels = 3, .type = SampleType::F32, .data = {}};
    map.data.resize(map.row_bytes() * 32, std::byte{0});
    // Red towards -Z (u = 0.25), where a front view looks.
    const glm::vec3 red(1.0f, 0.0f, 0.0f);
    for (int y = 0; y < 32; ++y)
        for (int x = 8; x < 24; ++x)
            std::memcpy(map.data.data() + static_cast<std::size_t>(y) * map.row_bytes() +
                            static_cast<std::size_t>(x) * sizeof red,
                        &red, sizeof red);
    ASSERT_TRUE(
        renderer().set_environment(value_of(filter_environment(map, FilterQuality::First))));
    view_.background.kind = Background::Kind::Environment;
    const glm::vec4 corner = pixel_of(channel(ChannelView::Final), 1, 32);
    EXPECT_NEAR(corner.r, 1.0f, 0.01f);
    EXPECT_NEAR(corner.g, 0.0f, 0.01f);
    EXPECT_EQ(corner.a, 1.0f);
}

TEST_F(ShadingTest, PhongsHighlightIsAsWideAsThatOfGgxAtHalfItsMaximum) {
    const float roughness = 0.35f;
    ASSERT_TRUE(renderer().set_material(0, constant_surface(glm::vec3(1.0f), 1.0f, roughness)));
    light_by({.name = "sun", .intensity = 1.0f, .direction_world = {0.0f, 0.0f, -1.0f}});
    view_.camera.orthographic_height = 1.1f;
    const auto half_width = [&](ShadingModel model, ChannelView wanted) {
        view_.left.model = model;
        const Image lit = channel(wanted);
        const float peak = pixel_of(lit, 32, 32).g;
        int x = 32;
        while (x < kSize.width && pixel_of(lit, x, 32).g > 0.5f * peak) ++x;
        return x - 32;
    };
    const int ggx = half_width(ShadingModel::Pbr, ChannelView::DistributionTerm);
    EXPECT_NEAR(half_width(ShadingModel::Phong, ChannelView::SpecularDirect), ggx, 1);
    EXPECT_NEAR(half_width(ShadingModel::BlinnPhong, ChannelView::SpecularDirect), ggx, 1);
}

TEST_F(ShadingTest, PhongTakesOverridesInPlaceOfTheConversion) {
    ASSERT_TRUE(renderer().set_material(0, constant_surface(glm::vec3(0.5f), 0.0f, 0.3f)));
    light_by({.name = "sun", .intensity = 3.14159265f, .direction_world = {0.0f, 0.0f, -1.0f}});
    view_.left.model = ShadingModel::Phong;
    view_.left.phong.specular_color_linear = {0.25f, 0.5f, 0.75f};
    view_.left.phong.ambient_linear = {0.1f, 0.2f, 0.4f};
    EXPECT_NEAR(middle(ChannelView::DiffuseAmbient).b, 0.2f, 0.01f);
    view_.left.phong.exponent = 1.0f;
    EXPECT_NEAR(middle(ChannelView::SpecularDirect).b, 0.75f, 0.01f);
    const float broad = pixel_of(channel(ChannelView::SpecularDirect), 44, 32).b;
    view_.left.phong.exponent = 500.0f;
    EXPECT_LT(pixel_of(channel(ChannelView::SpecularDirect), 44, 32).b, 0.1f * broad);
    view_.left.phong.exponent = 1.0f;
    view_.left.phong.specular_strength = 0.5f;
    EXPECT_NEAR(middle(ChannelView::SpecularDirect).b, 0.375f, 0.01f);
    view_.left.phong.specular_color_linear.reset();
    const float half = middle(ChannelView::SpecularDirect).g;
    view_.left.phong.specular_strength = 1.0f;
    EXPECT_NEAR(middle(ChannelView::SpecularDirect).g, 2.0f * half, 1e-3f);
}

TEST_F(ShadingTest, UnlitSurfacesShowTheirBaseColour) {
    SurfaceMaterial surface = constant_surface({0.2f, 0.4f, 0.6f}, 0.0f, 0.5f);
    surface.unlit = true;
    ASSERT_TRUE(renderer().set_material(0, surface));
    view_.lights = {slanted_sun()};
    EXPECT_NEAR(middle(ChannelView::Final).b, 0.6f, 0.005f);
}

TEST_F(ShadingTest, NothingIsInfiniteOrNotANumberAtTheEndsOfEveryRange) {
    ASSERT_TRUE(renderer().set_environment(filtered_builtin("sky")));
    view_.background.kind = Background::Kind::Environment;
    view_.lights = {
        slanted_sun(),
        {.kind = Light::Kind::Point, .name = "lamp", .position_world = {0, 0.5f, 0.5f}}};
    for (const float roughness : {0.0f, 1.0f})
        for (const float metalness : {0.0f, 1.0f})
            for (const glm::vec3 color : {glm::vec3(0.0f), glm::vec3(1.0f)}) {
                ASSERT_TRUE(
                    renderer().set_material(0, constant_surface(color, metalness, roughness)));
                for (const auto& model : kShadingModels) {
                    view_.left.model = model.value;
                    const Image picture = channel(ChannelView::Final);
                    for (int i = 0; i < kSize.width * kSize.height; ++i) {
                        const glm::vec4 pixel = pixel_of(picture, i % kSize.width, i / kSize.width);
                        ASSERT_TRUE(std::isfinite(pixel.r + pixel.g + pixel.b)) << model.id;
                        ASSERT_GE(pixel.g, 0.0f);
                    }
                }
            }
}

/// What the filtered levels hold for a direction: the map under GGX's lobe for n = v = r.
glm::dvec3 blurred(const RadianceMap& map, const glm::vec3& direction, float roughness) {
    const float alpha = formulae::alpha_from_roughness(roughness);
    glm::dvec3 sum(0.0);
    double total = 0.0;
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x) {
            const float n_dot_l = glm::dot(texel_direction(map, x, y), direction);
            if (n_dot_l <= 0.0f) continue;
            const float n_dot_h = std::sqrt(0.5f + 0.5f * n_dot_l);
            const double weight = double{formulae::distribution_ggx(n_dot_h, alpha)} * n_dot_l *
                                  texel_solid_angle(map, y);
            sum += weight * glm::dvec3(map.at(x, y));
            total += weight;
        }
    return sum / total;
}

TEST_F(ShadingTest, TheBlurredBackgroundShowsItsSun) {
    const Image sky = value_of(builtin_environment("sky", 128));
    const FilteredEnvironment filtered = value_of(filter_environment(sky, FilterQuality::Finished));
    ASSERT_EQ(filtered.suns.size(), 1u);
    ASSERT_TRUE(renderer().set_environment(filtered));
    view_.background.kind = Background::Kind::BlurredEnvironment;
    // The model is ahead, and below the middle of the picture.
    const glm::vec3 towards = filtered.suns.front().towards_map;
    view_.camera.position = glm::vec3(0.0f, 1.5f, 0.0f) - 5.0f * towards;
    view_.camera.target = view_.camera.position + towards;
    const Image picture = channel(ChannelView::Final);
    const RadianceMap map = value_of(radiance_map(sky));
    const auto seen = glm::dvec3(pixel_of(picture, kSize.width / 2, kSize.height / 2));
    const glm::dvec3 expected = blurred(map, towards, 0.35f);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c] / expected[c], 1.0, 0.15) << c;
}

}  // namespace
}  // namespace patina::render
