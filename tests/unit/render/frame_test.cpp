// SPDX-License-Identifier: MIT

/// Frames as a whole: comparing, blending, sizes, stills.

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>

#include "render/render_test.h"

namespace patina::render {
namespace {

class FrameTest : public RenderTest {
  protected:
    void SetUp() override {
        RenderTest::SetUp();
        ASSERT_TRUE(renderer().set_environment(filtered_builtin("studio")));
        ASSERT_TRUE(renderer().set_material(0, constant_surface({0.8f, 0.4f, 0.2f}, 0.5f, 0.4f)));
        view_.background.kind = Background::Kind::Studio;
        view_.tone_map = ToneMap::PbrNeutral;
    }
    Image picture(const View& view, PictureSize size = kSize) {
        if (const Result<FrameStats> drawn = renderer().draw(view, size); !drawn)
            ADD_FAILURE() << drawn.error().message;
        return value_of(renderer().read_picture());
    }
};

/// What the last draw_strip made of thumbnails of that size: RGBA U8, row 0 at the top.
Image strip_of(const Renderer& renderer, PictureSize thumbnail) {
    Image strip{
        .width = kStripChannelCount * thumbnail.width, .height = thumbnail.height, .channels = 4};
    strip.data.resize(strip.row_bytes() * static_cast<std::size_t>(strip.height));
    glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(renderer.strip_texture()));
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, strip.data.data());
    const auto row = [&](int y) {
        return strip.data.begin() +
               static_cast<std::ptrdiff_t>(y) * static_cast<std::ptrdiff_t>(strip.row_bytes());
    };
    for (int y = 0; y < strip.height / 2; ++y)
        std::swap_ranges(row(y), row(y + 1), row(strip.height - 1 - y));
    return strip;
}

/// Columns [first, last) of both pictures are the same bytes.
void expect_same_columns(const Image& a, const Image& b, int first, int last, int shift = 0) {
    for (int y = 0; y < a.height; ++y)
        ASSERT_EQ(0, std::memcmp(a.data.data() + static_cast<std::size_t>(y) * a.row_bytes() +
                                     static_cast<std::size_t>(4 * first),
                                 b.data.data() + static_cast<std::size_t>(y) * b.row_bytes() +
                                     static_cast<std::size_t>(4 * (first - shift)),
                                 static_cast<std::size_t>(4 * (last - first))))
            << "row " << y;
}

TEST_F(FrameTest, EachHalfOfASplitIsThePictureOfItsKind) {
    View single = view_;
    const Image pbr = picture(single);
    single.left = view_.right;
    const Image phong = picture(single);
    ASSERT_NE(pbr, phong);
    View split = view_;
    split.compare = CompareMode::Split;
    for (const int column : {0, 17, 32, 64}) {
        split.divider = static_cast<float>(column) / static_cast<float>(kSize.width);
        const Image both = picture(split);
        expect_same_columns(both, pbr, 0, column);
        expect_same_columns(both, phong, column, kSize.width);
    }
}

TEST_F(FrameTest, EachHalfOfASplitIsThePictureOfItsKindWithBlendedSurfaces) {
    SurfaceMaterial glass = constant_surface({0.8f, 0.4f, 0.2f}, 0.0f, 0.2f);
    glass.alpha_mode = AlphaMode::Blend;
    glass[Slot::BaseColor].multiply.a = 0.5f;
    ASSERT_TRUE(renderer().set_material(0, glass));
    const Image pbr = picture(view_);
    View split = view_;
    split.compare = CompareMode::Split;
    expect_same_columns(picture(split), pbr, 0, kSize.width / 2);
}

TEST_F(FrameTest, TwoViewsAreTwoPicturesOfHalfTheWidth) {
    View two = view_;
    two.compare = CompareMode::TwoViews;
    two.background = {.kind = Background::Kind::Color};
    const Image both = picture(two);
    View single = two;
    single.compare = CompareMode::Single;
    const PictureSize half{kSize.width / 2, kSize.height};
    // Only dither may differ: it follows the place in the picture, as do all other pixels here.
    expect_same_columns(both, picture(single, half), 0, half.width);
    single.left = two.right;
    expect_same_columns(both, picture(single, half), half.width, kSize.width, half.width);
}

TEST_F(FrameTest, TheDifferenceOfEqualSidesIsTheBottomOfTheHeatMap) {
    View view = view_;
    view.compare = CompareMode::Difference;
    view.right = view.left;
    const Image none = picture(view);
    for (std::size_t i = 0; i < none.data.size(); i += 4)
        ASSERT_LT(std::to_integer<int>(none.data[i]), 8);
    view.right.model = ShadingModel::Phong;
    const Image some = picture(view);
    const auto brightest = *std::max_element(some.data.begin(), some.data.end());
    EXPECT_GT(std::to_integer<int>(brightest), 40);
}

