// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/formulae/formulae.h"
#include "shaders/mean.h"

namespace patina {
namespace {

using formulae::Real2;

constexpr int kNoises[] = {
    formulae::NOISE_VALUE,     formulae::NOISE_PERLIN,       formulae::NOISE_WORLEY,
    formulae::NOISE_SIMPLEX,   formulae::NOISE_RIDGED,       formulae::NOISE_TURBULENCE,
    formulae::NOISE_WORLEY_F2, formulae::NOISE_WORLEY_EDGES, formulae::NOISE_CELLS};
/// How soft the borders of random cells are, in cells.
constexpr float kTexel = 0.05f;

/// How far the same place may be off a period further on. Rows of simplices are stretched to tile.
float tile_tolerance(int kind) {
    return kind == formulae::NOISE_SIMPLEX ? 2e-4f : 0.0f;
}

/// A noise over side x side points of `cells` cells a side.
std::vector<float> noise_picture(int kind, int cells, formulae::uint seed, int side) {
    std::vector<float> values;
    const float step = static_cast<float>(cells) / static_cast<float>(side);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            values.push_back(formulae::noise(
                kind,
                {(static_cast<float>(x) + 0.5f) * step, (static_cast<float>(y) + 0.5f) * step},
                cells, seed, kTexel));
    return values;
}

double correlation(const std::vector<float>& a, const std::vector<float>& b) {
    const double mean_a = mean(a), mean_b = mean(b);
    double ab = 0, aa = 0, bb = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        ab += (a[i] - mean_a) * (b[i] - mean_b);
        aa += (a[i] - mean_a) * (a[i] - mean_a);
        bb += (b[i] - mean_b) * (b[i] - mean_b);
    }
    return ab / std::sqrt(aa * bb);
}

double roughness_of(const std::vector<float>& values) {
    double sum = 0;
    for (std::size_t i = 1; i < values.size(); ++i) sum += std::abs(values[i] - values[i - 1]);
    return sum / static_cast<double>(values.size());
}

TEST(Noise, TheLatticeHashHasItsPinnedValues) {
    EXPECT_EQ(formulae::lattice_hash(0, 0, 0u), 0u);
    EXPECT_EQ(formulae::lattice_hash(1, 0, 0u), 1834104592u);
    EXPECT_EQ(formulae::lattice_hash(3, 7, 12345u), 811161694u);
    EXPECT_EQ(formulae::derived_seed(1u, 2), 340213447u);
}

TEST(Noise, PinnedPointsKeepTheirValues) {
    EXPECT_EQ(formulae::value_noise({1.25f, 2.5f}, 8, 1u), 0.646918535f);
    EXPECT_EQ(formulae::perlin_noise({1.25f, 2.5f}, 8, 1u), 0.436314464f);
    EXPECT_EQ(formulae::worley_noise({1.25f, 2.5f}, 8, 1u), 0.283658564f);
}

TEST(Noise, EveryKindFillsTheRangeAboutItsMeanAndStaysInside) {
    for (const int kind : kNoises) {
        const std::vector<float> values = noise_picture(kind, 64, 3u, 512);
        const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
        EXPECT_GE(*lowest, 0.0f) << kind;
        EXPECT_LE(*highest, 1.0f) << kind;
        EXPECT_LE(*lowest, 0.12f) << kind;
        EXPECT_GE(*highest, 0.88f) << kind;
        EXPECT_NEAR(mean(values), formulae::noise_mean(kind), 0.01) << kind;
    }
}

TEST(Noise, EveryKindTilesAfterItsPeriodAlsoBelowZero) {
    for (const int kind : kNoises)
        for (const int period : {1, 3, 7, 16})
            for (int i = 0; i < 200; ++i) {
                const float x = static_cast<float>(i) * 0.171875f;  // in 64ths: sums are exact
                const float y = static_cast<float>(i % 17) * 0.296875f;
                const float size = static_cast<float>(period);
                const float here = formulae::noise(kind, {x, y}, period, 9u, kTexel);
                ASSERT_NEAR(formulae::noise(kind, {x + size, y}, period, 9u, kTexel), here,
                            tile_tolerance(kind));
                ASSERT_NEAR(formulae::noise(kind, {x, y + 5 * size}, period, 9u, kTexel), here,
                            tile_tolerance(kind));
                ASSERT_NEAR(formulae::noise(kind, {x - 40 * size, y - size}, period, 9u, kTexel),
                            here, tile_tolerance(kind));
            }
}

TEST(Noise, SeedsGiveUnrelatedPictures) {
    for (const int kind : kNoises) {
        const std::vector<float> first = noise_picture(kind, 64, 1u, 256);
        // What is folded has a crease at every lattice point, whatever the seed.
        const bool folded = kind == formulae::NOISE_RIDGED || kind == formulae::NOISE_TURBULENCE;
        for (const formulae::uint seed : {0u, 2u, 3u, 65537u, 0x80000001u})
            EXPECT_LT(std::abs(correlation(first, noise_picture(kind, 64, seed, 256))),
                      folded ? 0.12 : 0.05)
                << kind << " " << seed;
    }
}

TEST(Noise, NeighbouringCellsAreUnrelated) {
    std::vector<float> here, right, below, diagonal;
    const auto at = [](int x, int y) {
        return formulae::unit_from_bits(formulae::lattice_hash(x, y, 7u));
    };
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 200; ++x) {
            here.push_back(at(x, y));
            right.push_back(at(x + 1, y));
            below.push_back(at(x, y + 1));
            diagonal.push_back(at(x + 1, y + 1));
        }
    EXPECT_LT(std::abs(correlation(here, right)), 0.02);
    EXPECT_LT(std::abs(correlation(here, below)), 0.02);
    EXPECT_LT(std::abs(correlation(here, diagonal)), 0.02);
}

