// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "core/formulae/formulae.h"

namespace patina {
namespace {

using formulae::Real3;

constexpr int kToneOperators[] = {formulae::TONE_MAP_NONE, formulae::TONE_MAP_REINHARD,
                                  formulae::TONE_MAP_ACES, formulae::TONE_MAP_AGX,
                                  formulae::TONE_MAP_PBR_NEUTRAL};

TEST(ToneMap, BlackStaysBlackAndNothingLeavesTheDisplay) {
    for (const int kind : kToneOperators) {
        const Real3 black = formulae::tone_map(kind, Real3(0.0f));
        EXPECT_EQ(black.x, 0.0f) << kind;
        for (const float level : {0.01f, 1.0f, 50.0f, 65504.0f})
            for (const Real3& hue :
                 {Real3(1.0f), Real3(1.0f, 0.0f, 0.0f), Real3(0.1f, 1.0f, 0.5f)}) {
                const Real3 shown = formulae::tone_map(kind, hue * level);
                for (const float channel : {shown.x, shown.y, shown.z}) {
                    ASSERT_GE(channel, 0.0f) << kind;
                    ASSERT_LE(channel, 1.0f) << kind;
                }
            }
    }
}

TEST(ToneMap, BrighterGreysAreShownNoDarker) {
    for (const int kind : kToneOperators) {
        float before = 0.0f;
        for (double stops = -14; stops < 12; stops += 0.01) {
            const auto level = static_cast<float>(std::exp2(stops));
            const Real3 shown = formulae::tone_map(kind, Real3(level));
            ASSERT_GE(shown.y, before - 2e-7f) << kind << " at " << level;
            before = shown.y;
        }
        EXPECT_GT(before, 0.95f) << kind;
    }
}

TEST(ToneMap, GreysStayGrey) {
    for (const int kind : kToneOperators)
        for (const float level : {0.05f, 0.18f, 0.8f, 4.0f}) {
            const Real3 shown = formulae::tone_map(kind, Real3(level));
            EXPECT_NEAR(shown.x, shown.y, 2e-3f) << kind;
            EXPECT_NEAR(shown.z, shown.y, 2e-3f) << kind;
        }
}

TEST(ToneMap, PbrNeutralReturnsBaseColoursUnderADielectricsReflection) {
    // A base colour lit so that the eye receives it plus the 0.04 that the surface mirrors.
    for (const Real3& base : {Real3(0.5f, 0.2f, 0.1f), Real3(0.7f), Real3(0.05f, 0.3f, 0.6f)}) {
        const Real3 shown = formulae::tone_map_pbr_neutral(base + Real3(0.04f));
        EXPECT_NEAR(shown.x, base.x, 1e-3f);
        EXPECT_NEAR(shown.y, base.y, 1e-3f);
        EXPECT_NEAR(shown.z, base.z, 1e-3f);
    }
}

TEST(ToneMap, CurvesHaveTheirPublishedValues) {
    EXPECT_FLOAT_EQ(formulae::tone_map_reinhard(Real3(1.0f)).x, 0.5f);
    EXPECT_NEAR(formulae::tone_map_aces(Real3(1.0f)).y, 0.6167f, 5e-3f);
    // AgX shows middle grey at half of the display's encoded range.
    EXPECT_NEAR(std::pow(formulae::tone_map_agx(Real3(0.18f)).y, 1 / 2.2), 0.497, 2e-3);
    EXPECT_EQ(formulae::tone_map_none(Real3(0.3f)).x, 0.3f);
}

}  // namespace
}  // namespace patina
