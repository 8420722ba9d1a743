// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/formulae/formulae.h"
#include "document/choices.h"
#include "shaders/mean.h"

namespace patina {
namespace {

using formulae::Pattern;
using formulae::Real2;

constexpr int kPatternKinds = static_cast<int>(kProceduralKinds.size());

std::string name_of(int kind) {
    return std::string(choice(static_cast<ProceduralKind>(kind)).id);
}

/// Eight columns and as many rows as the kind needs to tile, seen by `side` texels.
Pattern pattern(int kind, int side) {
    Pattern made = {};
    made.kind = kind;
    made.columns = 8;
    made.rows = kind == formulae::PATTERN_HEXAGONS ? 10 : 8;
    made.seed = 5u;
    made.octaves = 3;
    made.width = 0.5f;
    made.softness = 0.1f;
    made.variation = 0.4f;
    made.footprint = static_cast<float>(made.rows) / static_cast<float>(side);
    return made;
}

std::vector<float> pattern_picture(const Pattern& made, int side) {
    std::vector<float> values;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            values.push_back(formulae::pattern_value(
                made, {(static_cast<float>(x) + 0.5f) / static_cast<float>(side) *
                           static_cast<float>(made.columns),
                       (static_cast<float>(y) + 0.5f) / static_cast<float>(side) *
                           static_cast<float>(made.rows)}));
    return values;
}

/// The greatest step between neighbours, the borders included.
double steepest(const std::vector<float>& values, int side) {
    double most = 0;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const auto at = [&](int i, int j) {
                return static_cast<double>(
                    values[static_cast<std::size_t>((j % side) * side + i % side)]);
            };
            most = std::max(
                {most, std::abs(at(x + 1, y) - at(x, y)), std::abs(at(x, y + 1) - at(x, y))});
        }
    return most;
}

TEST(Patterns, EveryKindStaysWithinZeroToOneAndIsNotFlat) {
    for (int kind = 0; kind < kPatternKinds; ++kind) {
        const std::vector<float> values = pattern_picture(pattern(kind, 128), 128);
        const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
        EXPECT_GE(*lowest, -1e-6f) << name_of(kind);
        EXPECT_LE(*highest, 1.0f + 1e-6f) << name_of(kind);
        EXPECT_GT(*highest - *lowest, 0.3f) << name_of(kind);
    }
}

TEST(Patterns, EveryKindTilesAlsoWhenItIsWarped) {
    for (int kind = 0; kind < kPatternKinds; ++kind)
        for (const float warp : {0.0f, 0.5f}) {
            Pattern made = pattern(kind, 128);
            made.warp = warp;
            const auto columns = static_cast<float>(made.columns);
            const auto rows = static_cast<float>(made.rows);
            for (int i = 0; i < 300; ++i) {
                const float x = static_cast<float>(i % 61) * 0.140625f;  // sums are exact
                const float y = static_cast<float>(i % 43) * 0.234375f;
                const float here = formulae::pattern_value(made, {x, y});
                ASSERT_NEAR(formulae::pattern_value(made, {x + columns, y}), here, 2e-4f)
                    << name_of(kind);
                ASSERT_NEAR(formulae::pattern_value(made, {x, y - 2 * rows}), here, 2e-4f)
                    << name_of(kind);
            }
        }
}

/// Where a picture is four times as large, each value is a mean of sixteen: what aliased would not
/// be.
TEST(Patterns, ASmallPictureIsALargeOneMadeSmaller) {
    for (int kind = 0; kind < kPatternKinds; ++kind) {
        const std::vector<float> small = pattern_picture(pattern(kind, 64), 64);
        const std::vector<float> large = pattern_picture(pattern(kind, 256), 256);
        double difference = 0;
        for (std::size_t y = 0; y < 64; ++y)
            for (std::size_t x = 0; x < 64; ++x) {
                double sum = 0;
                for (std::size_t j = 0; j < 4; ++j)
                    for (std::size_t i = 0; i < 4; ++i)
                        sum += static_cast<double>(large[(y * 4 + j) * 256 + x * 4 + i]);
                difference += std::abs(sum / 16 - static_cast<double>(small[y * 64 + x]));
            }
        EXPECT_LT(difference / (64 * 64), 0.08) << name_of(kind);
    }
}

TEST(Patterns, EdgesAreNoSharperThanATexelHoweverSharpTheyAreAskedFor) {
    for (const int kind : {formulae::PATTERN_CHECKER, formulae::PATTERN_STRIPES,
                           formulae::PATTERN_SPOTS, formulae::NOISE_CELLS}) {
        Pattern made = pattern(kind, 512);
        made.softness = 0.0f;
        made.octaves = 1;
        // At four texels to each one that is shown, an edge takes several.
        made.footprint *= 4;
        EXPECT_LT(steepest(pattern_picture(made, 512), 512), 0.6) << name_of(kind);
    }
}

TEST(Patterns, CellsTooSmallToBeShownAreAboutTheirMean) {
    for (int kind = 0; kind < kPatternKinds; ++kind) {
        Pattern made = pattern(kind, 256);
        const double expected = mean(pattern_picture(made, 256));
        made.footprint = 4.0f;
        const std::vector<float> values = pattern_picture(made, 32);
        EXPECT_LT(steepest(values, 32), 1e-6) << name_of(kind);
        EXPECT_NEAR(mean(values), expected, 0.09) << name_of(kind);
    }
}

TEST(Patterns, SeedsGiveDifferentPictures) {
    for (int kind = 0; kind < kPatternKinds; ++kind) {
        if (kind >= formulae::PATTERN_GRADIENT_LINEAR && kind <= formulae::PATTERN_CHECKER)
            continue;  // without anything random
        Pattern made = pattern(kind, 64);
        const std::vector<float> first = pattern_picture(made, 64);
        made.seed = 6u;
        EXPECT_NE(pattern_picture(made, 64), first) << name_of(kind);
    }
}

}  // namespace
}  // namespace patina
