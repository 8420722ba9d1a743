// SPDX-License-Identifier: MIT
#include "render/environment.h"
#include "render/environment_brdf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/packing.hpp>

#include "core/parallel.h"
#include "io/image_decode.h"
#include "io/load.h"
#include "render/radiance_cube.h"
#include "render/render_test.h"
#include "shaders/vectors.h"

namespace patina::render {
namespace {

Image uniform_map(int width, const glm::vec3& radiance) {
    Image image{
        .width = width, .height = width / 2, .channels = 3, .type = SampleType::F32, .data = {}};
    image.data.resize(image.row_bytes() * static_cast<std::size_t>(image.height));
    for (std::size_t i = 0; i < image.data.size(); i += sizeof radiance)
        std::memcpy(image.data.data() + i, &radiance, sizeof radiance);
    return image;
}

void set_texel(Image& image, int x, int y, const glm::vec3& radiance) {
    std::memcpy(image.data.data() + static_cast<std::size_t>(y) * image.row_bytes() +
                    static_cast<std::size_t>(x) * sizeof radiance,
                &radiance, sizeof radiance);
}

glm::vec3 texel_of(const HalfCube& cube, std::size_t level, int face, int x, int y) {
    const auto side = static_cast<std::size_t>(cube.face_size) >> level;
    const std::uint16_t* texel =
        cube.levels[level].data() +
        ((static_cast<std::size_t>(face) * side + static_cast<std::size_t>(y)) * side +
         static_cast<std::size_t>(x)) *
            kHalfCubeChannels;
    return {glm::unpackHalf1x16(texel[0]), glm::unpackHalf1x16(texel[1]),
            glm::unpackHalf1x16(texel[2])};
}

void expect_all_finite(const HalfCube& cube) {
    for (const std::vector<std::uint16_t>& level : cube.levels)
        for (const std::uint16_t half : level)
            ASSERT_NE(half & 0x7c00u, 0x7c00u) << "infinite or not a number";
}

TEST(Environment, UniformLightStaysAsItIsAtEveryRoughness) {
    const FilteredEnvironment filtered =
        value_of(filter_environment(uniform_map(128, {0.25f, 0.5f, 2.0f}), FilterQuality::First));
    for (std::size_t level = 0; level < filtered.specular.levels.size(); ++level)
        for (int face = 0; face < kCubeFaces; ++face) {
            const glm::vec3 texel = texel_of(filtered.specular, level, face, 0, 0);
            EXPECT_NEAR(texel.x, 0.25f, 1e-3f);
            EXPECT_NEAR(texel.z, 2.0f, 1e-2f);
        }
    EXPECT_NEAR(texel_of(filtered.diffuse, 0, 2, 3, 3).y, 0.5f, 5e-3f);
    EXPECT_NEAR(filtered.ambient_linear.y + filtered.keys[0].irradiance_linear.y, 0.5f, 5e-3f);
}

TEST(Environment, TheCentreColumnLiesTowardsPlusXAndTheTopRowTowardsPlusY) {
    Image map = uniform_map(256, glm::vec3(0.0f));
    for (int y = 60; y < 68; ++y)
        for (int x = 124; x < 132; ++x) set_texel(map, x, y, {8.0f, 0.0f, 0.0f});
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 256; ++x) set_texel(map, x, y, {0.0f, 8.0f, 0.0f});
    // Three quarters of the way along: atan2(z, x) = pi / 2, which is +Z.
    for (int y = 60; y < 68; ++y)
        for (int x = 188; x < 196; ++x) set_texel(map, x, y, {0.0f, 0.0f, 8.0f});
    const FilteredEnvironment filtered = value_of(filter_environment(map, FilterQuality::First));
    const int middle = filtered.specular.face_size / 2;
    EXPECT_GT(texel_of(filtered.specular, 0, 0, middle, middle).x, 7.0f) << "+X";
    EXPECT_GT(texel_of(filtered.specular, 0, 2, middle, middle).y, 7.0f) << "+Y";
    EXPECT_GT(texel_of(filtered.specular, 0, 4, middle, middle).z, 7.0f) << "+Z";
}

TEST(Environment, IrradianceOfASmallLightIsItsPowerTimesTheCosine) {
    Image map = uniform_map(128, glm::vec3(0.0f));
    // Towards +Y: a cap of the top two rows.
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 128; ++x) set_texel(map, x, y, glm::vec3(500.0f));
    const FilteredEnvironment filtered = value_of(filter_environment(map, FilterQuality::Finished));
    const double cap = 2.0 * kPi * (1.0 - std::cos(kPi * 2.0 / 64.0));
    const int middle = filtered.diffuse.face_size / 2;
    const double facing = texel_of(filtered.diffuse, 0, 2, middle, middle).x;
    EXPECT_NEAR(facing / (500.0 * cap / kPi), 1.0, 0.01);
    EXPECT_LT(texel_of(filtered.diffuse, 0, 3, middle, middle).x, 1e-3f) << "no ringing below";
    EXPECT_NEAR(filtered.keys[0].direction_map.y, -1.0f, 1e-2f);
}

