// SPDX-License-Identifier: MIT
// Entries of masks that adjust what lies before them: against the same adjustment of a channel,
// which bake_test.cpp and around_test.cpp hold to definitions of their own.
#include <gtest/gtest.h>

#include <algorithm>

#include "composite/small_stack.h"
#include "document/choices.h"
#include "document/mask_edits.h"
#include "shaders/published_modes.h"

namespace patina {
namespace {

constexpr int kMaskSide = 70;  // no multiple of any number of lanes

Source noise() {
    return ProceduralSource{.kind = ProceduralKind::Grunge, .seed = 3, .scale = 6.0f};
}

AdjustmentSettings settings_of(AdjustmentKind kind) {
    AdjustmentSettings settings{.kind = kind};
    settings.levels = {0.1f, 0.8f, 1.5f, 0.2f, 0.9f};
    settings.curve = {{0.0f, 0.2f}, {0.3f, 0.1f}, {0.6f, 0.9f}, {1.0f, 0.7f}};
    settings.brightness = 0.15f;
    settings.contrast = 0.3f;
    settings.steps = 7;
    settings.low = 0.3f;
    settings.high = 0.6f;
    settings.radius_permille = 40.0f;
    settings.amount = 1.5f;
    settings.distance_permille = 50.0f;
    return settings;
}

std::vector<AdjustmentKind> kinds_of_masks() {
    std::vector<AdjustmentKind> kinds;
    for (std::size_t i = 0; i < kAdjustmentKinds.size(); ++i)
        if (adjusts_masks(static_cast<AdjustmentKind>(i)))
            kinds.push_back(static_cast<AdjustmentKind>(i));
    return kinds;
}

MaskEntry adjusting_entry(AdjustmentKind kind, std::uint64_t id = 12) {
    MaskEntry entry = adjustment_mask_entry(kind);
    entry.id = {id};
    entry.adjustment = settings_of(kind);
    return entry;
}

/// Roughness 0, and 1 where a mask of those entries covers: the roughness is the mask.
Material seen(std::vector<MaskEntry> entries) {
    Layer below{.id = {1}}, above{.id = {2}};
    set(below, Channel::Roughness, ConstantSource{glm::vec3(0.0f)});
    set(above, Channel::Roughness, ConstantSource{glm::vec3(1.0f)});
    above.mask.entries = std::move(entries);
    return stack_of({shared(below), shared(above)});
}

PixelVector<float> seen_plane(std::vector<MaskEntry> entries) {
    return plane(seen(std::move(entries)), Channel::Roughness, kMaskSide);
}

MaskEntry noise_entry() {
    return {.id = {11}, .source = noise()};
}

/// What a layer of adjustment makes of a roughness of that source.
PixelVector<float> of_channel(const Source& source, AdjustmentKind kind) {
    Layer fill{.id = {1}};
    set(fill, Channel::Roughness, source);
    Layer layer{.id = {2}, .content = AdjustmentContent{settings_of(kind)}};
    at(layer.channels, Channel::Roughness).enabled = true;
    return plane(stack_of({shared(fill), shared(layer)}), Channel::Roughness, kMaskSide);
}

void expect_near(const PixelVector<float>& found, const PixelVector<float>& expected,
                 std::string_view what) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i)
        ASSERT_NEAR(found[i], expected[i], 1e-6f) << what << " at " << i;
}

TEST(MaskAdjustment, MakesOfAMaskWhatItMakesOfAChannel) {
    for (const AdjustmentKind kind : kinds_of_masks()) {
        const auto found = seen_plane({noise_entry(), adjusting_entry(kind)});
        expect_near(found, of_channel(noise(), kind), choice(kind).id);
        EXPECT_NE(found, seen_plane({noise_entry()})) << choice(kind).id;
    }
}

TEST(MaskAdjustment, OfOneValueIsThatOfAChannelOfOneValue) {
    const Source grey = ConstantSource{glm::vec3(0.4f)};
    for (const AdjustmentKind kind : kinds_of_masks())
        expect_near(seen_plane({{.id = {11}, .source = grey}, adjusting_entry(kind)}),
                    of_channel(grey, kind), choice(kind).id);
}

TEST(MaskAdjustment, ItsOpacityMixesWithTheMaskBeforeIt) {
    for (const AdjustmentKind kind : {AdjustmentKind::Curves, AdjustmentKind::Blur}) {
        MaskEntry half = adjusting_entry(kind);
        half.opacity = 0.25f;
        const auto before = seen_plane({noise_entry()});
        const auto whole = seen_plane({noise_entry(), adjusting_entry(kind)});
        const auto found = seen_plane({noise_entry(), half});
        for (std::size_t i = 0; i < found.size(); ++i)
            ASSERT_NEAR(found[i], 0.75f * before[i] + 0.25f * whole[i], 1e-6f);
    }
}

TEST(MaskAdjustment, AdjustsTheEntriesBeforeItAndNotThoseAfter) {
    const MaskEntry light{
        .id = {13}, .source = ConstantSource{glm::vec3(0.5f)}, .combine = BlendMode::Lighten};
    const auto before = seen_plane({noise_entry(), light, adjusting_entry(AdjustmentKind::Invert)});
    const auto after = seen_plane({noise_entry(), adjusting_entry(AdjustmentKind::Invert), light});
    const auto plain = seen_plane({noise_entry()});
    for (std::size_t i = 0; i < plain.size(); ++i) {
        ASSERT_NEAR(before[i], 1.0f - std::max(plain[i], 0.5f), 1e-6f);
        ASSERT_NEAR(after[i], std::max(1.0f - plain[i], 0.5f), 1e-6f);
    }
}

