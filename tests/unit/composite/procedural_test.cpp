// SPDX-License-Identifier: MIT
// Procedurals along a row, whose cells are hashed once, are those that the shared text gives one
// texel at a time.
#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <numeric>

#include "composite/compile.h"
#include "composite/procedural_kernels.h"
#include "composite/small_stack.h"
#include "composite/tile.h"
#include "core/formulae/formulae.h"
#include "document/choices.h"

namespace patina {
namespace {

/// A run that begins and ends in the middle of a cell, `size` texels a side.
ProceduralTask run_of(ProceduralKind kind, int size) {
    return {.x = 5,
            .count = std::min(size, kTileTexels) - 5,
            .size = static_cast<float>(size),
            .u_of_row = 0.013f,
            .v_of_row = 0.61f,
            .u_per_u = 1.0f,
            .kind = kind,
            .seed = 21,
            .columns = 8,
            .rows = 10,
            .octaves = 6,
            .footprint = 10.0f / static_cast<float>(size),
            .stop_count = 2,
            .stop_positions = {0.0f, 1.0f},
            .stop_values = {{0.0f}, {1.0f}},
            .mean = {0.4f}};
}

/// The same by the text, for one place.
float value_by_text(const ProceduralTask& task, float u, float v) {
    formulae::Ramp ramp = {};
    ramp.count = task.stop_count;
    for (int stop = 0; stop < task.stop_count; ++stop)
        ramp.stops[stop] = {task.stop_positions[stop], task.stop_values[stop][0], 0.0f, 0.0f};
    const auto pattern = pattern_of<formulae::Pattern>(task);
    const formulae::Shown shown = formulae::pattern_shown(pattern);
    const float value = formulae::pattern_value(
        pattern, {u * static_cast<float>(task.columns), v * static_cast<float>(task.rows)});
    return formulae::faded_result(
        shown, formulae::ramp_scalar(ramp, formulae::spread_pattern(shown, value)), task.mean[0]);
}
float value_by_text(const ProceduralTask& task, int i) {
    const float u = (static_cast<float>(task.x + i) + 0.5f) / task.size;
    return value_by_text(task, u * task.u_per_u + task.u_of_row, u * task.v_per_u + task.v_of_row);
}

int differing_texels(const ProceduralTask& task) {
    alignas(64) float values[kTileTexels];
    float* const planes[3] = {values, nullptr, nullptr};
    run_pattern(task, planes[0]);
    run_ramp(task, planes[0], planes);
    int differing = 0;
    for (int i = 0; i < task.count; ++i) differing += values[i] != value_by_text(task, i);
    return differing;
}

TEST(Procedurals, ARunIsTexelForTexelWhatTheTextSaysOnEveryInstructionSet) {
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        hwy::SetSupportedTargetsForTest(target);
        for (std::size_t kind = 0; kind < kProceduralKinds.size(); ++kind)
            // From cells of a hundred texels, shared by runs of lanes, to some that fade out.
            for (const int size : {17, 60, 1024}) {
                ProceduralTask task = run_of(static_cast<ProceduralKind>(kind), size);
                EXPECT_EQ(differing_texels(task), 0) << kProceduralKinds[kind].id << " at " << size
                                                     << " on " << hwy::TargetName(target);
                task.warp = 0.4f;
                task.v_per_u = 0.7f;  // askew: rows of cells come and go along the run
                EXPECT_EQ(differing_texels(task), 0) << kProceduralKinds[kind].id << " askew at "
                                                     << size << " on " << hwy::TargetName(target);
            }
    }
    hwy::SetSupportedTargetsForTest(0);
}

TEST(Procedurals, PlacesThatAProjectionScattersAreLookedUpOneByOne) {
    float u[kTileTexels], v[kTileTexels];
    ProceduralTask task = run_of(ProceduralKind::Cells, 1024);
    for (int i = 0; i < kTileTexels; ++i) {
        u[i] = formulae::unit_from_bits(formulae::lattice_hash(i, 0, 1u));
        v[i] = formulae::unit_from_bits(formulae::lattice_hash(i, 1, 1u));
    }
    alignas(64) float scattered[kTileTexels];
    float* const planes[3] = {scattered, nullptr, nullptr};
    task.u = u;
    task.v = v;
    run_pattern(task, planes[0]);
    run_ramp(task, planes[0], planes);
    for (int i = 0; i < task.count; ++i) ASSERT_EQ(scattered[i], value_by_text(task, u[i], v[i]));
}

double mean_of(const ProceduralSource& source, int size) {
    Layer layer{.id = {1}};
    set(layer, Channel::Roughness, source);
    const PixelVector<float> values =
        plane(stack_of({shared(std::move(layer))}), Channel::Roughness, size);
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Contrast and ramp come after the pattern: what is lost of it must not shift what they make of
/// it.
TEST(Procedurals, AThresholdLetsAsMuchPassAtEverySize) {
    for (std::size_t i = 0; i < kProceduralKinds.size(); ++i) {
        ProceduralSource source{
            .kind = static_cast<ProceduralKind>(i), .scale = 64.0f, .octaves = 3};
        source.contrast = 0.9f;
        const double large = mean_of(source, 2048);
        for (const int size : {32, 64, 128})
            EXPECT_NEAR(mean_of(source, size), large, 0.04)
                << kProceduralKinds[i].id << " at " << size;
    }
}

TEST(Procedurals, ThoseTooFineToBeSeenAreTheMeanOfTheirRamp) {
    ProceduralSource source{.kind = ProceduralKind::Spots, .scale = 512.0f};
    source.ramp = {{0.0f, glm::vec3(0.2f)}, {0.6f, glm::vec3(0.2f)}, {0.6f, glm::vec3(0.9f)}};
    EXPECT_NEAR(mean_of(source, 32), mean_of(source, 4096), 0.01);
}

/// A layer that shows a pattern in these channels, each with a contrast of its own.
LayerPtr shown_pattern(std::initializer_list<Channel> channels) {
    Layer layer{.id = {1}};
    float contrast = 0.1f;
    for (const Channel channel : channels) {
        const ProceduralSource source{
            .seed = 5, .scale = 6.0f, .octaves = 7, .warp = 0.3f, .contrast = contrast};
        at(layer.channels, channel) = {.enabled = true, .source = source};
        contrast += 0.2f;
    }
    return std::make_shared<const Layer>(std::move(layer));
}

/// A pattern is run once for all that show it, and for the heights of a row before its other
/// channels.
TEST(Procedurals, APatternIsTheSameWhoeverElseShowsIt) {
    constexpr int kSide = 90;
    ImageTable images;
    const auto maps_of_channels = [&](std::initializer_list<Channel> channels) {
        Material material;
        material.height_scale = 0.02f;
        material.stack = {shown_pattern(channels)};
        return bake_maps(Program::compile(material), images, kSide,
                         {BakedMap::OcclusionRoughnessMetalness, BakedMap::Normal})
            .value();
    };
    const MapSet alone = maps_of_channels({Channel::Roughness});
    const MapSet shared = maps_of_channels({Channel::Roughness, Channel::Metalness});
    const MapSet with_heights =
        maps_of_channels({Channel::Roughness, Channel::Metalness, Channel::Height});
    const auto channel = [](const MapSet& maps, std::size_t component) {
        std::vector<std::byte> values;
        const auto& texels = maps[BakedMap::OcclusionRoughnessMetalness]->data;
        for (std::size_t i = component; i < texels.size(); i += 4) values.push_back(texels[i]);
        return values;
    };
    EXPECT_EQ(channel(alone, 1), channel(shared, 1));
    EXPECT_EQ(channel(alone, 1), channel(with_heights, 1));
    EXPECT_EQ(channel(shared, 2), channel(with_heights, 2));
    EXPECT_NE(channel(shared, 1), channel(shared, 2));
}

TEST(Procedurals, OnlyAPatternThatIsWantedAgainIsKept) {
    const auto numbers = [](std::initializer_list<LayerPtr> layers) {
        Material material;
        material.stack = layers;
        std::vector<std::int32_t> patterns;
        for (const SourceRecord& record :
             compile_material(material, nullptr, CoveredLayers::Drop).sources)
            patterns.push_back(record.pattern);
        return patterns;
    };
    EXPECT_EQ(numbers({shown_pattern({Channel::Roughness})}), std::vector{-1});
    EXPECT_EQ(numbers({shown_pattern({Channel::Roughness, Channel::Metalness})}),
              (std::vector{0, 0}));
    EXPECT_EQ(numbers({shown_pattern({Channel::Height})}), std::vector{0});
}

}  // namespace
}  // namespace patina
