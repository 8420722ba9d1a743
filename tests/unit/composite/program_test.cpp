// SPDX-License-Identifier: MIT
#include "composite/program.h"

#include <gtest/gtest.h>

#include "composite/composite.h"
#include "composite/small_stack.h"

namespace patina {
namespace {

/// A fill layer whose `channel` is `source` and whose other channels are off.
LayerPtr fill(std::uint64_t id, Channel channel, Source source) {
    Layer layer{.id = {id}, .name = "fill"};
    set(layer, channel, std::move(source));
    return shared(std::move(layer));
}

template <typename Change>
LayerPtr changed(const LayerPtr& layer, const Change& change) {
    Layer copy = *layer;
    change(copy);
    return shared(std::move(copy));
}

Hash128 some_image(std::uint64_t low) {
    return {.high = 1, .low = low};
}

Source image(std::uint64_t low, ChannelPick pick, ColorSpace space = ColorSpace::Linear) {
    return ImageSource{.image = some_image(low), .color_space = space, .pick = pick};
}

const SlotPlan& plan(const Program& program, Slot slot) {
    return program.slots()[static_cast<std::size_t>(slot)];
}

TEST(BakeRules, AnEmptyStackIsFactorsAlone) {
    const Program program = Program::compile(stack_of({}));
    EXPECT_EQ(plan(program, Slot::BaseColor), SlotPlan(SlotConstant{{0.5f, 0.5f, 0.5f, 1.0f}}));
    EXPECT_EQ(plan(program, Slot::MetallicRoughness),
              SlotPlan(SlotConstant{{0.0f, 0.5f, 0.0f, 0.0f}}));
    EXPECT_TRUE(std::holds_alternative<SlotConstant>(plan(program, Slot::Normal)));
    EXPECT_TRUE(std::holds_alternative<SlotConstant>(plan(program, Slot::Occlusion)));
    EXPECT_TRUE(maps_of(program).empty());
}

TEST(BakeRules, ChannelsOfConstantsBecomeFactors) {
    const LayerPtr red = fill(1, Channel::BaseColor, constant(1.0f, 0.0f, 0.0f));
    const LayerPtr half_blue = changed(fill(2, Channel::BaseColor, constant(0.0f, 0.0f, 1.0f)),
                                       [](Layer& layer) { layer.opacity = 0.5f; });
    const Program program = Program::compile(stack_of({red, half_blue}));
    EXPECT_EQ(plan(program, Slot::BaseColor), SlotPlan(SlotConstant{{0.5f, 0.0f, 0.5f, 1.0f}}));
}

TEST(BakeRules, AnUntouchedImageKeepsItsTexture) {
    const Source color = image(1, ChannelPick::Rgb, ColorSpace::Srgb);
    const Program program = Program::compile(stack_of({fill(1, Channel::BaseColor, color)}));
    EXPECT_EQ(plan(program, Slot::BaseColor),
              SlotPlan(SlotImage{.source = std::get<ImageSource>(color)}));
}

TEST(BakeRules, AnImageThatIsBlendedIsBaked) {
    const LayerPtr below =
        fill(1, Channel::BaseColor, image(1, ChannelPick::Rgb, ColorSpace::Srgb));
    const LayerPtr above = changed(fill(2, Channel::BaseColor, constant(1, 1, 1)),
                                   [](Layer& layer) { layer.opacity = 0.1f; });
    const Program program = Program::compile(stack_of({below, above}));
    EXPECT_EQ(plan(program, Slot::BaseColor), SlotPlan(SlotBaked{BakedMap::BaseColor}));
    EXPECT_EQ(maps_of(program), std::vector<BakedMap>{BakedMap::BaseColor});
}

TEST(BakeRules, MetalnessAndRoughnessOfOneImageKeepIt) {
    const LayerPtr rough = fill(1, Channel::Roughness, image(1, ChannelPick::Green));
    const LayerPtr metal = fill(2, Channel::Metalness, image(1, ChannelPick::Blue));
    const Program program = Program::compile(stack_of({rough, metal}));
    EXPECT_TRUE(std::holds_alternative<SlotImage>(plan(program, Slot::MetallicRoughness)));
}

TEST(BakeRules, MetalnessAndRoughnessThatDisagreeAreBaked) {
    const LayerPtr rough = fill(1, Channel::Roughness, image(1, ChannelPick::Green));
    const LayerPtr other = fill(2, Channel::Metalness, image(2, ChannelPick::Blue));
    const Program program = Program::compile(stack_of({rough, other}));
    EXPECT_EQ(plan(program, Slot::MetallicRoughness),
              SlotPlan(SlotBaked{BakedMap::OcclusionRoughnessMetalness}));
    EXPECT_TRUE(std::holds_alternative<SlotConstant>(plan(program, Slot::Occlusion)));
}

TEST(BakeRules, OcclusionOfAnImageIsUntouchedThoughItsModeIsMultiply) {
    const Program program =
        Program::compile(stack_of({fill(1, Channel::Occlusion, image(1, ChannelPick::Red))}));
    EXPECT_TRUE(std::holds_alternative<SlotImage>(plan(program, Slot::Occlusion)));
}

TEST(BakeRules, HeightThatVariesIsBakedIntoTheNormalMap) {
    const Program program =
        Program::compile(stack_of({fill(1, Channel::Height, image(1, ChannelPick::Red))}));
    EXPECT_EQ(plan(program, Slot::Normal), SlotPlan(SlotBaked{BakedMap::Normal}));
}

TEST(Program, LayersThatCannotChangeThePictureLeaveNoTrace) {
    const LayerPtr shown = fill(1, Channel::BaseColor, image(1, ChannelPick::Rgb));
    const LayerPtr other = fill(2, Channel::BaseColor, image(2, ChannelPick::Rgb));
    const LayerPtr hidden = changed(other, [](Layer& layer) { layer.visible = false; });
    const LayerPtr faint = changed(other, [](Layer& layer) { layer.opacity = 0.0f; });
    const LayerPtr masked = changed(other, [](Layer& layer) { layer.mask.base = 0.0f; });
    const Program alone = Program::compile(stack_of({shown}));
    for (const LayerPtr& layer : {hidden, faint, masked}) {
        const Program program = Program::compile(stack_of({shown, layer}));
        EXPECT_EQ(program.slot_hash(Slot::BaseColor), alone.slot_hash(Slot::BaseColor));
        EXPECT_EQ(program.images(), alone.images());
    }
    EXPECT_NE(Program::compile(stack_of({shown, other})).slot_hash(Slot::BaseColor),
              alone.slot_hash(Slot::BaseColor));
}

TEST(Program, LayersUnderAnOpaqueOneLeaveNoTrace) {
    const LayerPtr below = fill(1, Channel::BaseColor, image(1, ChannelPick::Rgb));
    const LayerPtr above = fill(2, Channel::BaseColor, image(2, ChannelPick::Rgb));
    const Program covered = Program::compile(stack_of({below, above}));
    EXPECT_EQ(covered.slot_hash(Slot::BaseColor),
              Program::compile(stack_of({above})).slot_hash(Slot::BaseColor));
    EXPECT_EQ(covered.images(), std::vector<Hash128>{some_image(2)});
}

TEST(Program, AnEditOfOneChannelLeavesTheOtherSlotsAlone) {
    const LayerPtr color = fill(1, Channel::BaseColor, image(1, ChannelPick::Rgb));
    const LayerPtr rough = fill(2, Channel::Roughness, constant(0.2f, 0, 0));
    const LayerPtr rougher = fill(2, Channel::Roughness, constant(0.3f, 0, 0));
    const Program before = Program::compile(stack_of({color, rough}));
    const Program after = Program::compile(stack_of({color, rougher}));
    EXPECT_EQ(before.slot_hash(Slot::BaseColor), after.slot_hash(Slot::BaseColor));
    EXPECT_NE(before.slot_hash(Slot::MetallicRoughness), after.slot_hash(Slot::MetallicRoughness));
}

}  // namespace
}  // namespace patina
