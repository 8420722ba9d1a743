// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <rapidcheck/gtest.h>
#include <algorithm>

#include "composite/composite.h"
#include "composite/random_stack.h"
#include "composite/reference.h"
#include "core/parallel.h"

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
struct Difference {
    double greatest = 0;
    int beyond_rounding = 0;  ///< values that are not the nearest byte
    int values = 0;
};

Difference difference_from_reference(const Material& material, const ImageTable& images,
                                     BakedMap map, const Image& image) {
    Difference difference;
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
        const Difference difference =
            difference_from_reference(material, random.images, map, *maps[map]);
        RC_LOG() << kBakedMapIds[static_cast<std::size_t>(map)] << ": greatest difference "
                 << difference.greatest << ", beyond rounding " << difference.beyond_rounding
                 << " of " << difference.values << ", seed " << seed << std::endl;
        RC_ASSERT(difference.beyond_rounding == 0);
    }
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
    EXPECT_EQ(to_hex(hasher.finish()), "f68d395f0f0f05609b30111c95486b54");
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