TEST_F(FrameTest, AResizedPictureIsTheSameAsOneDrawnAtThatSizeFirst) {
    const Image first = picture(view_);
    const Image small = picture(view_, {33, 17});
    EXPECT_EQ(small.width, 33);
    EXPECT_EQ(small.height, 17);
    EXPECT_EQ(picture(view_), first);
}

TEST_F(FrameTest, SizesOutsideTheLimitsAreAFailureThatNamesThem) {
    const Result<FrameStats> drawn = renderer().draw(view_, {0, 100});
    ASSERT_FALSE(drawn);
    EXPECT_NE(drawn.error().message.find("0 x 100"), std::string::npos);
    EXPECT_FALSE(renderer().still_srgb(view_, kSize, 0));
}

TEST_F(FrameTest, ABlendedSurfaceMixesItsLightWithTheBackground) {
    ASSERT_TRUE(renderer().set_environment(filtered_builtin("white")));
    SurfaceMaterial veil = constant_surface(glm::vec3(1.0f), 0.0f, 1.0f);
    veil.alpha_mode = AlphaMode::Blend;
    veil[Slot::BaseColor].multiply.a = 0.25f;
    ASSERT_TRUE(renderer().set_material(0, veil));
    view_.tone_map = ToneMap::None;
    view_.background = {.kind = Background::Kind::Color, .color_srgb = glm::vec3(0.0f)};
    const Image over_black = value_of(renderer().still_linear(view_, kSize, 1));
    EXPECT_NEAR(pixel_of(over_black, 32, 32).g, 0.25f, 0.01f);
    view_.background.kind = Background::Kind::Transparent;
    const Image alone = value_of(renderer().still_linear(view_, kSize, 1));
    EXPECT_NEAR(pixel_of(alone, 32, 32).a, 0.25f, 0.005f);
    EXPECT_NEAR(middle(ChannelView::Alpha).x, 0.25f, 0.005f);
    EXPECT_NEAR(middle(ChannelView::BaseColor).x, 1.0f, 0.005f) << "the nearest surface";
}

TEST_F(FrameTest, WiresLieOnTheModelAndOnNothingElse) {
    show(scene_of(shape_mesh(Shape::Plane)));
    view_.camera = framed(renderer().bounds_world(), 1.0f, ViewDirection::ThreeQuarter);
    view_.anti_aliasing = AntiAliasing::None;
    const Image bare = picture(view_);
    view_.wires = true;
    const Image wired = picture(view_);
    const Image depth = channel(ChannelView::Depth);
    int changed = 0;
    int changed_beside = 0;
    for (int y = 0; y < kSize.height; ++y)
        for (int x = 0; x < kSize.width; ++x) {
            const auto at =
                static_cast<std::size_t>(y) * bare.row_bytes() + static_cast<std::size_t>(4 * x);
            if (std::memcmp(bare.data.data() + at, wired.data.data() + at, 4) == 0) continue;
            ++changed;
            if (pixel_of(depth, x, y).a == 0.0f) ++changed_beside;
        }
    EXPECT_GT(changed, 32) << "the plane's edges cross the picture";
    EXPECT_LT(changed, kSize.width * kSize.height / 2) << "and leave its middle alone";
    EXPECT_EQ(changed_beside, 0);
    View plain = view_;
    plain.wires = false;
    EXPECT_EQ(value_of(renderer().still_srgb(view_, kSize, 1)),
              value_of(renderer().still_srgb(plain, kSize, 1)))
        << "stills have none";
}

TEST_F(FrameTest, WiresAreTheSameOnBothViews) {
    view_.compare = CompareMode::TwoViews;
    view_.right = view_.left;
    view_.wires = true;
    const Image both = picture(view_);
    expect_same_columns(both, both, kSize.width / 2, kSize.width, kSize.width / 2);
}