TEST(Environment, ItsStrongestLightsAreThoseOfTheTraditionalModelsAndKeepTheEnergy) {
    Image map = uniform_map(128, glm::vec3(0.2f));
    const auto add = [&](int middle, float radiance) {
        for (int y = 24; y < 32; ++y)
            for (int x = middle - 4; x < middle + 4; ++x) set_texel(map, x, y, glm::vec3(radiance));
    };
    add(20, 10.0f);
    add(60, 30.0f);
    add(100, 20.0f);
    const FilteredEnvironment filtered = value_of(filter_environment(map, FilterQuality::First));
    ASSERT_EQ(filtered.keys.size(), 3u);
    const auto towards = [](int x) {
        const double angle = 2.0 * kPi * (x / 128.0 - 0.5);
        return glm::vec3(std::cos(angle), 0.0, std::sin(angle));
    };
    const std::array<int, 3> order = {60, 100, 20};
    double power = 4.0 * kPi * double{filtered.ambient_linear.g};
    for (std::size_t i = 0; i < order.size(); ++i) {
        const glm::vec3 level =
            glm::normalize(-filtered.keys[i].direction_map * glm::vec3(1.0f, 0.0f, 1.0f));
        EXPECT_GT(glm::dot(level, towards(order[i])), 0.99f) << i;
        EXPECT_LT(filtered.keys[i].direction_map.y, 0.0f) << i;
        power += double{filtered.keys[i].irradiance_linear.g};
    }
    double expected = 4.0 * kPi * 0.2;
    for (int y = 24; y < 32; ++y)
        expected += (9.8 + 29.8 + 19.8) * 8.0 * 2.0 * kPi / 128.0 *
                    (std::cos(kPi * y / 64.0) - std::cos(kPi * (y + 1) / 64.0));
    EXPECT_NEAR(power / expected, 1.0, 0.02);
}

TEST(Environment, PeaksBeyondHalfFloatsStayFiniteAndKeepTheirPower) {
    Image map = uniform_map(256, glm::vec3(0.0f));
    for (int y = 40; y < 42; ++y)
        for (int x = 100; x < 102; ++x) set_texel(map, x, y, glm::vec3(200000.0f));
    const FilteredEnvironment filtered = value_of(filter_environment(map, FilterQuality::First));
    expect_all_finite(filtered.specular);
    expect_all_finite(filtered.diffuse);
    double map_power = 0.0;
    for (int y = 40; y < 42; ++y)
        map_power += 2.0 * 200000.0 * 2.0 * kPi / 256.0 *
                     (std::cos(kPi * y / 128.0) - std::cos(kPi * (y + 1) / 128.0));
    double cube_power = 0.0;
    const int side = filtered.specular.face_size;
    for (int face = 0; face < kCubeFaces; ++face)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                cube_power += static_cast<double>(texel_of(filtered.specular, 0, face, x, y).x) *
                              static_cast<double>(cube_texel_solid_angle(side, x, y));
    EXPECT_NEAR(cube_power / map_power, 1.0, 0.1);
}

TEST(Environment, RoughnessAndLevelShareAreInverses) {
    for (float roughness = 0.0f; roughness <= 1.0f; roughness += 0.1f)
        EXPECT_NEAR(prefiltered_roughness(prefiltered_level_share(roughness)), roughness, 1e-5f);
    EXPECT_EQ(prefiltered_level_share(0.0f), 0.0f);
    EXPECT_EQ(prefiltered_level_share(1.0f), 1.0f);
}

TEST(Environment, TheSameTexelsWithOneThreadAndWithMany) {
    const Image map = value_of(builtin_environment("sky", 32));
    const FilteredEnvironment many = value_of(filter_environment(map, FilterQuality::First));
    const ThreadLimit one(1);
    const FilteredEnvironment single = value_of(filter_environment(map, FilterQuality::First));
    EXPECT_EQ(many.specular.levels, single.specular.levels);
    EXPECT_EQ(many.diffuse.levels, single.diffuse.levels);
}

TEST(Environment, EveryBuiltInOneIsFiniteAndLitFromAbove) {
    for (const BuiltinEnvironment& entry : kBuiltinEnvironments) {
        const FilteredEnvironment filtered = filtered_builtin(entry.id);
        expect_all_finite(filtered.specular);
        const glm::vec3 up = texel_of(filtered.diffuse, 0, 2, 8, 8);
        EXPECT_GT(up.y, 0.2f) << entry.id;
        EXPECT_LT(up.y, 2.5f) << entry.id;
    }
}

/// The strongest texel of a sky, and where it is seen.
struct SkySun {
    glm::vec3 radiance = glm::vec3(0.0f);
    glm::vec3 direction = glm::vec3(0.0f);
};
SkySun sun_of(float elevation_degrees) {
    constexpr int kHeight = 256;
    const RadianceMap map = value_of(
        radiance_map(value_of(builtin_environment(kSkyEnvironment, kHeight, elevation_degrees))));
    SkySun sun;
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x)
            if (map.at(x, y).x > sun.radiance.x)
                sun = {.radiance = map.at(x, y), .direction = texel_direction(map, x, y)};
    return sun;
}

