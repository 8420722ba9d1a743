// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/formulae/formulae.h"

namespace patina {
namespace {

float byte(int value) {
    return static_cast<float>(value) / 255.0f;
}

TEST(Mask, LevelsFollowTheirDefinition) {
    for (int value = 0; value <= 255; ++value) {
        const double stretched = std::clamp((byte(value) - 0.25) * 2, 0.0, 1.0);
        const double expected = 0.9 + (0.3 - 0.9) * std::pow(stretched, 1 / 1.8);
        EXPECT_NEAR(formulae::levels(byte(value), 0.25f, 0.75f, 1.8f, 0.9f, 0.3f), expected, 1e-6);
    }
}

TEST(Mask, DefaultLevelsChangeNothing) {
    for (int value = 0; value <= 255; ++value)
        EXPECT_EQ(formulae::levels(byte(value), 0.0f, 1.0f, 1.0f, 0.0f, 1.0f), byte(value));
}

TEST(Mask, AFinishedMaskIsHeldAndThenInverted) {
    EXPECT_EQ(formulae::finished_mask(1.5f, false), 1.0f);
    EXPECT_EQ(formulae::finished_mask(1.5f, true), 0.0f);
    EXPECT_EQ(formulae::finished_mask(0.25f, true), 0.75f);
}

TEST(Mask, LevelsWithoutWidthAreAThreshold) {
    EXPECT_EQ(formulae::levels(0.49f, 0.5f, 0.5f, 1.0f, 0.0f, 1.0f), 0.0f);
    EXPECT_EQ(formulae::levels(0.51f, 0.5f, 0.5f, 1.0f, 0.0f, 1.0f), 1.0f);
}

TEST(Mask, ContrastGoesFromFlatThroughNothingToAThreshold) {
    for (int value = 0; value <= 255; ++value) {
        const float x = byte(value);
        EXPECT_NEAR(formulae::contrasted(x, 0.0f, 0.3f), x, 1e-7f);
        EXPECT_EQ(formulae::contrasted(x, -1.0f, 0.3f), 0.3f);
        EXPECT_EQ(formulae::contrasted(x, 1.0f, 0.3f), x < 0.3f ? 0.0f : 1.0f);
        EXPECT_NEAR(formulae::contrasted(0.3f, 0.6f, 0.3f), 0.3f, 1e-7f);
    }
}

formulae::Ramp three_stops() {
    formulae::Ramp ramp = {};
    ramp.count = 3;
    ramp.stops[0] = {0.25f, 1.0f, 0.0f, 0.0f};
    ramp.stops[1] = {0.5f, 0.0f, 1.0f, 0.0f};
    ramp.stops[2] = {0.5f, 0.25f, 0.5f, 1.0f};
    return ramp;
}

TEST(Ramp, StopsAreMetAndBetweenThemLinesAreStraight) {
    const formulae::Ramp ramp = three_stops();
    EXPECT_EQ(formulae::ramp_scalar(ramp, 0.0f), 1.0f);
    EXPECT_EQ(formulae::ramp_scalar(ramp, 0.25f), 1.0f);
    EXPECT_FLOAT_EQ(formulae::ramp_scalar(ramp, 0.375f), 0.5f);
    EXPECT_FLOAT_EQ(formulae::ramp_color(ramp, 0.4375f).y, 0.75f);
    EXPECT_EQ(formulae::ramp_color(ramp, 1.0f).z, 1.0f);
}

TEST(Ramp, TwoStopsAtOnePlaceAreAStep) {
    const formulae::Ramp ramp = three_stops();
    EXPECT_NEAR(formulae::ramp_scalar(ramp, 0.4999f), 0.0f, 1e-3f);
    EXPECT_EQ(formulae::ramp_scalar(ramp, 0.5001f), 0.25f);
}

TEST(Ramp, OneStopIsAConstant) {
    formulae::Ramp ramp = {};
    ramp.count = 1;
    ramp.stops[0] = {0.5f, 0.25f, 0.5f, 0.75f};
    EXPECT_EQ(formulae::ramp_scalar(ramp, 0.0f), 0.25f);
    EXPECT_EQ(formulae::ramp_color(ramp, 1.0f).z, 0.75f);
}

}  // namespace
}  // namespace patina
