// SPDX-License-Identifier: MIT
// Layers that blend by height: what they cover, in which channels, and what has to be known of the
// heights below them. That their share is the published one, the random stacks of bake_test.cpp
// ask.
#include <gtest/gtest.h>

#include <algorithm>

#include "composite/small_stack.h"
#include "document/layer_edits.h"

namespace patina {
namespace {

/// Texels a side of the maps of the bumps.
constexpr int kBumpsSide = 64;

/// Bumps from -0.5 to 0.5, metal.
Layer bumps(std::uint32_t seed = 1) {
    Layer layer{.id = {1}};
    ProceduralSource noise{.seed = seed, .scale = 5.0f};
    noise.ramp = {{0.0f, glm::vec3(-0.5f)}, {1.0f, glm::vec3(0.5f)}};
    set(layer, Channel::Height, noise);
    set(layer, Channel::Metalness, constant(1.0f));
    set(layer, Channel::Roughness, constant(0.2f));
    return layer;
}

/// Level at 0, with an edge of no width; no metal.
Layer sand(float radius = 0.0f) {
    Layer layer{.id = {2}};
    set(layer, Channel::Height, constant(0.0f));
    set(layer, Channel::Metalness, constant(0.0f));
    set(layer, Channel::Roughness, constant(0.9f));
    layer.height_blend = {.enabled = true, .radius = radius};
    return layer;
}

TEST(HeightBlend, AllChannelsShowTheHigherLayerAndTheHeightIsTheGreater) {
    const Material material = stack_of({shared(bumps()), shared(sand())});
    const auto below = plane(stack_of({shared(bumps())}), Channel::Height, kBumpsSide);
    const auto height = plane(material, Channel::Height, kBumpsSide);
    const auto metalness = plane(material, Channel::Metalness, kBumpsSide);
    const auto roughness = plane(material, Channel::Roughness, kBumpsSide);
    int covered = 0;
    for (std::size_t i = 0; i < below.size(); ++i) {
        const bool sand_is_higher = below[i] < 0.0f;
        covered += sand_is_higher ? 1 : 0;
        ASSERT_EQ(metalness[i], sand_is_higher ? 0.0f : 1.0f);
        ASSERT_EQ(roughness[i], sand_is_higher ? 0.9f : 0.2f);
        ASSERT_EQ(height[i], std::max(below[i], 0.0f));
    }
    EXPECT_GT(covered, kBumpsSide * kBumpsSide / 5);
    EXPECT_LT(covered, kBumpsSide * kBumpsSide * 4 / 5);
}

TEST(HeightBlend, RaisingTheLayerCoversMoreAndAtLastEverything) {
    double before = -1.0;
    for (const float offset : {-1.0f, -0.2f, 0.0f, 0.2f, 1.0f}) {
        Layer raised = sand(0.1f);
        raised.height_blend.offset = offset;
        const auto metalness =
            plane(stack_of({shared(bumps()), shared(raised)}), Channel::Metalness, kBumpsSide);
        double covered = 0;
        for (const float value : metalness) covered += 1.0 - static_cast<double>(value);
        EXPECT_GT(covered, before);
        before = covered;
        if (offset == -1.0f) {
            EXPECT_EQ(covered, 0.0);
        }
        if (offset == 1.0f) {
            EXPECT_EQ(covered, kBumpsSide * kBumpsSide);
        }
    }
}

TEST(HeightBlend, TheMaskAndTheOpacityScaleTheShare) {
    Layer half = sand();
    half.opacity = 0.5f;
    half.mask.base = 0.5f;
    const auto metalness =
        plane(stack_of({shared(bumps()), shared(half)}), Channel::Metalness, kBumpsSide);
    const auto below = plane(stack_of({shared(bumps())}), Channel::Height, kBumpsSide);
    for (std::size_t i = 0; i < below.size(); ++i)
        ASSERT_EQ(metalness[i], below[i] < 0.0f ? 0.75f : 1.0f);
}

/// The heights below decide, though nobody sees them: a layer on top has other ones.
TEST(HeightBlend, HeightsThatAreCoveredFurtherUpStillDecide) {
    Layer flat{.id = {3}};
    set(flat, Channel::Height, constant(0.25f));
    at(flat.channels, Channel::Height).mode = BlendMode::Replace;
    const Material covered = stack_of({shared(bumps()), shared(sand()), shared(flat)});
    EXPECT_EQ(plane(covered, Channel::Metalness, kBumpsSide),
              plane(stack_of({shared(bumps()), shared(sand())}), Channel::Metalness, kBumpsSide));
}

/// In a group that lays on no heights, its layers still have some among themselves.
TEST(HeightBlend, InAGroupTheHeightsOfTheGroupDecideThoughItLaysOnNone) {
    Layer group = group_layer();
    group.id = {4};
    group.content = GroupContent{.children = {shared(bumps()), shared(sand())}};
    at(group.channels, Channel::Height).enabled = false;
    EXPECT_EQ(plane(stack_of({shared(group)}), Channel::Metalness, kBumpsSide),
              plane(stack_of({shared(bumps()), shared(sand())}), Channel::Metalness, kBumpsSide));
    // Nothing of it is left in the height channel.
    EXPECT_FALSE(varies(Program::compile(stack_of({shared(group)})), Channel::Height));
}

TEST(HeightBlend, AGroupIsAsHighAsItsLayersMakeIt) {
    Layer level = sand();
    level.height_blend = {};
    Layer group = group_layer();
    group.id = {4};
    group.content = GroupContent{.children = {shared(level)}};
    group.height_blend = sand().height_blend;
    EXPECT_EQ(plane(stack_of({shared(bumps()), shared(group)}), Channel::Metalness, kBumpsSide),
              plane(stack_of({shared(bumps()), shared(sand())}), Channel::Metalness, kBumpsSide));
}

TEST(HeightBlend, AnotherHeightBelowIsAnotherPictureOfEveryChannelOfTheLayer) {
    const auto hash = [](const Layer& below, Slot slot) {
        return Program::compile(stack_of({shared(below), shared(sand())})).slot_hash(slot);
    };
    EXPECT_NE(hash(bumps(1), Slot::MetallicRoughness), hash(bumps(2), Slot::MetallicRoughness));
    EXPECT_EQ(hash(bumps(1), Slot::Emissive), hash(bumps(2), Slot::Emissive));
    Layer group = group_layer();
    group.id = {4};
    at(group.channels, Channel::Height).enabled = false;
    const auto grouped = [&](std::uint32_t seed) {
        group.content = GroupContent{.children = {shared(bumps(seed)), shared(sand())}};
        return Program::compile(stack_of({shared(group)})).slot_hash(Slot::MetallicRoughness);
    };
    EXPECT_NE(grouped(1), grouped(2));
}

TEST(HeightBlend, SwitchedOffTheNumbersLeaveNoTrace) {
    Layer off = sand(0.3f);
    off.height_blend.enabled = false;
    Layer plain = off;
    plain.height_blend = {};
    EXPECT_EQ(Program::compile(stack_of({shared(bumps()), shared(off)})).slot_hash(Slot::Normal),
              Program::compile(stack_of({shared(bumps()), shared(plain)})).slot_hash(Slot::Normal));
}

TEST(HeightBlend, ExplainTellsTheShareAsPartOfTheMask) {
    ImageTable images;
    const auto steps = explain_texel(stack_of({shared(bumps()), shared(sand(0.5f))}), nullptr,
                                     images, Channel::Metalness, kBumpsSide, 3, 5);
    ASSERT_TRUE(steps.has_value());
    ASSERT_EQ(steps->size(), 2u);
    EXPECT_GT(steps->back().mask, 0.0f);
    EXPECT_LT(steps->back().mask, 1.0f);
    EXPECT_EQ(steps->back().weight, steps->back().mask);
    EXPECT_FLOAT_EQ(steps->back().result.x, 1.0f - steps->back().mask);
}

}  // namespace
}  // namespace patina