TEST(Noise, EveryKindIsContinuousAcrossCells) {
    for (const int kind : kNoises)
        for (int cell = -3; cell <= 3; ++cell)
            for (int i = 0; i < 64; ++i) {
                const float y = static_cast<float>(i) * 0.13f;
                const float edge = static_cast<float>(cell);
                const float before = formulae::noise(kind, {edge - 1e-4f, y}, 8, 5u, kTexel);
                const float after = formulae::noise(kind, {edge + 1e-4f, y}, 8, 5u, kTexel);
                ASSERT_NEAR(before, after, 5e-3f) << kind;
            }
}

TEST(Noise, PerlinIsOneHalfAtLatticePointsAndWorleyZeroSomewhereInEachCell) {
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
            EXPECT_EQ(formulae::perlin_noise({static_cast<float>(x), static_cast<float>(y)}, 8, 3u),
                      0.5f);
}

TEST(Fbm, TilesAsItsFirstOctaveDoesAndStaysInside) {
    for (const int kind : kNoises)
        for (int i = 0; i < 400; ++i) {
            const float x = static_cast<float>(i) * 0.078125f;
            const float y = static_cast<float>(i % 13) * 0.234375f;
            const float here = formulae::fbm(kind, {x, y}, 5, 4u, 6, 0.5f, 0.0f);
            ASSERT_NEAR(formulae::fbm(kind, {x + 5.0f, y - 10.0f}, 5, 4u, 6, 0.5f, 0.0f), here,
                        tile_tolerance(kind));
            ASSERT_GE(here, 0.0f);
            ASSERT_LE(here, 1.0f);
        }
}

/// A row of fBm as a picture of `side` texels samples it.
std::vector<float> fbm_row(int kind, int cells, int side) {
    const float footprint = static_cast<float>(cells) / static_cast<float>(side);
    std::vector<float> values;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            values.push_back(formulae::fbm(kind,
                                           {(static_cast<float>(x) + 0.5f) * footprint,
                                            (static_cast<float>(y) + 0.5f) * footprint},
                                           cells, 11u, 8, 0.7f, footprint));
    return values;
}

TEST(Fbm, FadesOctavesThatATexelCannotShow) {
    EXPECT_EQ(formulae::octave_visibility(0.25f), 1.0f);
    EXPECT_EQ(formulae::octave_visibility(0.5f), 0.0f);
    for (const int kind : kNoises) {
        // All of an unresolvable noise is its mean; a small picture is a smooth version of a large
        // one, not a random pick of its texels.
        const float position = 3.3f;
        EXPECT_FLOAT_EQ(formulae::fbm(kind, {position, position}, 64, 1u, 4, 0.5f, 0.6f),
                        formulae::noise_mean(kind));
        const std::vector<float> small = fbm_row(kind, 8, 64);
        const std::vector<float> large = fbm_row(kind, 8, 256);
        std::vector<float> averaged;
        for (std::size_t y = 0; y < 64; ++y)
            for (std::size_t x = 0; x < 64; ++x) {
                float sum = 0;
                for (std::size_t dy = 0; dy < 4; ++dy)
                    for (std::size_t dx = 0; dx < 4; ++dx)
                        sum += large[(y * 4 + dy) * 256 + x * 4 + dx];
                averaged.push_back(sum / 16.0f);
            }
        EXPECT_GT(correlation(small, averaged), 0.9) << kind;
        EXPECT_LT(roughness_of(small), 1.2 * roughness_of(averaged)) << kind;
    }
}

}  // namespace
}  // namespace patina
