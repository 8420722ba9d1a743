// SPDX-License-Identifier: MIT

/// The forward path beside the deferred one: the same picture by other passes.

#include <cmath>
#include <cstdio>

#include "render/render_test.h"

namespace patina::render {
namespace {

constexpr PictureSize kLarge = {320, 240};

struct PictureDifference {
    double beyond_one = 0.0;  ///< share of pixels more than one byte apart
    int most = 0;             ///< bytes
};

PictureDifference difference(const Image& a, const Image& b) {
    PictureDifference found;
    const std::size_t pixels = a.data.size() / 4;
    std::size_t beyond = 0;
    for (std::size_t i = 0; i < pixels; ++i) {
        int most = 0;
        for (std::size_t c = 0; c < 4; ++c)
            most = std::max(most, std::abs(std::to_integer<int>(a.data[4 * i + c]) -
                                           std::to_integer<int>(b.data[4 * i + c])));
        beyond += most > 1 ? 1 : 0;
        found.most = std::max(found.most, most);
    }
    found.beyond_one = static_cast<double>(beyond) / static_cast<double>(pixels);
    return found;
}

/// Three shapes that hide one another: solid, cut out by alpha, and half transparent.
ScenePtr crowded_scene() {
    auto scene = std::make_shared<Scene>();
    const std::array<Shape, 3> shapes = {Shape::ShaderBall, Shape::Torus, Shape::Sphere};
    for (int i = 0; i < 3; ++i) {
        Mesh mesh = shape_mesh(shapes[static_cast<std::size_t>(i)]);
        for (Primitive& primitive : mesh.primitives) primitive.source_material = i;
        glm::mat4 place(1.0f);
        place[3] =
            glm::vec4(0.4f * static_cast<float>(i), 0.0f, 0.5f * static_cast<float>(i), 1.0f);
        scene->meshes.push_back(std::move(mesh));
        scene->instances.push_back({.mesh = i, .world_from_local = place, .name = "shape"});
    }
    return scene;
}

ImagePtr stripes() {
    Image image{.width = 64, .height = 64, .channels = 4, .type = SampleType::U8, .data = {}};
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            for (const int value : {40 + 3 * x, 200 - 2 * y, 128, x / 8 % 2 == 0 ? 255 : 0})
                image.data.push_back(static_cast<std::byte>(value));
    return std::make_shared<const Image>(std::move(image));
}

/// Waves of tilts up to 30 degrees.
ImagePtr waves() {
    Image image{.width = 64, .height = 64, .channels = 3, .type = SampleType::U8, .data = {}};
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            const glm::vec3 n =
                glm::normalize(glm::vec3(0.5f * std::sin(0.8f * static_cast<float>(x)),
                                         0.3f * std::cos(0.6f * static_cast<float>(y)), 1.0f));
            for (int c = 0; c < 3; ++c)
                image.data.push_back(static_cast<std::byte>(std::lround(n[c] * 127.5f + 127.5f)));
        }
    return std::make_shared<const Image>(std::move(image));
}

class ForwardTest : public RenderTest {
  protected:
    void SetUp() override {
        RenderTest::SetUp();
        ASSERT_TRUE(renderer().set_environment(filtered_builtin("studio")));
        show(crowded_scene());
        view_.camera = framed(renderer().bounds_world(), 4.0f / 3.0f);
        view_.tone_map = ToneMap::PbrNeutral;
        view_.background.kind = Background::Kind::Studio;
        view_.lights = {{.kind = Light::Kind::Directional,
                         .name = "directional",
                         .intensity = 1.5f,
                         .direction_world = glm::normalize(glm::vec3(-1.0f, -1.0f, -0.5f))},
                        {.kind = Light::Kind::Spot,
                         .name = "spot",
                         .intensity = 8.0f,
                         .position_world = {1.0f, 3.0f, 1.0f},
                         .direction_world = {0.0f, -1.0f, 0.0f}},
                        {.kind = Light::Kind::Sphere,
                         .name = "sphere",
                         .intensity = 2.0f,
                         .position_world = {-1.0f, 1.0f, 2.0f}},
                        {.kind = Light::Kind::Rectangle,
                         .name = "rectangle",
                         .intensity = 2.0f,
                         .position_world = {2.0f, 1.0f, 2.0f},
                         .direction_world = glm::normalize(glm::vec3(-1.0f, -0.4f, -1.0f))}};
        SurfaceMaterial solid = constant_surface({0.8f, 0.5f, 0.3f}, 0.6f, 0.4f);
        solid[Slot::Normal].texture.pixels = waves();
        ASSERT_TRUE(renderer().set_material(0, solid));
        SurfaceMaterial cut = constant_surface(glm::vec3(1.0f), 1.0f, 0.25f);
        cut[Slot::BaseColor].texture = {.pixels = stripes(), .srgb = true};
        cut.alpha_mode = AlphaMode::Mask;
        cut.double_sided = true;
        ASSERT_TRUE(renderer().set_material(1, cut));
        SurfaceMaterial glass = constant_surface({0.3f, 0.5f, 0.9f}, 0.0f, 0.1f);
        glass[Slot::BaseColor].multiply.a = 0.4f;
        glass.alpha_mode = AlphaMode::Blend;
        ASSERT_TRUE(renderer().set_material(2, glass));
    }

