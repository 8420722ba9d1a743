// SPDX-License-Identifier: MIT
// Sources that read the relief below their layer, against their definition in double precision.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "composite/small_stack.h"
#include "document/layer_edits.h"
#include "document/mask_edits.h"
#include "document/source_edits.h"

namespace patina {
namespace {

/// Texels a side of the relief.
constexpr int kReliefSide = 48;
constexpr double kRadiusTexels = 2.0;

Layer hills(std::uint32_t seed = 3) {
    Layer layer{.id = {1}};
    ProceduralSource noise{.seed = seed, .scale = 7.0f};
    noise.ramp = {{0.0f, glm::vec3(-0.4f)}, {1.0f, glm::vec3(0.6f)}};
    set(layer, Channel::Height, noise);
    return layer;
}

ReliefSource relief(ReliefKind kind, float strength = 5.0f) {
    return {.kind = kind,
            .radius_permille = static_cast<float>(kRadiusTexels * 1000 / kReliefSide),
            .strength = strength};
}

/// White metal where the relief is.
Layer masked(ReliefKind kind) {
    Layer layer{.id = {2}};
    set(layer, Channel::Metalness, ConstantSource{glm::vec3(1.0f)});
    layer.mask.entries = {relief_mask_entry(kind)};
    layer.mask.entries[0].id = {3};
    layer.mask.entries[0].source = relief(kind);
    return layer;
}

/// The height less its mean around, by a Gaussian of a third of the radius lowered to 0 there.
double lift(const PixelVector<float>& heights, int x, int y) {
    const auto height = [&](int i, int j) {
        const auto wrap = [](int k) { return ((k % kReliefSide) + kReliefSide) % kReliefSide; };
        return static_cast<double>(
            heights[static_cast<std::size_t>(wrap(j) * kReliefSide + wrap(i))]);
    };
    const auto weight = [](int j) {
        const double t = 3 * std::abs(j) / kRadiusTexels;
        return std::max(std::exp(-t * t / 2) - std::exp(-4.5), 0.0);
    };
    double sum = 0, total = 0;
    for (int j = -2; j <= 2; ++j)
        for (int i = -2; i <= 2; ++i) {
            sum += weight(i) * weight(j) * height(x + i, y + j);
            total += weight(i) * weight(j);
        }
    return height(x, y) - sum / total;
}

double relief_by_definition(ReliefKind kind, double own, double lifted, double strength) {
    switch (kind) {
        case ReliefKind::Height:
            return std::clamp(0.5 + 0.5 * own * strength, 0.0, 1.0);
        case ReliefKind::Cavity:
            return std::clamp(-lifted * strength, 0.0, 1.0);
        case ReliefKind::Edge:
            return std::clamp(lifted * strength, 0.0, 1.0);
        case ReliefKind::Curvature:
            return std::clamp(0.5 + 0.5 * lifted * strength, 0.0, 1.0);
    }
    return 0;
}

TEST(Relief, AMaskAndAChannelGetWhatTheHeightsBelowAreLike) {
    const auto heights = plane(stack_of({shared(hills())}), Channel::Height, kReliefSide);
    for (const ReliefKind kind :
         {ReliefKind::Height, ReliefKind::Cavity, ReliefKind::Edge, ReliefKind::Curvature}) {
        Layer layer = masked(kind);
        // Its own heights come after; it is the relief below that counts.
        set(layer, Channel::Height, ConstantSource{glm::vec3(0.5f)});
        set(layer, Channel::Opacity, relief(kind));
        const Material material = stack_of({shared(hills()), shared(layer)});
        const auto metalness = plane(material, Channel::Metalness, kReliefSide);
        const auto opacity = plane(material, Channel::Opacity, kReliefSide);
        for (int y = 0; y < kReliefSide; ++y)
            for (int x = 0; x < kReliefSide; ++x) {
                const auto i = static_cast<std::size_t>(y * kReliefSide + x);
                const double value = relief_by_definition(kind, static_cast<double>(heights[i]),
                                                          lift(heights, x, y), 5.0);
                ASSERT_NEAR(static_cast<double>(metalness[i]), value, 1e-5);
                // Laid by the same mask on an opacity of 1.
                ASSERT_NEAR(static_cast<double>(opacity[i]), 1 - value + value * value, 2e-5);
            }
    }
}

TEST(Relief, WhereAllIsLevelThereIsNoCavityAndNoEdge) {
    for (const ReliefKind kind : {ReliefKind::Cavity, ReliefKind::Edge})
        for (const float value :
             plane(stack_of({shared(masked(kind))}), Channel::Metalness, kReliefSide))
            ASSERT_EQ(value, 0.0f);
}

TEST(Relief, HeightsThatAreCoveredFurtherUpStillCount) {
    Layer flat{.id = {4}};
    set(flat, Channel::Height, ConstantSource{glm::vec3(0.25f)});
    at(flat.channels, Channel::Height).mode = BlendMode::Replace;
    EXPECT_EQ(plane(stack_of({shared(hills()), shared(masked(ReliefKind::Edge)), shared(flat)}),
                    Channel::Metalness, kReliefSide),
              plane(stack_of({shared(hills()), shared(masked(ReliefKind::Edge))}),
                    Channel::Metalness, kReliefSide));
}

/// A clipped layer covers what its base does, though heights have changed between them.
TEST(Relief, ALayerClippedToAReliefMaskGoesByTheSameRelief) {
    Layer base = masked(ReliefKind::Edge);
    set(base, Channel::Height, ConstantSource{glm::vec3(1.0f)});
    Layer clipped{.id = {5}, .clipped = true};
    set(clipped, Channel::Roughness, ConstantSource{glm::vec3(1.0f)});
    const Material material = stack_of({shared(hills()), shared(base), shared(clipped)});
    const auto metalness = plane(material, Channel::Metalness, kReliefSide);
    const auto roughness = plane(material, Channel::Roughness, kReliefSide);
    for (std::size_t i = 0; i < metalness.size(); ++i)
        ASSERT_NEAR(roughness[i], 0.5f + 0.5f * metalness[i], 1e-6f);
}

TEST(Relief, AnotherHeightBelowIsAnotherPicture) {
    const auto hash = [](std::uint32_t seed, Slot slot) {
        return Program::compile(stack_of({shared(hills(seed)), shared(masked(ReliefKind::Cavity))}))
            .slot_hash(slot);
    };
    EXPECT_NE(hash(1, Slot::MetallicRoughness), hash(2, Slot::MetallicRoughness));
    EXPECT_EQ(hash(1, Slot::Emissive), hash(2, Slot::Emissive));
}

TEST(Relief, FeedsMasksAndSingleNumbersOnly) {
    Document document;
    Layer layer = value_layer();
    layer.id = {1};
    Material material = stack_of({shared(layer)});
    material.id = {1};
    material.name = "Body";
    document.materials = {std::make_shared<const Material>(material)};
    document.next_id = 2;
    const auto with = [&](Channel channel) {
        return set_source(source_place(material, layer, channel), ReliefSource{}).apply(document);
    };
    EXPECT_TRUE(with(Channel::Roughness).has_value());
    EXPECT_FALSE(with(Channel::BaseColor).has_value());
    EXPECT_FALSE(with(Channel::Height).has_value());
    EXPECT_FALSE(with(Channel::Normal).has_value());
}

}  // namespace
}  // namespace patina
