// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <algorithm>

#include "composite/bake_channels.h"
#include "composite/composite.h"
#include "composite/random_stack.h"
#include "document/edits.h"

namespace patina {
namespace {

/// Whether the maps that `live` shows are those of a cold bake.
bool equals_cold_bake(const LiveComposite& live, const Program& program, ImageTable& images,
                      int size) {
    const std::vector<BakedMap> wanted = maps_of(program);
    const MapSet cold = bake_maps(program, images, size, wanted).value();
    return std::all_of(wanted.begin(), wanted.end(), [&](BakedMap map) {
        return live.maps()[map] != nullptr && *live.maps()[map] == *cold[map];
    });
}

RC_GTEST_PROP(LiveComposite, EqualsAColdBakeBitForBitOverRandomEdits, ()) {
    const std::uint32_t seed = *rc::gen::noShrink(rc::gen::inRange(0u, 1u << 30));
    const int size = 40;
    RandomStack random(seed, size, RandomSources::All);
    Material material = random.material();
    LiveComposite live;
    for (int edit = 0; edit < 12; ++edit) {
        const Program program = Program::compile(material);
        RC_ASSERT(live.update(program, random.images, size).has_value());
        RC_ASSERT(equals_cold_bake(live, program, random.images, size));
        material = random.edited(material);
    }
}

/// Two fills of noise, the upper one of `opacity`.
Material two_layers(float opacity) {
    Layer below{.id = {1}};
    at(below.channels, Channel::Roughness) = {.enabled = true, .source = ProceduralSource{}};
    Layer above{.id = {2}, .opacity = opacity};
    at(above.channels, Channel::Roughness) = {.enabled = true,
                                              .source = ProceduralSource{.seed = 1}};
    Material material;
    material.stack = {std::make_shared<const Layer>(below), std::make_shared<const Layer>(above)};
    return material;
}

TEST(LiveComposite, DoesNothingWhenNothingHasChanged) {
    ImageTable images;
    LiveComposite live;
    const Program program = Program::compile(two_layers(0.5f));
    EXPECT_EQ(live.update(program, images, 64)->changed_maps,
              std::vector<BakedMap>{BakedMap::OcclusionRoughnessMetalness});
    const ImagePtr before = live.maps()[BakedMap::OcclusionRoughnessMetalness];
    EXPECT_TRUE(live.update(program, images, 64)->changed_maps.empty());
    EXPECT_EQ(live.maps()[BakedMap::OcclusionRoughnessMetalness], before);
}

TEST(LiveComposite, NeverChangesAMapThatSomeoneHolds) {
    ImageTable images;
    LiveComposite live;
    ASSERT_TRUE(live.update(Program::compile(two_layers(0.5f)), images, 64));
    const ImagePtr held = live.maps()[BakedMap::OcclusionRoughnessMetalness];
    const Image copy = *held;
    ASSERT_TRUE(live.update(Program::compile(two_layers(0.9f)), images, 64));
    EXPECT_EQ(*held, copy);
    EXPECT_NE(*live.maps()[BakedMap::OcclusionRoughnessMetalness], copy);
}

TEST(LiveComposite, CachesWhatLiesBelowAnEditWithinItsBudget) {
    ImageTable images;
    LiveComposite live;
    LiveComposite without_budget(0);
    for (const float opacity : {0.5f, 0.6f, 0.7f}) {
        const Program program = Program::compile(two_layers(opacity));
        ASSERT_TRUE(live.update(program, images, 64));
        ASSERT_TRUE(without_budget.update(program, images, 64));
        EXPECT_TRUE(equals_cold_bake(without_budget, program, images, 64));
    }
    EXPECT_EQ(live.cache_bytes(), 64u * 64u * sizeof(float));
    EXPECT_EQ(without_budget.cache_bytes(), 0u);
}

TEST(LiveComposite, ShowsAPlaceholderUntilAnImageIsThere) {
    RandomStack random(1, 32, RandomSources::ConstantsAndImages);
    Image image{.width = 32, .height = 32, .channels = 3};
    image.data.assign(32 * 32 * 3, std::byte{200});
    const Hash128 hash = random.images.add(std::move(image));
    Layer layer{.id = {1}};
    at(layer.channels, Channel::BaseColor) = {
        .enabled = true, .source = ImageSource{.image = hash, .color_space = ColorSpace::Srgb}};
    Material material;
    material.stack = {std::make_shared<const Layer>(layer)};
    const Program program = Program::compile(material);

    auto held_back = random.images.images.extract(hash);
    LiveComposite live;
    ASSERT_TRUE(live.update(program, random.images, 32));
    EXPECT_NE(live.maps()[BakedMap::BaseColor]->data[0], std::byte{200});
    random.images.images.insert(std::move(held_back));
    const auto update = live.update(program, random.images, 32);
    ASSERT_TRUE(update.has_value());
    EXPECT_EQ(update->changed_maps, std::vector<BakedMap>{BakedMap::BaseColor});
    EXPECT_TRUE(equals_cold_bake(live, program, random.images, 32));
}

TEST(LiveComposite, HoldsNothingAfterAnUpdateThatWasCancelled) {
    ImageTable images;
    LiveComposite live;
    const Program program = Program::compile(two_layers(0.5f));
    const Progress progress;
    progress.cancel();
    EXPECT_FALSE(live.update(program, images, 64, progress).has_value());
    ASSERT_TRUE(live.update(program, images, 64).has_value());
    EXPECT_TRUE(equals_cold_bake(live, program, images, 64));
}

RC_GTEST_PROP(Explain, EndsWithTheValueThatIsBaked, ()) {
    const std::uint32_t seed = *rc::gen::noShrink(rc::gen::inRange(0u, 1u << 30));
    const int size = 20;
    RandomStack random(seed, size, RandomSources::All);
    const Material material = random.material();
    const MapSet maps = bake_maps(Program::compile(material), random.images, size,
                                  {BakedMap::OcclusionRoughnessMetalness})
                            .value();
    const int x = *rc::gen::inRange(0, size), y = *rc::gen::inRange(0, size);
    const auto steps =
        explain_texel(material, nullptr, random.images, Channel::Roughness, size, x, y);
    RC_ASSERT(steps.has_value());
    float expected = stack_bottom(Channel::Roughness).x;
    for (const ExplainStep& step : *steps)
        if (step.depth == 0) expected = step.result.x;
    const auto at = static_cast<std::size_t>((y * size + x) * 4 + 1);
    const auto byte = static_cast<int>(maps[BakedMap::OcclusionRoughnessMetalness]->data[at]);
    RC_ASSERT(byte == static_cast<int>(std::clamp(expected, 0.0f, 1.0f) * 255.0f + 0.5f));
}

RC_GTEST_PROP(Explain, OfANormalEndsWithWhatHeightsMakeOfItInTheBake, ()) {
    const std::uint32_t seed = *rc::gen::noShrink(rc::gen::inRange(0u, 1u << 30));
    const int size = 20;
    RandomStack random(seed, size, RandomSources::All);
    const Material material = random.material();
    const Program program = Program::compile(material);
    const auto planes = bake_channels(program, random.images, size, {Channel::Normal}).value();
    const int x = *rc::gen::inRange(0, size), y = *rc::gen::inRange(0, size);
    const auto steps = explain_texel(material, nullptr, random.images, Channel::Normal, size, x, y);
    RC_ASSERT(steps.has_value());
    glm::vec3 expected = stack_bottom(Channel::Normal);
    for (const ExplainStep& step : *steps)
        if (step.depth == 0) expected = step.result;
    for (std::size_t k = 0; k < 3; ++k)
        RC_ASSERT(expected[static_cast<int>(k)] ==
                  planes.planes[static_cast<std::size_t>(Channel::Normal)][k]
                               [static_cast<std::size_t>(y * size + x)]);
}

TEST(Explain, OfANormalThatIsMadeOfHeightsAloneHasTheStepFromThem) {
    ImageTable images;
    Material material;
    Layer bumps = value_layer();
    ProceduralSource noise;
    noise.ramp = {{0.0f, glm::vec3(0.0f)}, {1.0f, glm::vec3(1.0f)}};
    at(bumps.channels, Channel::Height) = {.enabled = true, .source = noise};
    at(bumps.channels, Channel::Normal).enabled = false;
    material.stack = {std::make_shared<const Layer>(bumps)};
    const auto steps = explain_texel(material, nullptr, images, Channel::Normal, 64, 3, 5);
    ASSERT_TRUE(steps.has_value());
    ASSERT_EQ(steps->size(), 1u);
    EXPECT_EQ(steps->front().layer, LayerId{});
    EXPECT_EQ(steps->front().source, steps->front().result);
    EXPECT_LT(steps->front().result.z, 1.0f);
}

TEST(Explain, SaysHowMuchOfTheChannelAGroupHasLaidDown) {
    ImageTable images;
    Material material;
    Layer child = value_layer();
    child.opacity = 0.25f;
    Layer group = group_layer();
    group.content = GroupContent{
        .children = {std::make_shared<const Layer>(child), std::make_shared<const Layer>(child)}};
    material.stack = {std::make_shared<const Layer>(group)};
    const auto steps = explain_texel(material, nullptr, images, Channel::Roughness, 64, 3, 5);
    ASSERT_TRUE(steps.has_value());
    ASSERT_EQ(steps->size(), 3u);
    EXPECT_EQ((*steps)[0].coverage, 0.25f);
    EXPECT_EQ((*steps)[1].coverage, 0.4375f);
    EXPECT_EQ((*steps)[2].coverage, 1.0f);
}

TEST(Explain, NamesEachLayerWithItsWeight) {
    ImageTable images;
    const auto steps =
        explain_texel(two_layers(0.25f), nullptr, images, Channel::Roughness, 64, 3, 5);
    ASSERT_TRUE(steps.has_value());
    ASSERT_EQ(steps->size(), 2u);
    EXPECT_EQ((*steps)[0].layer, LayerId{1});
    EXPECT_EQ((*steps)[1].layer, LayerId{2});
    EXPECT_EQ((*steps)[1].weight, 0.25f);
    EXPECT_NEAR((*steps)[1].result.x, (*steps)[0].result.x * 0.75f + (*steps)[1].source.x * 0.25f,
                1e-6);
    EXPECT_FALSE(
        explain_texel(two_layers(1), nullptr, images, Channel::Roughness, 64, 64, 0).has_value());
}

}  // namespace
}  // namespace patina
