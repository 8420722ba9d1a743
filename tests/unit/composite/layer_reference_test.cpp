// SPDX-License-Identifier: MIT
// Sources that read another layer: as a copy of that layer in the place of what reads it would
// give.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "composite/composite.h"
#include "composite/random_stack.h"
#include "composite/small_stack.h"
#include "document/mask_edits.h"

namespace patina {
namespace {

/// Texels a side of the maps of the rust.
constexpr int kRustSide = 40;

MaskEntry entry_of(Source source, std::uint64_t id) {
    return {.id = {id}, .name = "entry", .source = std::move(source)};
}

/// Noisy metal of opacity 0.6 behind a mask of noise.
Layer rust(std::uint32_t seed = 5) {
    Layer layer{.id = {1}, .opacity = 0.6f};
    set(layer, Channel::Metalness, ProceduralSource{.seed = seed, .scale = 5.0f});
    layer.mask.entries = {entry_of(ProceduralSource{.seed = 8, .scale = 3.0f}, 11)};
    return layer;
}

Layer reading(LayerResult result, Channel into, LayerId of = {1}) {
    Layer layer{.id = {2}};
    set(layer, into, ReferenceSource{of, result});
    return layer;
}

Layer masked_by(LayerId of) {
    Layer layer{.id = {2}};
    set(layer, Channel::Roughness, ConstantSource{glm::vec3(1.0f)});
    layer.mask.entries = {entry_of(ReferenceSource{of, LayerResult::Mask}, 12)};
    return layer;
}

TEST(LayerReference, AMaskReadsWhereTheOtherLayerCovers) {
    Layer copy = masked_by({1});
    copy.mask = rust().mask;
    copy.opacity = 0.6f;
    const auto expected = plane(stack_of({shared(copy)}), Channel::Roughness, kRustSide);
    const auto found =
        plane(stack_of({shared(rust()), shared(masked_by({1}))}), Channel::Roughness, kRustSide);
    for (std::size_t i = 0; i < found.size(); ++i) ASSERT_NEAR(found[i], expected[i], 1e-6f);
    EXPECT_NE(*std::min_element(found.begin(), found.end()),
              *std::max_element(found.begin(), found.end()));
}

TEST(LayerReference, HiddenLayersAndThoseFurtherUpAreReadAsWell) {
    Layer hidden = rust();
    hidden.visible = false;
    const auto below =
        plane(stack_of({shared(hidden), shared(masked_by({1}))}), Channel::Roughness, kRustSide);
    const auto above =
        plane(stack_of({shared(masked_by({1})), shared(hidden)}), Channel::Roughness, kRustSide);
    Layer group{.id = {7}};
    group.content = GroupContent{.children = {shared(rust())}};
    for (ChannelSettings& settings : group.channels) settings.enabled = true;
    const auto inside =
        plane(stack_of({shared(masked_by({1})), shared(group)}), Channel::Roughness, kRustSide);
    EXPECT_EQ(below, plane(stack_of({shared(rust()), shared(masked_by({1}))}), Channel::Roughness,
                           kRustSide));
    EXPECT_EQ(above, below);
    EXPECT_EQ(inside, below);
}

TEST(LayerReference, OneToALayerThatIsNotThereReadsNothing) {
    const auto masked = plane(stack_of({shared(masked_by({77}))}), Channel::Roughness, kRustSide);
    EXPECT_TRUE(std::all_of(masked.begin(), masked.end(), [](float v) { return v == 0.5f; }));
    const auto laid =
        plane(stack_of({shared(reading(LayerResult::Metalness, Channel::Roughness, {77}))}),
              Channel::Roughness, kRustSide);
    EXPECT_TRUE(std::all_of(laid.begin(), laid.end(), [](float v) { return v == 0.5f; }));
}

TEST(LayerReference, WhatIsReadIsMadeWhatIsNeeded) {
    Layer hidden{.id = {1}, .visible = false};
    set(hidden, Channel::BaseColor, ConstantSource{{0.2f, 0.4f, 0.1f}});
    set(hidden, Channel::Metalness, ConstantSource{glm::vec3(0.25f)});
    set(hidden, Channel::Height, ConstantSource{glm::vec3(-0.5f)});
    const auto read = [&](LayerResult result, Channel into) {
        return plane(stack_of({shared(hidden), shared(reading(result, into))}), into, kRustSide)[7];
    };
    // Rec. 709 luminance, as of images.
    EXPECT_NEAR(read(LayerResult::BaseColor, Channel::Roughness),
                0.2126f * 0.2f + 0.7152f * 0.4f + 0.0722f * 0.1f, 1e-6f);
    EXPECT_EQ(read(LayerResult::Metalness, Channel::BaseColor), 0.25f);
    EXPECT_EQ(read(LayerResult::Height, Channel::Height), -0.5f);
    EXPECT_EQ(read(LayerResult::Height, Channel::Roughness), 0.0f);  // held to 0..1
    EXPECT_EQ(read(LayerResult::Mask, Channel::Emissive), 1.0f);
    EXPECT_EQ(read(LayerResult::Roughness, Channel::Roughness), 0.5f);  // that channel is off
}

/// The layer with nothing but one channel, laid on plainly.
Layer only(Layer layer, Channel channel, LayerId id) {
    layer.id = id;
    layer.visible = true;
    layer.clipped = false;
    if (layer.is_pass_through()) layer.mode = BlendMode::Normal;
    for (const ChannelInfo& row : kChannels) {
        ChannelSettings& settings = at(layer.channels, row.channel);
        if (row.channel == channel)
            settings.mode = BlendMode::Normal;
        else if (row.channel != Channel::Height || !layer.height_blend.enabled)
            settings.enabled = false;
    }
    return layer;
}

RC_GTEST_PROP(LayerReference, IsAsACopyOfTheLayerInItsPlace, ()) {
    RandomStack random(*rc::gen::noShrink(rc::gen::inRange(0u, 1u << 30)), kRustSide,
                       RandomSources::All);
    Material material = random.material();
    const auto at_layer = *rc::gen::inRange<std::size_t>(0, material.stack.size());
    const Layer& read = *material.stack[at_layer];
    const Channel channel = *rc::gen::elementOf(std::vector<Channel>{
        Channel::BaseColor, Channel::Metalness, Channel::Roughness, Channel::Emissive});
    // What a clipped layer covers depends on its place; an adjustment has nothing by itself.
    if (read.is_adjustment() || read.clipped) return;
    Layer reader{.id = {9001}, .blend_space = read.blend_space};
    set(reader, channel, ReferenceSource{read.id, result_of(channel)});
    Material copied = material;
    material.stack.push_back(shared(reader));
    copied.stack.push_back(shared(only(read, channel, {9002})));
    const auto planes = [&](const Material& of) {
        return bake_channels(Program::compile(of), random.images, kRustSide, {channel})
            ->plane(channel);
    };
    const auto found = planes(material);
    const auto expected = planes(copied);
    for (std::size_t i = 0; i < found.size(); ++i)
        RC_ASSERT(std::abs(found[i] - expected[i]) <= 2e-4f);
}

TEST(LayerReference, AnEditOfWhatIsReadIsAnotherPictureOfWhatReadsIt) {
    const auto hash = [](std::uint32_t seed, Slot slot) {
        Layer hidden = rust(seed);
        hidden.visible = false;
        return Program::compile(
                   stack_of({shared(reading(LayerResult::Metalness, Channel::Roughness)),
                             shared(hidden)}))
            .slot_hash(slot);
    };
    EXPECT_NE(hash(1, Slot::MetallicRoughness), hash(2, Slot::MetallicRoughness));
    EXPECT_EQ(hash(1, Slot::Emissive), hash(2, Slot::Emissive));
}

TEST(LayerReference, TheLiveCompositeFollowsWhatIsReadBelowAndAbove) {
    ImageTable images;
    LiveComposite live;
    for (const bool above : {false, true})
        for (const std::uint32_t seed : {1u, 2u, 3u, 2u}) {
            std::vector<LayerPtr> stack = {
                shared(rust(seed)), shared(reading(LayerResult::Metalness, Channel::Roughness))};
            if (above) std::swap(stack[0], stack[1]);
            const Program program = Program::compile(stack_of(stack));
            ASSERT_TRUE(live.update(program, images, kRustSide));
            const auto map = BakedMap::OcclusionRoughnessMetalness;
            const MapSet cold = bake_maps(program, images, kRustSide, {map}).value();
            ASSERT_EQ(*live.maps()[map], *cold[map]);
        }
}

TEST(LayerReference, ExplainListsTheLayersOfTheStackAlone) {
    ImageTable images;
    const Material material =
        stack_of({shared(rust()), shared(reading(LayerResult::Metalness, Channel::Metalness))});
    const auto steps =
        explain_texel(material, nullptr, images, Channel::Metalness, kRustSide, 3, 4);
    ASSERT_TRUE(steps.has_value());
    ASSERT_EQ(steps->size(), 2u);
    EXPECT_EQ((*steps)[0].layer, LayerId{1});
    EXPECT_EQ((*steps)[1].layer, LayerId{2});
    EXPECT_NEAR((*steps)[1].source.x, (*steps)[0].source.x, 1e-6f);
    EXPECT_NEAR((*steps)[1].weight, (*steps)[0].weight, 1e-6f);
}

TEST(LayerReference, ReadsReadersOfLayers) {
    Layer second = reading(LayerResult::Metalness, Channel::Roughness);
    second.visible = false;
    Layer third = reading(LayerResult::Roughness, Channel::Occlusion, {2});
    third.id = {3};
    at(third.channels, Channel::Occlusion).mode = BlendMode::Normal;
    Layer direct = reading(LayerResult::Metalness, Channel::Occlusion);
    at(direct.channels, Channel::Occlusion).mode = BlendMode::Normal;
    const auto through = plane(stack_of({shared(third), shared(second), shared(rust())}),
                               Channel::Occlusion, kRustSide);
    const auto straight =
        plane(stack_of({shared(direct), shared(rust())}), Channel::Occlusion, kRustSide);
    for (std::size_t i = 0; i < through.size(); ++i) ASSERT_NEAR(through[i], straight[i], 1e-6f);
}

}  // namespace
}  // namespace patina