TEST(Environment, TheSunOfTheSkyStandsAsHighAsItIsTold) {
    for (const float elevation : {3.0f, 20.0f, kSunElevationDegrees, 65.0f, 90.0f})
        EXPECT_NEAR(glm::degrees(std::asin(sun_of(elevation).direction.y)), elevation, 1.2f);
}

TEST(Environment, ALowSunIsWeakerAndRedder) {
    SkySun higher = sun_of(90.0f);
    for (const float elevation : {50.0f, kSunElevationDegrees, 20.0f, 10.0f, 4.0f}) {
        const SkySun sun = sun_of(elevation);
        EXPECT_LT(sun.radiance.x, higher.radiance.x) << elevation;
        EXPECT_LT(sun.radiance.z / sun.radiance.x, higher.radiance.z / higher.radiance.x)
            << elevation;
        higher = sun;
    }
}

TEST(Environment, ASkyIsFiniteAndNeverBlackWhereverItsSunStands) {
    for (const float elevation : {0.0f, 1.0f, 45.0f, 90.0f}) {
        const RadianceMap map =
            value_of(radiance_map(value_of(builtin_environment(kSkyEnvironment, 64, elevation))));
        for (const glm::vec3& texel : map.texels)
            for (int i = 0; i < 3; ++i) {
                ASSERT_TRUE(std::isfinite(texel[i])) << elevation;
                ASSERT_GT(texel[i], 0.001f) << elevation;
            }
    }
}

TEST(Environment, AFineMapKeepsItsTexelsForTheBackground) {
    constexpr int kWidth = 4096;
    Image map = uniform_map(kWidth, glm::vec3(0.0f));
    // Stripes of one texel at the horizon, which half as many texels could only show as grey.
    auto* const values = reinterpret_cast<glm::vec3*>(map.data.data());
    for (int i = 0; i < kWidth * kWidth / 2; ++i) values[i] = glm::vec3(static_cast<float>(i % 2));
    FilteredEnvironment environment;
    environment.quality = FilterQuality::Finished;
    ASSERT_TRUE(set_map(map, environment));
    ASSERT_EQ(environment.backdrop.face_size, kBackdropFace);
    EXPECT_EQ(environment.map->width, 2048);
    const std::vector<std::uint16_t>& texels = environment.backdrop.levels.at(0);
    float least = 1.0f;
    float most = 0.0f;
    for (int x = 0; x < 64; ++x) {
        const auto at = static_cast<std::size_t>(kBackdropFace / 2 * kBackdropFace + x);
        const float red = glm::unpackHalf1x16(texels[at * kHalfCubeChannels]);
        least = std::min(least, red);
        most = std::max(most, red);
    }
    EXPECT_GT(most - least, 0.5f);
}

TEST(Environment, ACoarseMapHasNoOtherBackground) {
    EXPECT_TRUE(
        value_of(filter_environment(uniform_map(64, glm::vec3(1.0f)), FilterQuality::Finished))
            .backdrop.levels.empty());
}

TEST(Environment, AnUnknownNameIsAFailureThatListsTheKnownOnes) {
    const Result<Image> made = builtin_environment("moon\n");
    ASSERT_FALSE(made);
    EXPECT_NE(made.error().message.find("studio, sky, white"), std::string::npos);
    EXPECT_EQ(made.error().message.find('\n'), std::string::npos);
}

TEST(Environment, TheBrdfTableReflectsEverythingOfAMirrorAndLessOfARoughWhiteMetal) {
    constexpr int kSize = 32;
    const std::vector<EnvironmentBrdf> table = environment_brdf_table(kSize);
    for (int i = 4; i < kSize; ++i) {
        const EnvironmentBrdf smooth = table[static_cast<std::size_t>(i)];
        EXPECT_NEAR(smooth.scale + smooth.bias, 1.0f, 0.01f) << "roughness 0, column " << i;
        const EnvironmentBrdf rough = table[static_cast<std::size_t>((kSize - 1) * kSize + i)];
        EXPECT_LT(rough.scale + rough.bias, 0.95f);
        EXPECT_GT(rough.scale + rough.bias, 0.3f);
    }
}

TEST(Environment, TheGardenWithASunBeyondHalfFloatsStaysFinite) {
    const std::filesystem::path path = std::filesystem::path(PATINA_SOURCE_DIR) /
                                       "../shared/assets/environments/chinese_garden_1k.hdr";
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
    const Bytes encoded = value_of(read_file(path));
    const ImagePtr map = value_of(io::decode_image(encoded, "chinese_garden_1k.hdr"));
    const FilteredEnvironment filtered = value_of(filter_environment(*map, FilterQuality::First));
    expect_all_finite(filtered.specular);
    expect_all_finite(filtered.diffuse);
}

}  // namespace
}  // namespace patina::render