    Image picture(RenderPath path) {
        view_.left.path = path;
        EXPECT_TRUE(renderer().draw(view_, kLarge));
        return value_of(renderer().read_picture());
    }

    void expect_same_picture(const std::string& what) {
        const PictureDifference found =
            difference(picture(RenderPath::Deferred), picture(RenderPath::Forward));
        std::printf("%-14s beyond 1/255: %.5f, most %d\n", what.c_str(), found.beyond_one,
                    found.most);
        EXPECT_LE(found.beyond_one, 0.001) << what;
        EXPECT_LE(found.most, 3) << what;
    }
};

TEST_F(ForwardTest, BothPathsDrawTheSamePictureWithEveryModel) {
    for (const auto& model : kShadingModels) {
        view_.left.model = model.value;
        expect_same_picture(std::string(model.id));
    }
}

TEST_F(ForwardTest, BothPathsDrawTheSamePictureOverEveryBackground) {
    for (const auto& background : kBackgrounds) {
        view_.background.kind = background.value;
        expect_same_picture(std::string(background.id));
    }
}

TEST_F(ForwardTest, BothPathsDrawTheSamePictureOfSmoothAndRoughMetal) {
    for (const float roughness : {0.1f, 0.2f, 0.5f, 1.0f}) {
        SurfaceMaterial solid = constant_surface({0.8f, 0.5f, 0.3f}, 1.0f, roughness);
        solid[Slot::Normal].texture.pixels = waves();
        ASSERT_TRUE(renderer().set_material(0, solid));
        expect_same_picture("roughness " + std::to_string(roughness));
    }
}

TEST_F(ForwardTest, LightBeyondWhatHalfFloatsHoldIsStillANumberUnderWhatBlends) {
    constexpr float kRadiance = 3e5f;
    SurfaceMaterial blazing = constant_surface(glm::vec3(0.5f), 0.0f, 0.5f);
    blazing[Slot::Emissive].multiply = glm::vec4(1.0f);
    blazing.emissive_strength = kRadiance;
    ASSERT_TRUE(renderer().set_material(0, blazing));
    view_.left.path = RenderPath::Forward;
    const Image picture = value_of(renderer().still_linear(view_, {64, 48}, 4));
    float brightest = 0.0f;
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x) {
            const glm::vec4 pixel = pixel_of(picture, x, y);
            ASSERT_TRUE(std::isfinite(pixel.r)) << x << " " << y;
            brightest = std::max(brightest, pixel.r);
        }
    EXPECT_NEAR(brightest, kRadiance, 0.01f * kRadiance);
}

TEST_F(ForwardTest, APathIsOneSideOfAComparison) {
    view_.compare = CompareMode::Split;
    view_.right = view_.left;
    const auto drawn = [&] {
        EXPECT_TRUE(renderer().draw(view_, kLarge));
        return value_of(renderer().read_picture());
    };
    const Image deferred = drawn();
    view_.right.path = RenderPath::Forward;
    const PictureDifference found = difference(deferred, drawn());
    EXPECT_LE(found.beyond_one, 0.001);
    EXPECT_LE(found.most, 3);
}

TEST_F(ForwardTest, AForwardSideHasNoGBufferAndItsOwnPasses) {
    view_.compare = CompareMode::Split;
    view_.right.model = view_.left.model;
    view_.right.path = RenderPath::Forward;
    ASSERT_TRUE(renderer().draw(view_, kLarge));
    const FrameStats stats = value_of(renderer().draw(view_, kLarge));
    const auto has_pass = [](const SideCost& side, std::string_view name) {
        return std::any_of(side.passes.begin(), side.passes.end(),
                           [&](const PassCost& pass) { return pass.name == name; });
    };
    EXPECT_GT(stats.left.gbuffer_bytes, 0u);
    EXPECT_TRUE(has_pass(stats.left, "G-buffer"));
    EXPECT_TRUE(has_pass(stats.left, "Lighting"));
    ASSERT_TRUE(stats.right);
    EXPECT_EQ(stats.right->gbuffer_bytes, 0u);
    EXPECT_TRUE(has_pass(*stats.right, "Forward"));
    EXPECT_FALSE(has_pass(*stats.right, "G-buffer"));
}

