// SPDX-License-Identifier: MIT

/// The picture that gets better while nothing moves.

#include <algorithm>
#include <cmath>

#include "core/formulae/formulae.h"
#include "render/render_test.h"

namespace patina::render {
namespace {

class RefinementTest : public RenderTest {
  protected:
    void SetUp() override {
        RenderTest::SetUp();
        ASSERT_TRUE(renderer().set_environment(filtered_builtin("studio")));
        ASSERT_TRUE(renderer().set_material(0, constant_surface({0.8f, 0.4f, 0.2f}, 1.0f, 0.35f)));
        view_.background = {.kind = Background::Kind::Color};
    }
    Image picture(const View& view) {
        if (const Result<FrameStats> drawn = renderer().draw(view, kSize); !drawn)
            ADD_FAILURE() << drawn.error().message;
        return value_of(renderer().read_picture());
    }
    Refinement refined(const View& view, int draws) {
        Refinement refinement{.view = view, .size = kSize, .draws = draws};
        while (!refinement.is_finished())
            if (const Status drawn = renderer().refine(refinement); !drawn) {
                ADD_FAILURE() << drawn.error().message;
                break;
            }
        return refinement;
    }
    Image refined_picture(const View& view, int draws) {
        refined(view, draws);
        return value_of(renderer().read_picture());
    }
};

double mean_square(const Image& a, const Image& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.data.size(); ++i) {
        const double difference = std::to_integer<int>(a.data[i]) - std::to_integer<int>(b.data[i]);
        sum += difference * difference;
    }
    return sum / static_cast<double>(a.data.size());
}

TEST_F(RefinementTest, ItsPictureIsTheMeanOfItsDrawsInRadiance) {
    constexpr int kDraws = 12;  // all read the environment filtered, as those of a still do
    const Image shown = refined_picture(view_, kDraws);
    View bare = view_;
    bare.background.kind = Background::Kind::Transparent;
    const Image mean = value_of(renderer().still_linear(bare, kSize, kDraws));
    const auto behind = formulae::linear_from_srgb({0.1f, 0.1f, 0.1f});
    for (int y = 0; y < kSize.height; ++y)
        for (int x = 0; x < kSize.width; ++x) {
            const glm::vec4 light = pixel_of(mean, x, y);
            for (int c = 0; c < 3; ++c) {
                const float surface =
                    light.a > 0.0f ? std::clamp(light[c] / light.a, 0.0f, 1.0f) * light.a : 0.0f;
                const float expected =
                    255.0f * formulae::srgb_from_linear(surface + (1.0f - light.a) * behind.x);
                const auto at = static_cast<std::size_t>(y) * shown.row_bytes() +
                                static_cast<std::size_t>(4 * x + c);
                ASSERT_NEAR(std::to_integer<int>(shown.data[at]), expected, 1.6f)  // dithered
                    << x << ", " << y;
            }
        }
}

TEST_F(RefinementTest, ItComesNearerToTheIntegralThanTheFirstPictureAndWithEveryFourfoldOfDraws) {
    const Image truth = value_of(renderer().still_srgb(view_, kSize, 2048));
    double before = mean_square(picture(view_), truth);
    for (const int draws : {16, 64, 256}) {
        const double now = mean_square(refined_picture(view_, draws), truth);
        EXPECT_LT(now, before) << draws << " draws";
        before = now;
    }
    EXPECT_LT(before, 1.0);  // of 255 steps
}

TEST_F(RefinementTest, TheSameDrawsAreTheSameBytesWhateverIsDrawnBetweenThem) {
    const Image expected = refined_picture(view_, 24);
    Still still{.view = view_, .size = {40, 30}, .samples = 24};
    Refinement refinement{.view = view_, .size = kSize, .draws = 24};
    while (!refinement.is_finished()) {
        ASSERT_TRUE(renderer().refine(refinement));
        ASSERT_TRUE(renderer().draw_strip(view_, {32, 18}));
        ASSERT_TRUE(renderer().draw_sample(still));
        if (refinement.drawn == 9) picture(view_);
        if (refinement.drawn == 10) {
            ASSERT_TRUE(renderer().probe({32, 32}));
        }
    }
    EXPECT_EQ(value_of(renderer().read_picture()), expected);
}

TEST_F(RefinementTest, ADrawShowsTheFirstPictureAgain) {
    const Image first = picture(view_);
    EXPECT_NE(refined_picture(view_, 24), first);
    EXPECT_EQ(picture(view_), first);
}

TEST_F(RefinementTest, EachHalfOfASplitIsThePictureOfItsKind) {
    View split = view_;
    split.compare = CompareMode::Split;
    const Image both = refined_picture(split, 32);
    const Image pbr = refined_picture(view_, 32);
    View single = view_;
    single.left = view_.right;
    const Image phong = refined_picture(single, 32);
    for (int x = 0; x < kSize.width; ++x)
        for (int y = 0; y < kSize.height; ++y) {
            const auto at =
                static_cast<std::size_t>(y) * both.row_bytes() + static_cast<std::size_t>(4 * x);
            const Image& side = x < kSize.width / 2 ? pbr : phong;
            ASSERT_EQ(0, std::memcmp(&both.data[at], &side.data[at], 4)) << x << ", " << y;
        }
}

TEST_F(RefinementTest, CostsStayThoseOfThePictureThatWasDrawn) {
    picture(view_);
    const FrameStats before = renderer().stats();
    refined(view_, 24);
    const FrameStats after = renderer().stats();
    ASSERT_EQ(after.left.passes.size(), before.left.passes.size());
    for (std::size_t i = 0; i < before.left.passes.size(); ++i)
        EXPECT_EQ(after.left.passes[i].name, before.left.passes[i].name);
}

TEST_F(RefinementTest, ExactNumbersAreNotRefinedAndEdgesAloneNeedFewDraws) {
    EXPECT_EQ(refining_draws(view_, 256), 256);
    View other = view_;
    other.channel = ChannelView::NormalWorld;
    EXPECT_EQ(refining_draws(other, 256), 0);
    other = view_;
    other.compare = CompareMode::Difference;
    EXPECT_EQ(refining_draws(other, 256), 0);
    other = view_;
    other.left.model = ShadingModel::Phong;
    EXPECT_EQ(refining_draws(other, 256), 64);
    other.compare = CompareMode::Split;
    other.right.model = ShadingModel::Pbr;
    EXPECT_EQ(refining_draws(other, 256), 256);
}

TEST_F(RefinementTest, BlendedSurfacesAreRefinedToo) {
    SurfaceMaterial glass = constant_surface({0.8f, 0.4f, 0.2f}, 0.0f, 0.2f);
    glass.alpha_mode = AlphaMode::Blend;
    glass[Slot::BaseColor].multiply.a = 0.5f;
    ASSERT_TRUE(renderer().set_material(0, glass));
    const Image truth = value_of(renderer().still_srgb(view_, kSize, 512));
    EXPECT_LT(mean_square(refined_picture(view_, 128), truth), 1.0);
}

}  // namespace
}  // namespace patina::render
