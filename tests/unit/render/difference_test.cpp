// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "render/difference_stats.h"
#include "render/render_test.h"

namespace patina::render {
namespace {

TEST(DifferenceStats, OfNothingAreZero) {
    const DifferenceStats stats = difference_stats({}, 1.0f, 4);
    EXPECT_EQ(stats.pixels, 0);
    EXPECT_EQ(stats.largest, 0.0f);
    EXPECT_EQ(stats.shares, std::vector<float>(4, 0.0f));
}

TEST(DifferenceStats, CountEveryPixelOnceAndWhatIsBeyondTheRangeInTheLastBin) {
    std::vector<float> differences(100);
    for (int i = 0; i < 100; ++i)
        differences[static_cast<std::size_t>(99 - i)] = 0.01f * static_cast<float>(i);
    differences[0] = 7.0f;
    const DifferenceStats stats = difference_stats(differences, 0.5f, 2);
    EXPECT_EQ(stats.pixels, 100);
    EXPECT_NEAR(stats.mean, 0.5551f, 1e-4f);
    EXPECT_NEAR(stats.below_95, 0.94f, 1e-6f);
    EXPECT_EQ(stats.largest, 7.0f);
    EXPECT_NEAR(stats.shares[0], 0.25f, 1e-5f);
    EXPECT_NEAR(stats.shares[1], 0.75f, 1e-5f);
}

TEST_F(RenderTest, EqualShadingsDifferNowhereAndOthersAsTheirPicturesSay) {
    view_.right = view_.left;
    const std::vector<float> none = value_of(renderer().differences(view_, {64, 64}));
    ASSERT_FALSE(none.empty());
    EXPECT_EQ(*std::max_element(none.begin(), none.end()), 0.0f);

    view_.right.model = ShadingModel::Phong;
    view_.compare = CompareMode::Difference;
    const std::vector<float> some = value_of(renderer().differences(view_, {64, 64}));
    EXPECT_EQ(some.size(), none.size());
    // The picture of the difference holds the same numbers, also where it is half covered.
    const Image picture = value_of(renderer().still_linear(view_, {64, 64}, 1));
    float largest = 0.0f;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) largest = std::max(largest, pixel_of(picture, x, y).x);
    EXPECT_GT(largest, 0.0f);
    EXPECT_NEAR(*std::max_element(some.begin(), some.end()), largest, 0.002f * largest);
}

TEST_F(RenderTest, ADifferenceOfManySamplesIsThatOfWhatBothSidesConvergeTo) {
    constexpr int kSamples = 64;
    ASSERT_TRUE(renderer().set_environment(filtered_builtin("studio")));
    ASSERT_TRUE(renderer().set_material(-1, constant_surface({0.9f, 0.6f, 0.3f}, 1.0f, 0.4f)));
    view_.right.terms.distribution = DistributionTerm::Beckmann;
    view_.right.model = ShadingModel::Pbr;
    const auto alone = [&](const Shading& shading) {
        View view = view_;
        view.left = shading;
        return value_of(renderer().still_linear(view, kSize, kSamples));
    };
    const Image left = alone(view_.left);
    const Image right = alone(view_.right);
    view_.compare = CompareMode::Difference;
    const Image difference = value_of(renderer().still_linear(view_, kSize, kSamples));
    const auto luminance_at = [](const Image& image, int x, int y) {
        return glm::dot(glm::vec3(pixel_of(image, x, y)), glm::vec3(0.2126f, 0.7152f, 0.0722f));
    };
    float largest = 0.0f;
    for (int y = 0; y < kSize.height; ++y)
        for (int x = 0; x < kSize.width; ++x) {
            const float wanted = std::abs(luminance_at(left, x, y) - luminance_at(right, x, y));
            largest = std::max(largest, wanted);
            EXPECT_NEAR(pixel_of(difference, x, y).x, wanted, 1e-4f + 0.001f * wanted);
        }
    EXPECT_GT(largest, 0.01f);
}

TEST_F(RenderTest, BothSidesOfAPixelAreWhatEachSideShowsAlone) {
    view_.compare = CompareMode::TwoViews;
    view_.difference_beside = true;
    ASSERT_TRUE(renderer().draw(view_, {150, 50}));
    const auto at = [&](int column) {
        return *value_of(renderer().probe_sides({50 * column + 25, 25}));
    };
    // The same point of the model in each of the three views.
    for (int column = 1; column < 3; ++column) {
        EXPECT_EQ(at(column).left, at(0).left);
        EXPECT_EQ(at(column).right, at(0).right);
    }
    EXPECT_NE(at(0).left, at(0).right);
    EXPECT_FALSE(value_of(renderer().probe_sides({1, 1})));
    const auto probed = value_of(renderer().probe({25, 25}));
    ASSERT_TRUE(probed);
    EXPECT_EQ((*probed)[ChannelView::Final], at(0).left);
}

TEST_F(RenderTest, TheDifferenceBesideIsTheDifferenceAlone) {
    view_.compare = CompareMode::TwoViews;
    view_.difference_beside = true;
    ASSERT_TRUE(renderer().draw(view_, {96, 32}));
    const Image all = value_of(renderer().read_picture());
    view_.compare = CompareMode::Difference;
    ASSERT_TRUE(renderer().draw(view_, {32, 32}));
    const Image alone = value_of(renderer().read_picture());
    for (std::size_t y = 0; y < 32; ++y)
        EXPECT_EQ(std::memcmp(all.data.data() + y * all.row_bytes() + std::size_t{64} * 4,
                              alone.data.data() + y * alone.row_bytes(), alone.row_bytes()),
                  0)
            << y;
}

}  // namespace
}  // namespace patina::render