TEST_F(ForwardTest, AMeanOfManyDrawsIsTheSameOnBothPaths) {
    view_.background.kind = Background::Kind::Transparent;
    view_.left.path = RenderPath::Deferred;
    const Image deferred = value_of(renderer().still_srgb(view_, {64, 48}, 16));
    view_.left.path = RenderPath::Forward;
    const PictureDifference found =
        difference(deferred, value_of(renderer().still_srgb(view_, {64, 48}, 16)));
    EXPECT_LE(found.beyond_one, 0.02);
    EXPECT_LE(found.most, 12);
}

/// What is hollow and lets half of the light through.
class BlendTest : public RenderTest {
  protected:
    void SetUp() override {
        RenderTest::SetUp();
        SurfaceMaterial glass = constant_surface({0.2f, 0.4f, 0.9f}, 0.0f, 0.2f);
        glass[Slot::BaseColor].multiply.a = 0.5f;
        glass.alpha_mode = AlphaMode::Blend;
        glass.double_sided = true;
        ASSERT_TRUE(renderer().set_material(0, glass));
        ASSERT_TRUE(renderer().set_environment(filtered_builtin("studio")));
    }
    Image picture_of(const Mesh& mesh) {
        auto scene = std::make_shared<Scene>();
        scene->meshes = {mesh};
        for (Primitive& primitive : scene->meshes[0].primitives) primitive.source_material = 0;
        scene->instances = {{.mesh = 0, .world_from_local = glm::mat4(1.0f), .name = "glass"}};
        show(scene);
        view_.camera = framed(renderer().bounds_world(), 1.0f);
        return value_of(renderer().still_linear(view_, kSize, 1));
    }
};

/// The same mesh with the triangles of each primitive in another order.
template <typename Order>
Mesh reordered(Mesh mesh, const Order& order) {
    for (Primitive& primitive : mesh.primitives) {
        const std::vector<std::uint32_t> before = primitive.indices;
        const std::size_t count = before.size() / 3;
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t corner = 0; corner < 3; ++corner)
                primitive.indices[3 * i + corner] = before[3 * order(i, count) + corner];
    }
    return mesh;
}

TEST_F(BlendTest, TheOrderOfAFilesTrianglesIsNotSeen) {
    for (const Shape shape : {Shape::Sphere, Shape::Torus}) {
        const Mesh mesh = shape_mesh(shape);
        const Image as_it_is = picture_of(mesh);
        const auto backwards = [](std::size_t i, std::size_t count) { return count - 1 - i; };
        const Image turned_round = picture_of(reordered(mesh, backwards));
        for (int y = 0; y < kSize.height; ++y)
            for (int x = 0; x < kSize.width; ++x)
                ASSERT_NEAR(glm::distance(pixel_of(as_it_is, x, y), pixel_of(turned_round, x, y)),
                            0.0f, 1e-4f)
                    << x << " " << y;
    }
}

TEST_F(BlendTest, TheNearWallOfABallIsOverTheFarOne) {
    SurfaceMaterial flat = constant_surface(glm::vec3(1.0f), 0.0f, 0.5f);
    flat[Slot::BaseColor].multiply.a = 0.5f;
    flat.alpha_mode = AlphaMode::Blend;
    flat.double_sided = true;
    flat.unlit = true;
    ASSERT_TRUE(renderer().set_material(0, flat));
    Mesh ball = shape_mesh(Shape::Sphere);
    Primitive& primitive = ball.primitives[0];
    for (const glm::vec3& at : primitive.positions)
        primitive.colors.push_back(at.z > 0.0f ? glm::vec4(0.0f, 1.0f, 0.0f, 1.0f)
                                               : glm::vec4(1.0f, 0.0f, 0.0f, 1.0f));
    show(scene_of(ball));
    const Image picture = value_of(renderer().still_linear(view_, kSize, 1));
    const glm::vec4 middle = pixel_of(picture, kSize.width / 2, kSize.height / 2);
    EXPECT_NEAR(glm::distance(middle, glm::vec4(0.25f, 0.5f, 0.0f, 0.75f)), 0.0f, 1e-3f);
}

}  // namespace
}  // namespace patina::render
