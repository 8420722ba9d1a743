// SPDX-License-Identifier: MIT

/// What the G-buffer and the inspection pass hold, against numbers computed on the CPU.

#include <glm/gtc/matrix_transform.hpp>

#include "render/render_test.h"

namespace patina::render {
namespace {

/// Half floats keep eleven bits.
constexpr float kHalfStep = 1.0f / 2048.0f;
/// What drivers read sRGB texels to: llvmpipe's curve is up to three thousandths off.
constexpr float kSrgbTexel = 1e-3f;

using GBufferTest = RenderTest;

void expect_near(const glm::vec3& actual, const glm::vec3& expected, float tolerance) {
    EXPECT_NEAR(actual.x, expected.x, tolerance);
    EXPECT_NEAR(actual.y, expected.y, tolerance);
    EXPECT_NEAR(actual.z, expected.z, tolerance);
}

ImagePtr rgba_image(int width, int height, const std::vector<std::uint8_t>& values) {
    Image image{
        .width = width, .height = height, .channels = 4, .type = SampleType::U8, .data = {}};
    for (const std::uint8_t value : values) image.data.push_back(std::byte{value});
    return std::make_shared<const Image>(std::move(image));
}

/// Everywhere the same tangent-space normal.
SurfaceMaterial tilted_surface(float x, float y) {
    SurfaceMaterial surface = plain_surface();
    const auto byte = [](float v) {
        return static_cast<std::uint8_t>((v * 0.5f + 0.5f) * 255.0f + 0.5f);
    };
    surface[Slot::Normal].texture.pixels =
        rgba_image(1, 1, {byte(x), byte(y), byte(std::sqrt(1.0f - x * x - y * y)), 255});
    return surface;
}

int covered_pixels(const Image& image) {
    int count = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) count += pixel_of(image, x, y).a > 0.5f ? 1 : 0;
    return count;
}

TEST_F(GBufferTest, HoldsTheFactorsOfAConstantMaterial) {
    SurfaceMaterial surface = constant_surface({0.2f, 0.5f, 0.8f}, 0.25f, 0.6f);
    surface[Slot::Emissive].multiply = glm::vec4(0.1f, 0.2f, 0.3f, 1.0f);
    surface[Slot::Occlusion].multiply = glm::vec4(0.7f);
    surface.emissive_strength = 20.0f;
    surface.ior = 1.8f;
    ASSERT_TRUE(renderer().set_material(0, surface));
    expect_near(middle(ChannelView::BaseColor), {0.2f, 0.5f, 0.8f}, kHalfStep);
    EXPECT_NEAR(middle(ChannelView::Metalness).x, 0.25f, kHalfStep);
    EXPECT_NEAR(middle(ChannelView::Roughness).x, 0.6f, kHalfStep);
    EXPECT_NEAR(middle(ChannelView::Occlusion).x, 0.7f, kHalfStep);
    EXPECT_NEAR(middle(ChannelView::Ior).x, 1.8f, 2.0f * kHalfStep);
    expect_near(middle(ChannelView::Emissive), {2.0f, 4.0f, 6.0f}, 6.0f * kHalfStep);
    // ((1.8 - 1) / (1.8 + 1))^2 mixed with the base colour by metalness.
    const float dielectric = 0.0816327f;
    expect_near(middle(ChannelView::F0),
                glm::mix(glm::vec3(dielectric), glm::vec3(0.2f, 0.5f, 0.8f), 0.25f), kHalfStep);
}

TEST_F(GBufferTest, SpecularFactorAndColourScaleF0OfWhatIsNotMetal) {
    SurfaceMaterial surface = constant_surface(glm::vec3(0.5f), 0.0f, 0.5f);
    surface.specular_factor = 0.5f;
    surface.specular_color_linear = {1.0f, 0.5f, 0.0f};
    ASSERT_TRUE(renderer().set_material(0, surface));
    expect_near(middle(ChannelView::F0), {0.02f, 0.01f, 0.0f}, kHalfStep);
}

TEST_F(GBufferTest, SpecularMapsScaleTheFactorByAlphaAndTheColourByColour) {
    SurfaceMaterial surface = constant_surface(glm::vec3(0.5f), 0.0f, 0.5f);
    surface.specular_map.pixels = rgba_image(1, 1, {0, 0, 0, 128});
    surface.specular_color_map = {.pixels = rgba_image(1, 1, {255, 188, 0, 255}), .srgb = true};
    ASSERT_TRUE(renderer().set_material(0, surface));
    const float half = 128.0f / 255.0f;
    expect_near(middle(ChannelView::F0), {0.04f * half, 0.04f * half * 0.503f, 0.0f}, kHalfStep);
}

TEST_F(GBufferTest, ATexelIsSeenAsWideAsAPixelWhereTheModelIsNearest) {
    Mesh plane = shape_mesh(Shape::Plane);
    const auto diagonal = [](const auto& places) {
        return glm::distance(places.front(), places.back());
    };
    const float metres_per_uv =
        diagonal(plane.primitives[0].positions) / diagonal(plane.primitives[0].uvs[0]);
    plane.primitives[0].source_material = 3;
    show(scene_of(plane, glm::scale(glm::mat4(1.0f), glm::vec3(2.0f))));
    Camera above = framed(renderer().bounds_world(), 1.0f, ViewDirection::Top);
    const float distance = above.position.y - renderer().bounds_world().high.y;
    const float texels = renderer().texels_seen(3, 0, above, 512);
    EXPECT_NEAR(texels, 2.0f * metres_per_uv * pixels_per_metre(above, 512, distance),
                0.001f * texels);
    EXPECT_NEAR(renderer().texels_seen(3, 0, above, 1024), 2.0f * texels, 0.001f * texels);
    EXPECT_EQ(renderer().texels_seen(0, 0, above, 512), 0.0f) << "nothing wears it";
}

TEST_F(GBufferTest, PositionDepthAndNormalAreThoseOfTheSphere) {
    const glm::vec3 center(0.0f, 0.5f, 0.0f);
    const Image positions = channel(ChannelView::Position);
    const Image normals = channel(ChannelView::NormalWorld);
    const Image depths = channel(ChannelView::Depth);
    int checked = 0;
    for (int y = 0; y < kSize.height; ++y)
        for (int x = 0; x < kSize.width; ++x) {
            if (pixel_of(positions, x, y).a == 0.0f) continue;
            const glm::vec3 position(pixel_of(positions, x, y));
            // Facets of the mesh lie a little inside the sphere.
            EXPECT_NEAR(glm::distance(position, center), 0.5f, 0.004f);
            expect_near(glm::vec3(pixel_of(normals, x, y)), glm::normalize(position - center),
                        0.02f);
            EXPECT_NEAR(pixel_of(depths, x, y).x, view_.camera.position.z - position.z, 1e-4f);
            ++checked;
        }
    EXPECT_GT(checked, 1500);
}

TEST_F(GBufferTest, ViewNormalsFaceTheCamera) {
    view_.camera = framed(renderer().bounds_world(), 1.0f, ViewDirection::Left);
    expect_near(middle(ChannelView::NormalView), {0.0f, 0.0f, 1.0f}, 0.05f);
    expect_near(middle(ChannelView::NormalWorld), {-1.0f, 0.0f, 0.0f}, 0.05f);
    expect_near(middle(ChannelView::GeometricNormal), {-1.0f, 0.0f, 0.0f}, 0.1f);
}

TEST_F(GBufferTest, NormalMapsTiltAlongTangentAndBitangent) {
    ASSERT_TRUE(renderer().set_material(0, plain_surface()));
    const glm::vec3 normal = middle(ChannelView::NormalWorld);
    const glm::vec3 tangent = middle(ChannelView::Tangent);
    // The middle of the sphere's front: +U goes right and v down, so up in the picture is +Y.
    EXPECT_GT(tangent.x, 0.99f);
    ASSERT_TRUE(renderer().set_material(0, tilted_surface(0.6f, 0.0f)));
    expect_near(middle(ChannelView::NormalWorld), 0.6f * tangent + 0.8f * normal, 0.02f);
    ASSERT_TRUE(renderer().set_material(0, tilted_surface(0.0f, 0.6f)));
    const glm::vec3 up(0.0f, 1.0f, 0.0f);
    expect_near(middle(ChannelView::NormalWorld), 0.6f * up + 0.8f * normal, 0.03f);
}

TEST_F(GBufferTest, AMirroredInstanceKeepsItsOutsideAndMirrorsItsRelief) {
    const Mesh sphere = shape_mesh(Shape::Sphere);
    ASSERT_TRUE(renderer().set_material(0, tilted_surface(0.5f, 0.5f)));
    // The column that mirrors the one right of the middle.
    const glm::vec3 before(pixel_of(channel(ChannelView::NormalWorld), kSize.width / 2 - 1, 32));
    show(scene_of(sphere, glm::scale(glm::mat4(1.0f), {-1.0f, 1.0f, 1.0f})));
    const glm::vec3 mirrored = middle(ChannelView::NormalWorld);
    EXPECT_GT(covered_pixels(channel(ChannelView::NormalWorld)), 1500);
    expect_near(mirrored, before * glm::vec3(-1.0f, 1.0f, 1.0f), 0.02f);
}

TEST_F(GBufferTest, UnevenScaleKeepsNormalsAcrossTheSurface) {
    show(scene_of(shape_mesh(Shape::Sphere), glm::scale(glm::mat4(1.0f), {2.0f, 1.0f, 1.0f})));
    const Image positions = channel(ChannelView::Position);
    const Image normals = channel(ChannelView::NormalWorld);
    const int x = 44;
    const int y = 26;
    ASSERT_GT(pixel_of(positions, x, y).a, 0.0f);
    const glm::vec3 p = glm::vec3(pixel_of(positions, x, y)) - glm::vec3(0.0f, 0.5f, 0.0f);
    // The gradient of (x / 2)^2 + y^2 + z^2.
    expect_near(glm::vec3(pixel_of(normals, x, y)),
                glm::normalize(p * glm::vec3(0.25f, 1.0f, 1.0f)), 0.02f);
}

TEST_F(GBufferTest, TheAlphaMaskCutsOutWhatIsBelowTheCutoff) {
    show(scene_of(shape_mesh(Shape::Plane)));
    view_.camera = framed(renderer().bounds_world(), 1.0f, ViewDirection::Top);
    SurfaceMaterial surface = plain_surface();
    const int whole = covered_pixels(channel(ChannelView::BaseColor));
    surface[Slot::BaseColor].texture = {.pixels = rgba_image(2, 1, {9, 9, 9, 100, 9, 9, 9, 200}),
                                        .filter = Filter::Nearest};
    surface.alpha_mode = AlphaMode::Mask;
    surface.alpha_cutoff = 0.5f;
    ASSERT_TRUE(renderer().set_material(0, surface));
    EXPECT_NEAR(covered_pixels(channel(ChannelView::BaseColor)), whole / 2, kSize.height);
    EXPECT_NEAR(covered_pixels(channel(ChannelView::Alpha)), whole / 2, kSize.height);
    surface.alpha_mode = AlphaMode::Opaque;
    ASSERT_TRUE(renderer().set_material(0, surface));
    EXPECT_EQ(covered_pixels(channel(ChannelView::BaseColor)), whole);
}

TEST_F(GBufferTest, TheBackOfASurfaceIsSeenOnlyWhenItIsDoubleSidedAndThenFacesTheCamera) {
    show(scene_of(shape_mesh(Shape::Plane)));
    view_.camera = framed(renderer().bounds_world(), 1.0f, ViewDirection::Bottom);
    SurfaceMaterial surface = plain_surface();
    ASSERT_TRUE(renderer().set_material(0, surface));
    EXPECT_EQ(covered_pixels(channel(ChannelView::BaseColor)), 0);
    surface.double_sided = true;
    ASSERT_TRUE(renderer().set_material(0, surface));
    EXPECT_GT(covered_pixels(channel(ChannelView::BaseColor)), 1000);
    expect_near(middle(ChannelView::NormalWorld), {0.0f, -1.0f, 0.0f}, 0.02f);
}

TEST_F(GBufferTest, VertexColoursMultiplyTheBaseColour) {
    Mesh sphere = shape_mesh(Shape::Sphere);
    for (Primitive& primitive : sphere.primitives)
        primitive.colors.assign(primitive.positions.size(), glm::vec4(0.5f, 1.0f, 0.25f, 1.0f));
    show(scene_of(std::move(sphere)));
    ASSERT_TRUE(renderer().set_material(0, constant_surface(glm::vec3(0.8f), 0.0f, 0.5f)));
    expect_near(middle(ChannelView::BaseColor), {0.4f, 0.8f, 0.2f}, kHalfStep);
}

TEST_F(GBufferTest, EachMapHasItsOwnUvSetAndTransform) {
    Mesh plane = shape_mesh(Shape::Plane);
    for (Primitive& primitive : plane.primitives)
        primitive.uvs[1].assign(primitive.positions.size(), glm::vec2(0.75f, 0.25f));
    show(scene_of(std::move(plane)));
    view_.camera = framed(renderer().bounds_world(), 1.0f, ViewDirection::Top);
    // Columns: dark, bright. TEXCOORD_1 is in the bright one everywhere.
    const ImagePtr columns = rgba_image(2, 1, {0, 0, 0, 255, 255, 255, 255, 255});
    SurfaceMaterial surface = plain_surface();
    surface[Slot::BaseColor] = {
        .texture = {.pixels = columns, .uv_set = 1, .filter = Filter::Nearest}};
    surface[Slot::MetallicRoughness] = {.texture = {.pixels = columns,
                                                    .uv_set = 1,
                                                    .transform = {.offset = {-0.5f, 0.0f}},
                                                    .filter = Filter::Nearest}};
    surface[Slot::Occlusion] = {.texture = {.pixels = columns,
                                            .uv_set = 1,
                                            .transform = {.rotation_degrees = 90.0f},
                                            .wrap_u = Wrap::Clamp,
                                            .filter = Filter::Nearest}};
    ASSERT_TRUE(renderer().set_material(0, surface));
    EXPECT_NEAR(middle(ChannelView::BaseColor).x, 1.0f, kHalfStep);
    EXPECT_NEAR(middle(ChannelView::Roughness).x, 0.0f, kHalfStep);
    // KHR_texture_transform: (u, v) turns to (v, -u) at 90 degrees: u = 0.25, the dark column.
    EXPECT_NEAR(middle(ChannelView::Occlusion).x, 0.0f, kHalfStep);
    expect_near(middle(ChannelView::Uv1), {0.75f, 0.25f, 0.0f}, 1e-6f);
}

TEST_F(GBufferTest, FactorsScaleAndShiftWhatTexturesSay) {
    SurfaceMaterial surface = plain_surface();
    const ImagePtr half = rgba_image(1, 1, {128, 128, 128, 255});
    // Occlusion of strength 0.5: 1 + 0.5 (x - 1).
    surface[Slot::Occlusion] = {
        .texture = {.pixels = half}, .multiply = glm::vec4(0.5f), .add = glm::vec4(0.5f)};
    surface[Slot::BaseColor] = {.texture = {.pixels = half, .srgb = true},
                                .multiply = glm::vec4(0.5f, 1.0f, 1.0f, 1.0f)};
    ASSERT_TRUE(renderer().set_material(0, surface));
    EXPECT_NEAR(middle(ChannelView::Occlusion).x, 0.5f + 0.5f * 128.0f / 255.0f, kHalfStep);
    expect_near(middle(ChannelView::BaseColor), {0.10793f, 0.21586f, 0.21586f}, kSrgbTexel);
}

TEST_F(GBufferTest, AChangedRectangleIsAllThatIsTakenFromNewPixels) {
    show(scene_of(shape_mesh(Shape::Plane)));
    view_.camera = framed(renderer().bounds_world(), 1.0f, ViewDirection::Top);
    SurfaceMaterial surface = plain_surface();
    surface[Slot::BaseColor] = {
        .texture = {.pixels = rgba_image(2, 1, {0, 0, 0, 255, 0, 0, 0, 255}),
                    .filter = Filter::Nearest}};
    ASSERT_TRUE(renderer().set_material(0, surface));
    const std::size_t bytes_before = renderer().stats().material_texture_bytes;
    surface[Slot::BaseColor].texture.pixels =
        rgba_image(2, 1, {255, 255, 255, 255, 255, 255, 255, 255});
    ASSERT_TRUE(renderer().set_material(0, surface, TexelRect{1, 0, 2, 1}));
    const Image drawn = channel(ChannelView::BaseColor);
    EXPECT_EQ(pixel_of(drawn, 16, 32).x, 0.0f);
    EXPECT_NEAR(pixel_of(drawn, 48, 32).x, 1.0f, kSrgbTexel);
    EXPECT_EQ(renderer().stats().material_texture_bytes, bytes_before);
}

TEST_F(GBufferTest, TheProbeSaysWhatTheChannelsShow) {
    ASSERT_TRUE(renderer().set_material(0, constant_surface({0.2f, 0.5f, 0.8f}, 0.25f, 0.6f)));
    ASSERT_TRUE(renderer().draw(view_, kSize));
    const std::optional<Probe> probe = value_of(renderer().probe({30, 20}));
    ASSERT_TRUE(probe);
    EXPECT_EQ(probe->instance, 0);
    EXPECT_EQ(probe->source_material, 0);
    for (const ChannelViewInfo& entry : kChannelViews) {
        const glm::vec3 shown(pixel_of(channel(entry.view), 30, 20));
        for (int c = 0; c < entry.components; ++c)
            EXPECT_NEAR((*probe)[entry.view][c], shown[c], 1e-5f) << entry.id << " " << c;
    }
    EXPECT_FALSE(value_of(renderer().probe({0, 0}))) << "beside the sphere";
    EXPECT_FALSE(value_of(renderer().probe({-1, 900}))) << "outside the picture";
}

TEST_F(GBufferTest, AnAssignedPartIsDrawnWithAnotherMaterialUntilItIsNot) {
    auto scene = std::make_shared<Scene>(*scene_of(shape_mesh(Shape::Sphere)));
    const PartRef part{.mesh = 3, .primitive = 0};
    scene->meshes[0].primitives[0].source = part;
    show(scene);
    ASSERT_TRUE(renderer().set_material(0, constant_surface({1.0f, 0.0f, 0.0f}, 0.0f, 0.5f)));
    ASSERT_TRUE(renderer().set_material(9, constant_surface({0.0f, 1.0f, 0.0f}, 0.0f, 0.5f)));
    renderer().assign_materials({{part, 9}});
    EXPECT_EQ(pixel_of(channel(ChannelView::BaseColor), 32, 32).y, 1.0f);
    renderer().assign_materials({});
    EXPECT_EQ(pixel_of(channel(ChannelView::BaseColor), 32, 32).x, 1.0f);
}

TEST_F(GBufferTest, APickNamesInstancePrimitiveAndMaterial) {
    auto scene = std::make_shared<Scene>(*scene_of(shape_mesh(Shape::Sphere)));
    scene->meshes[0].primitives[0].source_material = 7;
    scene->instances.insert(scene->instances.begin(), {.mesh = 0,
                                                       .world_from_local = glm::translate(
                                                           glm::mat4(1.0f), {0.0f, 0.0f, -3.0f}),
                                                       .name = "far"});
    show(scene);
    ASSERT_TRUE(renderer().draw(view_, kSize));
    const std::optional<Pick> pick = renderer().pick({32, 32});
    ASSERT_TRUE(pick);
    EXPECT_EQ(pick->instance, 1) << "the nearer one";
    EXPECT_EQ(pick->primitive, 0);
    EXPECT_EQ(pick->source_material, 7);
}

}  // namespace
}  // namespace patina::render