/// Where a blur of a blurred relief reaches: each goes by the halo of the next.
std::vector<MaskEntry> looking_around() {
    return {{.id = {11}, .source = ReliefSource{.kind = ReliefKind::Height}},
            adjusting_entry(AdjustmentKind::Blur, 12),
            {.id = {13}, .source = noise(), .combine = BlendMode::Overlay},
            adjusting_entry(AdjustmentKind::Warp, 14),
            adjusting_entry(AdjustmentKind::Sharpen, 15)};
}

Material with_heights(const Material& material) {
    Layer heights{.id = {20}};
    set(heights, Channel::Height, noise());
    Material copy = material;
    copy.stack.insert(copy.stack.begin(), shared(heights));
    return copy;
}

TEST(MaskAdjustment, InAGroupAndByReferenceAMaskIsWhatItIsInTheStack) {
    const Material whole = with_heights(seen(looking_around()));
    const auto expected = plane(whole, Channel::Roughness, kMaskSide);
    Layer group{.id = {30}, .mode = BlendMode::PassThrough};
    for (ChannelSettings& settings : group.channels) settings.enabled = true;
    group.content = GroupContent{.children = {whole.stack[1], whole.stack[2]}};
    group.opacity = 0.999999f;  // so that it is one, and not its layers
    expect_near(plane(stack_of({whole.stack[0], shared(group)}), Channel::Roughness, kMaskSide),
                expected, "in a group");

    Layer reader = *seen({{.id = {16}, .source = ReferenceSource{.layer = {2}}}}).stack[1];
    reader.id = {40};
    Layer hidden = *whole.stack[2];
    hidden.visible = false;
    const Material referring =
        stack_of({whole.stack[0], whole.stack[1], shared(hidden), shared(reader)});
    expect_near(plane(referring, Channel::Roughness, kMaskSide), expected, "by reference");
}

TEST(MaskAdjustment, TheMaskThatALayerIsClippedToIsAdjustedToo) {
    Layer base{.id = {2}};
    set(base, Channel::Metalness, ConstantSource{glm::vec3(1.0f)});
    base.mask.entries = {noise_entry(), adjusting_entry(AdjustmentKind::Blur)};
    Layer clipped{.id = {3}, .clipped = true};
    set(clipped, Channel::Roughness, ConstantSource{glm::vec3(1.0f)});
    const Material plain = seen({noise_entry(), adjusting_entry(AdjustmentKind::Blur)});
    EXPECT_EQ(plane(stack_of({plain.stack[0], shared(base), shared(clipped)}), Channel::Roughness,
                    kMaskSide),
              plane(plain, Channel::Roughness, kMaskSide));
}

TEST(MaskAdjustment, AnotherCurveIsAnotherPictureOfTheChannelsOfTheLayer) {
    const Material before = seen({noise_entry(), adjusting_entry(AdjustmentKind::Curves)});
    MaskEntry other = adjusting_entry(AdjustmentKind::Curves);
    other.adjustment->curve[1].y = 0.3f;
    const Material after = seen({noise_entry(), other});
    const auto slot = [](const Material& material, Slot of) {
        return Program::compile(material).slot_hash(of);
    };
    EXPECT_NE(slot(before, Slot::MetallicRoughness), slot(after, Slot::MetallicRoughness));
    EXPECT_EQ(slot(before, Slot::BaseColor), slot(after, Slot::BaseColor));
}

TEST(MaskCombine, EveryModeIsItsPublishedDefinition) {
    const auto below = seen_plane({noise_entry()});
    const Source other = ProceduralSource{.seed = 9, .scale = 5.0f};
    const auto own = seen_plane({{.id = {11}, .source = other}});
    for (const BlendModeInfo& row : kBlendModes) {
        if (!combines_masks(row.mode) || row.mode == BlendMode::Replace) continue;
        if (row.mode == BlendMode::HardMix) continue;  // a step, which the last digit decides
        const auto found = seen_plane(
            {noise_entry(), {.id = {12}, .source = other, .combine = row.mode, .opacity = 0.75f}});
        for (std::size_t i = 0; i < found.size(); ++i) {
            const auto b = static_cast<double>(below[i]), s = static_cast<double>(own[i]);
            ASSERT_NEAR(static_cast<double>(found[i]),
                        0.25 * b + 0.75 * test_support::published_blend(row.mode, b, s), 1e-4)
                << row.id << " of " << b << " and " << s;
        }
    }
}

TEST(MaskCombine, AtFullOpacityAnEntryIsItsModeToTheLastBit) {
    const auto below = seen_plane({noise_entry()});
    const Source other = ProceduralSource{.seed = 9, .scale = 5.0f};
    const auto own = seen_plane({{.id = {11}, .source = other}});
    const auto found =
        seen_plane({noise_entry(), {.id = {12}, .source = other, .combine = BlendMode::Multiply}});
    for (std::size_t i = 0; i < found.size(); ++i)
        ASSERT_EQ(found[i], below[i] * own[i]) << "texel " << i;
}

}  // namespace
}  // namespace patina
