// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <rapidcheck/gtest.h>
#include <algorithm>
#include <random>

#include "composite/bake_channels.h"
#include "composite/composite.h"
#include "composite/composite_rect.h"
#include "composite/random_stack.h"
#include "composite/reference.h"
#include "core/parallel.h"
#include "document/choices.h"
#include "document/layer_edits.h"

namespace patina {
namespace {

const std::vector<BakedMap> kAllMaps = {BakedMap::BaseColor, BakedMap::OcclusionRoughnessMetalness,
                                        BakedMap::Normal, BakedMap::Emissive};

MapSet baked(const Material& material, ImageTable& images, int size) {
    return bake_maps(Program::compile(material), images, size, kAllMaps).value();
}

Hash128 hash_of(const MapSet& maps) {
    Hasher hasher;
    for (const ImagePtr& map : maps.maps) hasher.add(content_hash(*map));
    return hasher.finish();
}

/// How far a map is from the reference, in steps of 1/255.
struct Deviation {
    double greatest = 0;
    int beyond_rounding = 0;  ///< values that are not the nearest byte
    int values = 0;
};

Deviation difference_from_reference(const Material& material, const ImageTable& images,
                                    BakedMap map, const Image& image) {
    Deviation difference;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const glm::dvec4 reference = reference_texel(material, images, map, image.width, x, y);
            for (int k = 0; k < 4; ++k) {
                const auto at = static_cast<std::size_t>((y * image.width + x) * 4 + k);
                const double expected = std::clamp(reference[k], 0.0, 1.0) * 255;
                const double error = std::abs(static_cast<double>(image.data[at]) - expected);
                difference.greatest = std::max(difference.greatest, error);
                difference.beyond_rounding += error > 0.55;
                ++difference.values;
            }
        }
    return difference;
}

RC_GTEST_PROP(Bake, EqualsTheReferenceToTheNearestByte, ()) {
    const std::uint32_t seed = *rc::gen::noShrink(rc::gen::inRange(0u, 1u << 30));
    const int size = 9;
    RandomStack random(seed, size, RandomSources::ConstantsAndImages);
    const Material material = random.material();
    const MapSet maps = baked(material, random.images, size);
    for (const BakedMap map : kAllMaps) {
        const Deviation difference =
            difference_from_reference(material, random.images, map, *maps[map]);
        RC_LOG() << kBakedMapIds[static_cast<std::size_t>(map)] << ": greatest difference "
                 << difference.greatest << ", beyond rounding " << difference.beyond_rounding
                 << " of " << difference.values << ", seed " << seed << std::endl;
        RC_ASSERT(difference.beyond_rounding == 0);
    }
}

/// Where an image of 0 keeps the layer away, the layer changes nothing, whatever it does elsewhere:
/// it once held the sum below to 1, by taking it to the other blend space.
TEST(Bake, ALayerOfNoWeightInATexelLeavesWhatASumMadeThere) {
    Image half_clear{.width = 2, .height = 1, .channels = 1};
    half_clear.data = {std::byte{0}, std::byte{255}};
    ImageTable images;
    const Hash128 mask_image = images.add(std::move(half_clear));
    const auto grey = [](std::uint64_t id, float value, BlendMode mode, BlendSpace space) {
        Layer layer{.id = {id}, .mode = mode, .blend_space = space};
        at(layer.channels, Channel::BaseColor) = {.enabled = true,
                                                  .source = ConstantSource{glm::vec3(value)}};
        return layer;
    };
    const Layer bottom = grey(1, 0.8f, BlendMode::Normal, BlendSpace::Linear);
    const Layer sum = grey(2, 0.8f, BlendMode::Add, BlendSpace::Linear);
    Layer between = grey(3, 0.5f, BlendMode::Normal, BlendSpace::SrgbEncoded);
    between.mask.entries = {
        {.id = {4},
         .source = ImageSource{
             .image = mask_image, .pick = ChannelPick::Red, .filter = Filter::Nearest}}};
    const Layer half = grey(5, 0.5f, BlendMode::Multiply, BlendSpace::Linear);
    const auto stack_of = [](std::initializer_list<Layer> layers) {
        Material material;
        for (const Layer& layer : layers)
            material.stack.push_back(std::make_shared<const Layer>(layer));
        return material;
    };
    const Image with =
        *baked(stack_of({bottom, sum, between, half}), images, 2)[BakedMap::BaseColor];
    const Image without = *baked(stack_of({bottom, sum, half}), images, 2)[BakedMap::BaseColor];
    EXPECT_EQ(with.data[0], without.data[0]);
    EXPECT_EQ(with.data[0], std::byte{188});  // 0.5 linear: the sum is 1, not 1.6
    EXPECT_NE(with.data[4], without.data[4]);
}

/// An image of even bytes, 2 to 252: a byte of one and one of the other never add up to 255, where
/// a mode has its step.
Image even_noise(std::uint32_t seed) {
    std::mt19937 random(seed);
    Image image{.width = 16, .height = 16, .channels = 4};
    image.data.resize(16 * 16 * 4);
    for (std::byte& byte : image.data) byte = static_cast<std::byte>(2 + 2 * (random() % 126));
    return image;
}

/// The mode laid over an image by half a mask, at the top of the stack and inside a group whose
/// lowest layer is half clear.
std::array<Material, 2> stacks_with(BlendMode mode, Channel channel, ImageTable& images) {
    const auto layer = [&](std::uint64_t id, std::uint32_t seed, bool clear) {
        ImageSource image{.image = images.add(even_noise(seed)), .alpha_is_coverage = clear};
        if (channel == Channel::Normal) {
            // Above the surface, as normals of a map are.
            image.multiply = glm::vec3(0.4f);
            image.add = glm::vec3(0.0f, 0.0f, 0.6f);
        }
        Layer fill{.id = {id}};
        at(fill.channels, channel) = {.enabled = true, .source = image, .mode = BlendMode::Normal};
        return fill;
    };
    const Layer below = layer(1, 1, false);
    const Layer half_clear = layer(2, 3, true);
    Layer above = layer(3, 2, true);
    at(above.channels, channel).mode = mode;
    at(above.channels, channel).opacity = 0.75f;
    const auto shared = [](Layer of) { return std::make_shared<const Layer>(std::move(of)); };
    Layer group{.id = {4}};
    at(group.channels, channel).enabled = true;
    at(group.channels, channel).mode = BlendMode::Normal;
    group.content = GroupContent{.children = {shared(half_clear), shared(above)}};
    std::array<Material, 2> materials;
    materials[0].stack = {shared(below), shared(above)};
    materials[1].stack = {shared(below), shared(group)};
    for (Material& material : materials) material.height_scale = 0.02f;
    return materials;
}

TEST(Bake, EveryModeIsThatOfTheReferenceInTheStackAndInAGroup) {
    for (const BlendModeInfo& row : kBlendModes)
        for (const auto& [channel, map] :
             {std::pair(Channel::BaseColor, BakedMap::BaseColor),
              std::pair(Channel::Roughness, BakedMap::OcclusionRoughnessMetalness),
              std::pair(Channel::Normal, BakedMap::Normal),
              std::pair(Channel::Height, BakedMap::Normal)}) {
            if (!applies_to(row.mode, channel)) continue;
            ImageTable images;
            for (const Material& material : stacks_with(row.mode, channel, images)) {
                const Image baked_map = *baked(material, images, 16)[map];
                const Deviation difference =
                    difference_from_reference(material, images, map, baked_map);
                EXPECT_EQ(difference.beyond_rounding, 0)
                    << row.id << " of " << info(channel).id << ", greatest " << difference.greatest
                    << (material.stack.back()->is_group() ? " in a group" : "");
            }
        }
}

bool is_banded(int x) {
    return (x >= 50 && x < 210) || x % 7 == 3;
}

/// The uppermost layer, in the group where there is one, with one change.
template <typename Change>
Material with_top_changed(Material material, const Change& change) {
    Layer top = *material.stack.back();
    if (auto* const group = std::get_if<GroupContent>(&top.content)) {
        Layer child = *group->children.back();
        change(child);
        group->children.back() = std::make_shared<const Layer>(std::move(child));
    } else {
        change(top);
    }
    material.stack.back() = std::make_shared<const Layer>(std::move(top));
    return material;
}

/// 0 in a wide band and in every seventh column beside it.
Image banded_mask(int size) {
    Image image{.width = size, .height = size, .channels = 1};
    image.data.resize(image.row_bytes() * static_cast<std::size_t>(size));
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            image.data[static_cast<std::size_t>(y * size + x)] =
                static_cast<std::byte>(is_banded(x) ? 0 : 40 + x / 2);
    return image;
}

/// The first row of a channel's first component.
std::vector<float> first_row(const Material& material, Channel channel, ImageTable& images,
                             int size) {
    const auto planes = bake_channels(Program::compile(material), images, size, {channel}).value();
    const PixelVector<float>& plane = planes.plane(channel);
    return {plane.begin(), plane.begin() + size};
}

/// Blocks that a mask leaves empty are not run, and texels beside them that it leaves empty are:
/// either way the layer changes no bit of theirs.
TEST(Bake, EveryModeKeepsTheBitsOfTexelsThatTheMaskLeavesOut) {
    const int size = 320;
    ImageTable images;
    const MaskEntry entry{
        .id = {9},
        .source = ImageSource{.image = images.add(banded_mask(size)), .pick = ChannelPick::Red}};
    const auto masked = [&](Layer& layer) { layer.mask.entries = {entry}; };
    const auto hidden = [](Layer& layer) { layer.visible = false; };
    for (const BlendModeInfo& row : kBlendModes)
        for (const Channel channel :
             {Channel::BaseColor, Channel::Roughness, Channel::Normal, Channel::Height}) {
            if (!applies_to(row.mode, channel)) continue;
            for (const Material& material : stacks_with(row.mode, channel, images)) {
                std::vector<float> with =
                    first_row(with_top_changed(material, masked), channel, images, size);
                const std::vector<float> without =
                    first_row(with_top_changed(material, hidden), channel, images, size);
                EXPECT_NE(with, without) << row.id << " of " << info(channel).id;
                for (int x = 0; x < size; ++x)
                    if (!is_banded(x))
                        with[static_cast<std::size_t>(x)] = without[static_cast<std::size_t>(x)];
                EXPECT_EQ(with, without)
                    << row.id << " of " << info(channel).id
                    << (material.stack.back()->is_group() ? " in a group" : "");
            }
        }
}

/// A group whose lowest layer covers all is as opaque as the stack: its layers blend as they do
/// there, to the last bit.
TEST(Bake, EveryModeInACoveredGroupGivesTheBitsThatItGivesInTheStack) {
    for (const BlendModeInfo& row : kBlendModes)
        for (const Channel channel :
             {Channel::BaseColor, Channel::Roughness, Channel::Normal, Channel::Height}) {
            // What replaces leaves clear parts in the group, and on the stack none.
            if (!applies_to(row.mode, channel) || row.mode == BlendMode::Replace) continue;
            ImageTable images;
            const auto [stack, with_group] = stacks_with(row.mode, channel, images);
            Layer group = *with_group.stack.back();
            group.content = GroupContent{.children = stack.stack};
            Material grouped = stack;
            grouped.stack = {std::make_shared<const Layer>(std::move(group))};
            EXPECT_EQ(first_row(grouped, channel, images, 16),
                      first_row(stack, channel, images, 16))
                << row.id << " of " << info(channel).id;
        }
}

/// Images of colour and of height below an adjustment of each kind that looks at its own texel (see
/// around_test.cpp for the others), half masked; in the stack and
/// in a group.
TEST(Bake, EveryAdjustmentIsThatOfTheReference) {
    for (std::size_t kind = 0; !looks_around(static_cast<AdjustmentKind>(kind)); ++kind)
        for (const BlendSpace space : {BlendSpace::Linear, BlendSpace::SrgbEncoded})
            for (const bool grouped : {false, true}) {
                ImageTable images;
                Layer below{.id = {1}};
                Layer adjusting{.id = {2}, .blend_space = space};
                AdjustmentSettings settings{.kind = static_cast<AdjustmentKind>(kind)};
                settings.levels = {0.1f, 0.8f, 1.5f, 0.2f, 0.9f};
                settings.curve = {{0.0f, 0.2f}, {0.3f, 0.1f}, {0.6f, 0.9f}, {1.0f, 0.7f}};
                settings.hue_degrees = -77.0f;
                settings.saturation = 0.4f;
                settings.lightness = -0.2f;
                settings.brightness = 0.15f;
                settings.contrast = 0.3f;
                settings.steps = 7;  // no byte is a seventh
                settings.gradient = {{0.2f, {0.1f, 0.2f, 0.6f}}, {0.7f, {1.0f, 0.8f, 0.1f}}};
                settings.low = 0.3f;
                settings.high = 0.6f;
                adjusting.content = AdjustmentContent{settings};
                adjusting.mask.entries = {
                    {.id = {3}, .source = ImageSource{.image = images.add(even_noise(9))}}};
                std::uint32_t seed = 1;
                for (const Channel channel :
                     {Channel::BaseColor, Channel::Roughness, Channel::Height}) {
                    at(below.channels, channel) = {
                        .enabled = true,
                        .source = ImageSource{.image = images.add(even_noise(seed++)),
                                              .alpha_is_coverage = grouped}};
                    at(adjusting.channels, channel).enabled = true;
                }
                Material material;
                material.height_scale = 0.01f;
                material.stack = {std::make_shared<const Layer>(below),
                                  std::make_shared<const Layer>(adjusting)};
                if (grouped) {
                    Layer group = group_layer();
                    group.id = {4};
                    group.content = GroupContent{.children = material.stack};
                    material.stack = {std::make_shared<const Layer>(group)};
                }
                const MapSet maps = baked(material, images, 16);
                for (const BakedMap map : kAllMaps)
                    EXPECT_EQ(difference_from_reference(material, images, map, *maps[map])
                                  .beyond_rounding,
                              0)
                        << kAdjustmentKinds[kind].id << ' '
                        << kBakedMapIds[static_cast<std::size_t>(map)]
                        << (space == BlendSpace::Linear ? " linear" : " encoded")
                        << (grouped ? " in a group" : "");
            }
}

TEST(Bake, AGroupThatPassesThroughWholeIsAsIfThereWereNone) {
    RandomStack random(5, 24, RandomSources::All);
    const Material plain = random.material();
    Layer group = group_layer();
    group.id = {1000};
    group.mode = BlendMode::PassThrough;
    group.content = GroupContent{.children = plain.stack};
    Material grouped = plain;
    grouped.stack = {std::make_shared<const Layer>(group)};
    EXPECT_EQ(hash_of(baked(grouped, random.images, 24)), hash_of(baked(plain, random.images, 24)));
}

TEST(Bake, AGroupIsNoMoreOpaqueThanWhatReplacesInAGroupThatPassesThrough) {
    ImageTable images;
    const auto [stack, unused] = stacks_with(BlendMode::Replace, Channel::BaseColor, images);
    Layer through{.id = {11}, .opacity = 0.75f, .mode = BlendMode::PassThrough};
    at(through.channels, Channel::BaseColor) = {.enabled = true, .mode = BlendMode::PassThrough};
    through.content = GroupContent{.children = {stack.stack.back()}};
    Layer group{.id = {12}};
    at(group.channels, Channel::BaseColor) = {.enabled = true, .mode = BlendMode::Normal};
    group.content = GroupContent{
        .children = {stack.stack.front(), std::make_shared<const Layer>(std::move(through))}};
    Material material;
    material.stack = {std::make_shared<const Layer>(std::move(group))};
    const Image color = *baked(material, images, 16)[BakedMap::BaseColor];
    EXPECT_EQ(
        difference_from_reference(material, images, BakedMap::BaseColor, color).beyond_rounding, 0);
}

TEST(Bake, AClippedLayerIsHiddenWithTheLayerBelowAndCoversNoMoreThanIt) {
    const auto red_over = [](float below_opacity, bool visible) {
        Layer base{.id = {1}, .visible = visible, .opacity = below_opacity};
        at(base.channels, Channel::Roughness) = {.enabled = true, .source = ProceduralSource{}};
        Layer clipped{.id = {2}, .clipped = true};
        at(clipped.channels, Channel::Metalness) = {.enabled = true,
                                                    .source = ConstantSource{glm::vec3(1.0f)}};
        Material material;
        material.stack = {std::make_shared<const Layer>(base),
                          std::make_shared<const Layer>(clipped)};
        ImageTable images;
        const MapSet maps = bake_maps(Program::compile(material), images, 8,
                                      {BakedMap::OcclusionRoughnessMetalness})
                                .value();
        return static_cast<int>(maps[BakedMap::OcclusionRoughnessMetalness]->data[2]);
    };
    EXPECT_EQ(red_over(1.0f, true), 255);
    EXPECT_EQ(red_over(0.4f, true), 102);
    EXPECT_EQ(red_over(1.0f, false), 0);
}

/// The metalness that a white layer gives that is clipped to `base`.
PixelVector<float> metalness_over(const Layer& base, ImageTable& images, int size) {
    Layer clipped{.id = {99}, .clipped = true};
    at(clipped.channels, Channel::Metalness) = {.enabled = true,
                                                .source = ConstantSource{glm::vec3(1.0f)}};
    Material material;
    material.stack = {std::make_shared<const Layer>(base), std::make_shared<const Layer>(clipped)};
    return bake_channels(Program::compile(material), images, size, {Channel::Metalness})
        ->plane(Channel::Metalness);
}

TEST(Bake, ALayerThatIsClippedToAGroupCoversNoMoreThanWhatTheGroupHolds) {
    ImageTable images;
    Layer child{.id = {2}, .opacity = 0.5f};
    at(child.channels, Channel::Roughness) = {.enabled = true, .source = ProceduralSource{}};
    Layer group = group_layer();
    group.opacity = 0.5f;
    group.content = GroupContent{.children = {std::make_shared<const Layer>(child)}};
    for (const float metalness : metalness_over(group, images, 4)) EXPECT_EQ(metalness, 0.25f);
    child.mask.entries.push_back({.source = ProceduralSource{}});
    group.opacity = 1.0f;
    group.content = GroupContent{.children = {std::make_shared<const Layer>(child)}};
    Material material;
    Layer white = child;
    at(white.channels, Channel::Roughness) = {.enabled = false};
    at(white.channels, Channel::Metalness) = {.enabled = true,
                                              .source = ConstantSource{glm::vec3(1.0f)}};
    material.stack = {std::make_shared<const Layer>(white)};
    EXPECT_EQ(metalness_over(group, images, 16),
              bake_channels(Program::compile(material), images, 16, {Channel::Metalness})
                  ->plane(Channel::Metalness));
    group.content = GroupContent{};
    for (const float metalness : metalness_over(group, images, 4)) EXPECT_EQ(metalness, 0.0f);
}

TEST(Bake, ALayerThatIsClippedToACutOutImageCoversWhatTheImageDoes) {
    ImageTable images;
    Image cut_out{.width = 2, .height = 1, .channels = 4};
    for (const int byte : {9, 9, 9, 255, 9, 9, 9, 0}) cut_out.data.push_back(std::byte(byte));
    const Hash128 hash = images.add(cut_out);
    Layer decal{.id = {1}};
    at(decal.channels, Channel::BaseColor) = {
        .enabled = true,
        .source = ImageSource{.image = hash, .alpha_is_coverage = true, .filter = Filter::Nearest}};
    at(decal.channels, Channel::Roughness) = {.enabled = true, .source = ConstantSource{}};
    EXPECT_THAT(metalness_over(decal, images, 2), testing::ElementsAre(1.0f, 0.0f, 1.0f, 0.0f));
    // A fill that lays on nothing is there for its mask.
    EXPECT_THAT(metalness_over(Layer{.id = {1}}, images, 1), testing::ElementsAre(1.0f));
}

TEST(Bake, TheStackThatOnceDifferedFromTheReferenceEqualsIt) {
    RandomStack random(646965079, 9, RandomSources::ConstantsAndImages);
    const Material material = random.material();
    const Image color = *baked(material, random.images, 9)[BakedMap::BaseColor];
    EXPECT_EQ(difference_from_reference(material, random.images, BakedMap::BaseColor, color)
                  .beyond_rounding,
              0);
}

TEST(Bake, GivesTheSameTexelsForAnyNumberOfThreads) {
    for (const int size : {1, 7, 255, 256, 1000}) {
        RandomStack random(static_cast<std::uint32_t>(size), size, RandomSources::All);
        const Material material = random.material();
        const Hash128 expected = hash_of(baked(material, random.images, size));
        for (const int threads : {1, 2, 16}) {
            const ThreadLimit limit(threads);
            EXPECT_EQ(hash_of(baked(material, random.images, size)), expected)
                << size << " texels, " << threads << " threads";
        }
    }
}

TEST(Bake, GivesTheSameTexelsForEveryInstructionSet) {
    const std::int64_t supported = hwy::SupportedTargets();
    for (const int size : {7, 100}) {
        for (std::uint32_t seed = 1; seed <= 8; ++seed) {
            RandomStack random(seed, size, RandomSources::All);
            const Material material = random.material();
            const Hash128 expected = hash_of(baked(material, random.images, size));
            for (std::int64_t left = supported; left != 0; left &= left - 1) {
                const std::int64_t target = left & -left;
                hwy::SetSupportedTargetsForTest(target);
                EXPECT_EQ(hash_of(baked(material, random.images, size)), expected)
                    << hwy::TargetName(target) << ", seed " << seed;
            }
            hwy::SetSupportedTargetsForTest(0);
        }
    }
}

/// One hash for all compilers and machines. It changes when a formula or the compositor's order of
/// work changes texels, and then with a reason.
TEST(Bake, GivesTheTexelsThatEveryMachineGives) {
    Hasher hasher;
    for (std::uint32_t seed = 1; seed <= 8; ++seed) {
        RandomStack random(seed, 33, RandomSources::All);
        hasher.add(hash_of(baked(random.material(), random.images, 33)));
    }
    EXPECT_EQ(to_hex(hasher.finish()), "1f9924bd652f3487f809c8b617aa415a");
}

TEST(Bake, TilesDoNotShowInARectangle) {
    RandomStack random(3, 1000, RandomSources::All);
    const Material material = random.material();
    const Program program = Program::compile(material);
    const MapSet whole = bake_maps(program, random.images, 1000, maps_of(program)).value();
    LiveComposite live;
    const Material before = random.edited(material);
    ASSERT_TRUE(live.update(Program::compile(before), random.images, 1000));
    for (const TexelRect& rect : {TexelRect{0, 0, 333, 1000}, TexelRect{333, 0, 1000, 17},
                                  TexelRect{333, 17, 1000, 1000}}) {
        // Each in a fresh composite, as one that has been brought up to date has nothing to do.
        LiveComposite part;
        ASSERT_TRUE(part.update(Program::compile(before), random.images, 1000));
        ASSERT_TRUE(part.update_within(rect, program, random.images, 1000));
        for (const BakedMap map : maps_of(program)) {
            if (part.maps()[map] == nullptr) continue;
            for (int y = rect.y0; y < rect.y1; ++y) {
                const auto row = static_cast<std::size_t>(y * 1000 + rect.x0) * 4;
                const auto bytes = static_cast<std::size_t>(rect.x1 - rect.x0) * 4;
                ASSERT_EQ(std::memcmp(part.maps()[map]->data.data() + row,
                                      whole[map]->data.data() + row, bytes),
                          0)
                    << kBakedMapIds[static_cast<std::size_t>(map)] << " row " << y;
            }
        }
    }
}

/// Rows of more than one tile, whose last is a short one: what no layer changes, what one covers
/// whole, and normals that heights bend.
TEST(Bake, ATexelIsTheSameInWhicheverTileItLies) {
    Layer bumps{.id = {1}}, wear{.id = {2}};
    at(bumps.channels, Channel::Height) = {.enabled = true, .source = ProceduralSource{}};
    at(bumps.channels, Channel::BaseColor) = {.enabled = true,
                                              .source = ConstantSource{glm::vec3(0.3f)}};
    at(wear.channels, Channel::Roughness) = {.enabled = true,
                                             .source = ConstantSource{glm::vec3(0.9f)}};
    wear.mask.entries = {{.id = {3}, .source = ProceduralSource{.seed = 2}}};
    Material material;
    material.height_scale = 0.01f;
    material.stack = {std::make_shared<const Layer>(bumps), std::make_shared<const Layer>(wear)};
    constexpr int kSide = kTileTexels + 77;
    const Program program = Program::compile(material);
    ImageTable images;
    const auto composited = [&](const TexelRect& rect) {
        const BoundImages bound =
            images_for_bake(program.data(), kAllChannels, kSide, images).value();
        MapSet maps{.size = kSide};
        CompositeJob job{.program = &program.data(), .images = &bound, .size = kSide, .rect = rect};
        for (const BakedMap map : kAllMaps) {
            auto image =
                std::make_shared<Image>(Image{.width = kSide, .height = kSide, .channels = 4});
            image->data.resize(image->row_bytes() * kSide);
            job.targets[static_cast<std::size_t>(map)] = image->data.data();
            maps.maps[static_cast<std::size_t>(map)] = image;
        }
        EXPECT_TRUE(composite_rect(job, {}));
        return maps;
    };
    const MapSet wide = composited({0, 40, kSide, 60});
    const MapSet narrow = composited({60, 40, kSide, 60});
    for (const BakedMap map : kAllMaps)
        for (int y = 40; y < 60; ++y) {
            const auto start = static_cast<std::size_t>(y * kSide + 60) * 4;
            ASSERT_EQ(std::memcmp(wide[map]->data.data() + start, narrow[map]->data.data() + start,
                                  std::size_t{kSide - 60} * 4),
                      0)
                << kBakedMapIds[static_cast<std::size_t>(map)] << " row " << y;
            const std::byte* const orm =
                wide[BakedMap::OcclusionRoughnessMetalness]->data.data() + start;
            for (int x = 60; x < kSide; ++x) ASSERT_EQ(orm[4 * (x - 60)], std::byte{255});
        }
}

TEST(Bake, NamesAnImageThatCannotBeDecoded) {
    Material material;
    Layer layer{.id = {1}};
    at(layer.channels, Channel::BaseColor) = {
        .enabled = true, .source = ImageSource{.image = {.high = 1, .low = 2}}};
    material.stack = {std::make_shared<const Layer>(layer)};
    ImageTable none;
    const auto maps = bake_maps(Program::compile(material), none, 16, kAllMaps);
    ASSERT_FALSE(maps.has_value());
    EXPECT_THAT(maps.error().message, testing::HasSubstr(to_hex({.high = 1, .low = 2})));
}

TEST(Bake, StopsWhenItIsCancelled) {
    RandomStack random(1, 64, RandomSources::All);
    const Progress progress;
    progress.cancel();
    const auto maps =
        bake_maps(Program::compile(random.material()), random.images, 64, kAllMaps, progress);
    ASSERT_FALSE(maps.has_value());
    EXPECT_EQ(maps.error().message, "baking was cancelled");
}

}  // namespace
}  // namespace patina