TEST_F(FrameTest, BlendedSurfacesAreDrawnFromTheFarthest) {
    auto scene = std::make_shared<Scene>(*scene_of(shape_mesh(Shape::Sphere)));
    scene->meshes.push_back(scene->meshes[0]);
    scene->meshes[1].primitives[0].source_material = 1;
    // The nearer instance stands first in the file.
    scene->instances.insert(scene->instances.begin(),
                            {.mesh = 1, .world_from_local = glm::mat4(1.0f), .name = "near"});
    scene->instances[0].world_from_local[3] = glm::vec4(0.0f, 0.0f, 2.0f, 1.0f);
    show(scene);
    ASSERT_TRUE(renderer().set_environment(filtered_builtin("white")));
    const auto veil = [](const glm::vec3& color) {
        SurfaceMaterial surface = constant_surface(color, 0.0f, 1.0f);
        surface.alpha_mode = AlphaMode::Blend;
        surface.unlit = true;
        surface[Slot::BaseColor].multiply.a = 0.5f;
        return surface;
    };
    ASSERT_TRUE(renderer().set_material(0, veil({1.0f, 0.0f, 0.0f})));
    ASSERT_TRUE(renderer().set_material(1, veil({0.0f, 1.0f, 0.0f})));
    view_.background.kind = Background::Kind::Transparent;
    const glm::vec4 seen = pixel_of(value_of(renderer().still_linear(view_, kSize, 1)), 32, 32);
    EXPECT_NEAR(seen.g, 0.5f, 0.01f);
    EXPECT_NEAR(seen.r, 0.25f, 0.01f);
    EXPECT_NEAR(seen.a, 0.75f, 0.01f);
}

TEST_F(FrameTest, AStillOfOneSampleIsTheLivePicture) {
    const Image live = picture(view_);
    const Image still = value_of(renderer().still_srgb(view_, kSize, 1));
    int largest = 0;
    for (std::size_t i = 0; i < live.data.size(); ++i)
        largest = std::max(largest, std::abs(std::to_integer<int>(live.data[i]) -
                                             std::to_integer<int>(still.data[i])));
    EXPECT_LE(largest, 1);
}

TEST_F(FrameTest, SamplesSmoothEdgesAndLeaveFlatPlaces) {
    view_.background.kind = Background::Kind::Transparent;
    const Image still = value_of(renderer().still_srgb(view_, kSize, 16));
    int partly_covered = 0;
    for (std::size_t i = 3; i < still.data.size(); i += 4) {
        const int alpha = std::to_integer<int>(still.data[i]);
        partly_covered += alpha > 0 && alpha < 255 ? 1 : 0;
    }
    EXPECT_GT(partly_covered, 60) << "the rim of the sphere";
    EXPECT_LT(partly_covered, 500);
}

TEST_F(FrameTest, ExposureDoublesWithEachStopAndLeavesTheStudioBackdrop) {
    view_.tone_map = ToneMap::None;
    view_.anti_aliasing = AntiAliasing::None;
    const Image dark = picture(view_);
    view_.exposure_ev = 1.0f;
    const Image bright = picture(view_);
    expect_same_columns(dark, bright, 0, 3);
    EXPECT_NE(dark, bright);
}

TEST_F(FrameTest, TheStripHoldsTenThumbnailsOfWhichTheFirstIsThePicture) {
    const PictureSize thumbnail{48, 48};
    ASSERT_TRUE(renderer().draw_strip(view_, thumbnail));
    const Image strip = strip_of(renderer(), thumbnail);
    for (int i = 0; i < kStripChannelCount; ++i) {
        View single = view_;
        single.channel = kChannelViews[static_cast<std::size_t>(i)].view;
        const Image alone = picture(single, thumbnail);
        expect_same_columns(strip, alone, 48 * i, 48 * i + 48, 48 * i);
    }
}

TEST_F(FrameTest, CostsNameEachPassAndCountTheGBuffer) {
    view_.compare = CompareMode::Split;
    picture(view_);
    // Phong's light has a shadow, which is drawn once.
    ASSERT_EQ(renderer().stats().left.passes.size(), 4u);
    EXPECT_EQ(renderer().stats().left.passes[0].name, "Shadows");
    picture(view_);
    const FrameStats stats = renderer().stats();
    ASSERT_TRUE(stats.right);
    ASSERT_EQ(stats.left.passes.size(), 3u);
    EXPECT_EQ(stats.left.passes[0].name, "G-buffer");
    EXPECT_EQ(stats.left.passes[1].name, "Lighting");
    EXPECT_EQ(stats.left.passes[2].name, "Background");
    // RGBA8, three times RGBA16F and 32 bits of depth.
    EXPECT_EQ(stats.left.gbuffer_bytes, std::size_t{64} * 64 * (4 + 3 * 8 + 4));
    EXPECT_GT(stats.left.environment_bytes, 0u);
    EXPECT_EQ(stats.right->environment_bytes, 0u) << "Phong reads no maps";
}

}  // namespace
}  // namespace patina::render
