// SPDX-License-Identifier: MIT
// Adjustments that look around: against definitions of their own in double precision, over borders,
// in groups, and in parts of a map.
#include "composite/around.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "composite/composite_rect.h"
#include "composite/small_stack.h"
#include "core/formulae/formulae.h"

namespace patina {
namespace {

/// Texels a side of the images of blocks, and of the maps that show them.
constexpr int kBlocksSide = 40;

std::size_t index_of(int x, int y, int channels, int channel) {
    const auto texel = static_cast<std::size_t>(y) * kBlocksSide + static_cast<std::size_t>(x);
    return texel * static_cast<std::size_t>(channels) + static_cast<std::size_t>(channel);
}

/// Bytes of 0 to 255 in runs of a few texels.
Image blocks(std::uint32_t seed, int channels) {
    std::mt19937 random(seed);
    Image image{.width = kBlocksSide, .height = kBlocksSide, .channels = channels};
    image.data.resize(index_of(0, kBlocksSide, channels, 0));
    for (int y = 0; y < kBlocksSide; ++y)
        for (int x = 0; x < kBlocksSide; ++x)
            for (int k = 0; k < channels; ++k) {
                const std::size_t at = index_of(x, y, channels, k);
                const bool begins = x % 3 == 0 || random() % 4 == 0;
                image.data[at] = begins ? static_cast<std::byte>(random() % 256)
                                        : image.data[at - static_cast<std::size_t>(channels)];
            }
    return image;
}

double byte_at(const Image& image, int x, int y, int channel) {
    const auto wrap = [](int i) { return ((i % kBlocksSide) + kBlocksSide) % kBlocksSide; };
    return static_cast<double>(image.data[index_of(wrap(x), wrap(y), image.channels, channel)]) /
           255;
}

Layer adjusting_layer(const AdjustmentSettings& settings, Channel channel) {
    Layer layer{.id = {2}, .content = AdjustmentContent{settings}};
    at(layer.channels, channel).enabled = true;
    return layer;
}

Layer filled(Channel channel, Source source) {
    Layer layer{.id = {1}};
    at(layer.channels, channel) = {.enabled = true, .source = std::move(source)};
    return layer;
}

/// The weights of a Gaussian of a third of the radius, lowered to 0 there, that sum up to 1.
std::vector<double> gaussian(double radius) {
    std::vector<double> weights;
    double sum = 0;
    for (int j = 0; j < radius; ++j) {
        const double t = 3 * j / radius;
        weights.push_back(std::exp(-t * t / 2) - std::exp(-4.5));
        sum += (j == 0 ? 1 : 2) * weights.back();
    }
    for (double& weight : weights) weight /= sum;
    return weights;
}

/// The weighted mean of read(x, y) in the square around a texel.
template <typename Read>
double blurred(const std::vector<double>& weights, int x, int y, const Read& read) {
    const int reach = static_cast<int>(weights.size()) - 1;
    double sum = 0;
    for (int j = -reach; j <= reach; ++j)
        for (int i = -reach; i <= reach; ++i)
            sum += weights[static_cast<std::size_t>(std::abs(i))] *
                   weights[static_cast<std::size_t>(std::abs(j))] * read(x + i, y + j);
    return sum;
}

AdjustmentSettings blur_of(double radius_texels) {
    AdjustmentSettings settings;
    settings.kind = AdjustmentKind::Blur;
    settings.radius_permille = static_cast<float>(radius_texels * 1000 / kBlocksSide);
    return settings;
}

TEST(Around, ABlurIsTheGaussianMeanOverTheBordersOfTheTexture) {
    ImageTable images;
    const Image image = blocks(1, 1);
    const Source source = ImageSource{.image = images.add(image), .pick = ChannelPick::Red};
    for (const double radius : {0.7, 1.3, 2.0}) {
        const auto baked =
            plane(stack_of({shared(filled(Channel::Roughness, source)),
                            shared(adjusting_layer(blur_of(radius), Channel::Roughness))}),
                  images, Channel::Roughness, kBlocksSide);
        const std::vector<double> weights = gaussian(radius);
        for (int y = 0; y < kBlocksSide; ++y)
            for (int x = 0; x < kBlocksSide; ++x)
                ASSERT_NEAR(
                    static_cast<double>(baked[static_cast<std::size_t>(y * kBlocksSide + x)]),
                    blurred(weights, x, y, [&](int i, int j) { return byte_at(image, i, j, 0); }),
                    2e-6)
                    << radius << " at " << x << ", " << y;
    }
}

TEST(Around, SharpeningAddsWhatABlurTakesAwayAndIsHeldToZeroToOne) {
    ImageTable images;
    const Image image = blocks(2, 1);
    const Source source = ImageSource{.image = images.add(image), .pick = ChannelPick::Red};
    AdjustmentSettings settings = blur_of(2);
    settings.kind = AdjustmentKind::Sharpen;
    settings.amount = 1.5f;
    const auto baked = plane(stack_of({shared(filled(Channel::Metalness, source)),
                                       shared(adjusting_layer(settings, Channel::Metalness))}),
                             images, Channel::Metalness, kBlocksSide);
    const std::vector<double> weights = gaussian(2);
    for (int y = 0; y < kBlocksSide; ++y)
        for (int x = 0; x < kBlocksSide; ++x) {
            const double own = byte_at(image, x, y, 0);
            const double blur =
                blurred(weights, x, y, [&](int i, int j) { return byte_at(image, i, j, 0); });
            ASSERT_NEAR(static_cast<double>(baked[static_cast<std::size_t>(y * kBlocksSide + x)]),
                        std::clamp(own + 1.5 * (own - blur), 0.0, 1.0), 5e-6);
        }
}

/// Inside an isolated group, where a fill has holes: only what covers is mixed, and the holes stay.
TEST(Around, InAGroupABlurMixesOnlyWhatCovers) {
    ImageTable images;
    const Image image = blocks(3, 4);
    const Layer fill = filled(Channel::BaseColor,
                              ImageSource{.image = images.add(image), .alpha_is_coverage = true});
    Layer group{.id = {3}};
    at(group.channels, Channel::BaseColor).enabled = true;
    group.content = GroupContent{
        .children = {shared(fill), shared(adjusting_layer(blur_of(2), Channel::BaseColor))}};
    const auto baked =
        plane(stack_of({shared(group)}), images, Channel::BaseColor, kBlocksSide, /*component=*/1);
    const std::vector<double> weights = gaussian(2);
    const auto cover = [&](int i, int j) { return byte_at(image, i, j, 3); };
    for (int y = 0; y < kBlocksSide; ++y)
        for (int x = 0; x < kBlocksSide; ++x) {
            const double sum = blurred(
                weights, x, y, [&](int i, int j) { return cover(i, j) * byte_at(image, i, j, 1); });
            const double mean = sum / blurred(weights, x, y, cover);
            ASSERT_NEAR(static_cast<double>(baked[static_cast<std::size_t>(y * kBlocksSide + x)]),
                        cover(x, y) * mean + (1 - cover(x, y)) * 0.5, 5e-6);
        }
}

TEST(Around, AWarpTakesEachTexelFromWhereTheNoiseSays) {
    ImageTable images;
    const Image image = blocks(4, 1);
    const Source source = ImageSource{.image = images.add(image), .pick = ChannelPick::Red};
    AdjustmentSettings settings;
    settings.kind = AdjustmentKind::Warp;
    settings.distance_permille = 100.0f;
    settings.scale = 5.0f;
    settings.octaves = 2;
    settings.seed = 9;
    const auto baked = plane(stack_of({shared(filled(Channel::Roughness, source)),
                                       shared(adjusting_layer(settings, Channel::Roughness))}),
                             images, Channel::Roughness, kBlocksSide);
    int moved = 0;
    for (int y = 0; y < kBlocksSide; ++y)
        for (int x = 0; x < kBlocksSide; ++x) {
            const formulae::Real2 cell((static_cast<float>(x) + 0.5f) / kBlocksSide * 5,
                                       (static_cast<float>(y) + 0.5f) / kBlocksSide * 5);
            const formulae::Real2 direction =
                formulae::warp_direction(cell, 5, 9u, 2, 5.0f / kBlocksSide);
            const double px = x + 4.0 * static_cast<double>(direction.x);
            const double py = y + 4.0 * static_cast<double>(direction.y);
            const int x0 = static_cast<int>(std::floor(px)), y0 = static_cast<int>(std::floor(py));
            const auto row = [&](int j) {
                return std::lerp(byte_at(image, x0, j, 0), byte_at(image, x0 + 1, j, 0), px - x0);
            };
            ASSERT_NEAR(static_cast<double>(baked[static_cast<std::size_t>(y * kBlocksSide + x)]),
                        std::lerp(row(y0), row(y0 + 1), py - y0), 1e-5);
            moved += std::abs(px - x) > 0.5 ? 1 : 0;
        }
    EXPECT_GT(moved, kBlocksSide * kBlocksSide / 4);
}

TEST(Around, NothingIsMovedOrMixedByDistanceAndAmountOfZeroOrBelowATexel) {
    ImageTable images;
    const Source source = ImageSource{.image = images.add(blocks(5, 3))};
    const Layer fill = filled(Channel::BaseColor, source);
    const auto plain = plane(stack_of({shared(fill)}), images, Channel::BaseColor, kBlocksSide);
    AdjustmentSettings still;
    still.kind = AdjustmentKind::Warp;
    still.distance_permille = 0.0f;
    AdjustmentSettings blunt = blur_of(2);
    blunt.kind = AdjustmentKind::Sharpen;
    blunt.amount = 0.0f;
    for (const AdjustmentSettings& settings : {still, blunt, blur_of(0.9)})
        EXPECT_EQ(
            plane(stack_of({shared(fill), shared(adjusting_layer(settings, Channel::BaseColor))}),
                  images, Channel::BaseColor, kBlocksSide),
            plain);
}

TEST(Around, ABlurredNormalIsAUnitVectorAndFlatStaysFlat) {
    ImageTable images;
    const Source bumps = ImageSource{.image = images.add(blocks(6, 3)),
                                     .multiply = glm::vec3(0.4f),
                                     .add = glm::vec3(0.0f, 0.0f, 0.6f)};
    const Material material = stack_of({shared(filled(Channel::Normal, bumps)),
                                        shared(adjusting_layer(blur_of(2), Channel::Normal))});
    const auto x = plane(material, images, Channel::Normal, kBlocksSide, 0);
    const auto y = plane(material, images, Channel::Normal, kBlocksSide, 1);
    const auto z = plane(material, images, Channel::Normal, kBlocksSide, 2);
    double rough = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        ASSERT_NEAR(x[i] * x[i] + y[i] * y[i] + z[i] * z[i], 1.0f, 1e-5f);
        rough += std::abs(static_cast<double>(x[i]));
    }
    const auto sharp =
        plane(stack_of({material.stack[0]}), images, Channel::Normal, kBlocksSide, 0);
    double before = 0;
    for (const float value : sharp) before += std::abs(static_cast<double>(value));
    EXPECT_LT(rough, before);
    const Layer flat = filled(Channel::Normal, ConstantSource{{0.0f, 0.0f, 1.0f}});
    for (const float value : plane(stack_of({shared(flat), material.stack[1]}), images,
                                   Channel::Normal, kBlocksSide, 2))
        ASSERT_EQ(value, 1.0f);
}

/// Whatever the resolution, the same picture: means of four texels of the larger map are those of
/// the smaller one, but for what the smaller cannot show.
TEST(Around, TheLookDoesNotDependOnTheResolution) {
    ImageTable images;
    const Source noise = ProceduralSource{.scale = 6.0f, .octaves = 2};
    for (const AdjustmentKind kind :
         {AdjustmentKind::Blur, AdjustmentKind::Sharpen, AdjustmentKind::Warp}) {
        AdjustmentSettings settings;
        settings.kind = kind;
        settings.radius_permille = 40.0f;
        settings.distance_permille = 50.0f;
        const Material material = stack_of({shared(filled(Channel::Roughness, noise)),
                                            shared(adjusting_layer(settings, Channel::Roughness))});
        const auto small = plane(material, images, Channel::Roughness, 128);
        const auto large = plane(material, images, Channel::Roughness, 256);
        for (std::size_t y = 0; y < 128; ++y)
            for (std::size_t x = 0; x < 128; ++x) {
                const std::size_t at = 2 * y * 256 + 2 * x;
                const float mean =
                    0.25f * (large[at] + large[at + 1] + large[at + 256] + large[at + 257]);
                ASSERT_NEAR(small[y * 128 + x], mean, 0.02f) << static_cast<int>(kind);
            }
    }
}

TEST(Around, AnEditOfAPartChangesWhatTheBlurAndTheWarpAboveReach) {
    ImageTable images;
    const Image before = blocks(7, 3);
    Image after = before;
    const TexelRect dab{12, 20, 16, 23};
    for (int y = dab.y0; y < dab.y1; ++y)
        for (int x = dab.x0; x < dab.x1; ++x)
            for (int k = 0; k < 3; ++k) after.data[index_of(x, y, 3, k)] = std::byte{255};
    AdjustmentSettings warp;
    warp.kind = AdjustmentKind::Warp;
    warp.distance_permille = 60.0f;
    const auto program_of = [&](const Image& image) {
        Layer fill = filled(Channel::BaseColor, ImageSource{.image = images.add(image),
                                                            .color_space = ColorSpace::Srgb});
        return Program::compile(
            stack_of({shared(fill), shared(adjusting_layer(blur_of(2), Channel::BaseColor)),
                      shared(adjusting_layer(warp, Channel::BaseColor))}));
    };
    const Program old_program = program_of(before), new_program = program_of(after);
    LiveComposite live;
    ASSERT_TRUE(live.update(old_program, images, kBlocksSide));
    const auto update = live.update_within(dab, new_program, images, kBlocksSide);
    ASSERT_TRUE(update.has_value());
    EXPECT_LT(update->changed.x1 - update->changed.x0, kBlocksSide);
    const MapSet cold = bake_maps(new_program, images, kBlocksSide, {BakedMap::BaseColor}).value();
    EXPECT_EQ(*live.maps()[BakedMap::BaseColor], *cold[BakedMap::BaseColor]);
}

/// Heights that a relief, a blur of a mask of it, a blur of a group and a warp read, each above the
/// other, in three channels.
Material looking_around_often(ImageTable& images, int size) {
    Image spots{.width = size, .height = size, .channels = 4};
    spots.data.resize(spots.row_bytes() * static_cast<std::size_t>(size));
    std::mt19937 random(11);
    for (std::byte& sample : spots.data) sample = static_cast<std::byte>(random() % 256);
    const Source image = ImageSource{.image = images.add(spots), .alpha_is_coverage = true};
    Layer bumps = filled(Channel::Height, ProceduralSource{.scale = 9.0f});
    Layer hollows = filled(Channel::Roughness, ConstantSource{glm::vec3(1.0f)});
    at(hollows.channels, Channel::Height) = {.enabled = true,
                                             .source = ConstantSource{glm::vec3(0.2f)}};
    hollows.mask.entries = {
        {.id = {9}, .source = ReliefSource{.kind = ReliefKind::Edge, .radius_permille = 40.0f}},
        {.id = {10}, .adjustment = blur_of(2), .combine = BlendMode::Replace}};
    Layer group{.id = {3}};
    for (const Channel channel : {Channel::BaseColor, Channel::Height, Channel::Roughness})
        at(group.channels, channel).enabled = true;
    Layer fill = filled(Channel::BaseColor, image);
    at(fill.channels, Channel::Height) = {.enabled = true, .source = image};
    Layer blur = adjusting_layer(blur_of(1.5), Channel::BaseColor);
    at(blur.channels, Channel::Height).enabled = true;
    group.content = GroupContent{.children = {shared(fill), shared(blur)}};
    AdjustmentSettings bend;
    bend.kind = AdjustmentKind::Warp;
    bend.distance_permille = 60.0f;
    Layer warp = adjusting_layer(bend, Channel::BaseColor);
    at(warp.channels, Channel::Height).enabled = true;
    Material material =
        stack_of({shared(bumps), shared(hollows), shared(group), shared(warp), shared(hollows)});
    material.height_scale = 0.05f;
    return material;
}

TEST(Around, StripByStripTheMapIsTheSameAsWhenAllIsKept) {
    constexpr int kSide = 401;  // more than three strips of the fewest rows
    ImageTable images;
    const Program program = Program::compile(looking_around_often(images, kSide));
    const BoundImages bound = images_for_bake(program.data(), kAllChannels, kSide, images).value();
    const auto composited = [&](std::size_t around_bytes) {
        std::vector<float> texels(static_cast<std::size_t>(kSide) * kSide * 8);
        const auto keep = [&](const TileSpan& span, TilePlanes& planes) {
            for (int i = 0; i < span.count; ++i) {
                float* const texel =
                    &texels[static_cast<std::size_t>(span.y * kSide + span.x + i) * 8];
                for (int k = 0; k < 3; ++k) {
                    texel[k] = planes.channel(0, Channel::BaseColor, k)[i];
                    texel[3 + k] = planes.channel(0, Channel::Normal, k)[i];
                }
                texel[6] = planes.channel(0, Channel::Height)[i];
                texel[7] = planes.channel(0, Channel::Roughness)[i];
            }
        };
        EXPECT_TRUE(composite_tiles({.program = &program.data(),
                                     .images = &bound,
                                     .wanted = kAllChannels,
                                     .size = kSide,
                                     .rect = {0, 0, kSide, kSide},
                                     .around_bytes = around_bytes},
                                    keep, {}));
        return texels;
    };
    EXPECT_EQ(composited(0), composited(std::size_t{1} << 30));
}

TEST(Around, WhatIsKeptOfALargeMapIsBoundedAndNotAPlane) {
    constexpr int kSide = 4096;
    Layer bumps = filled(Channel::Height, ProceduralSource{});
    Layer hollows = filled(Channel::Roughness, ConstantSource{glm::vec3(1.0f)});
    hollows.mask.entries = {{.id = {9}, .source = ReliefSource{.radius_permille = 50.0f}}};
    Layer ridges = hollows;
    ridges.mask.entries[0].source = ReliefSource{.kind = ReliefKind::Edge, .radius_permille = 5.0f};
    const Program program =
        Program::compile(stack_of({shared(bumps), shared(hollows), shared(ridges)}));
    const BoundImages none;
    const AroundPass pass(
        {.program = &program.data(), .images = &none, .size = kSide, .rect = {0, 0, kSide, kSide}});
    EXPECT_GT(pass.size_bytes(), 0u);
    EXPECT_LE(pass.size_bytes(), std::size_t{48} << 20);
    EXPECT_LT(pass.strip_rows(), kSide);
}

TEST(Around, WhatIsTheSameEverywhereStaysAFactor) {
    const Material material =
        stack_of({shared(filled(Channel::Roughness, ConstantSource{{0.3f, 0, 0}})),
                  shared(adjusting_layer(blur_of(2), Channel::Roughness))});
    const Program program = Program::compile(material);
    EXPECT_EQ(program.slots()[static_cast<std::size_t>(Slot::MetallicRoughness)],
              SlotPlan(SlotConstant{{0.0f, 0.3f, 0.0f, 0.0f}}));
}

}  // namespace
}  // namespace patina
