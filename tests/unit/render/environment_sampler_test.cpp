// SPDX-License-Identifier: MIT
#include "render/environment_sampler.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/constants.hpp>

namespace patina::render {
namespace {

std::shared_ptr<const RadianceMap> map_with_a_sun() {
    auto map = std::make_shared<RadianceMap>();
    map->width = 64;
    map->height = 32;
    for (int y = 0; y < map->height; ++y)
        for (int x = 0; x < map->width; ++x)
            map->texels.push_back(glm::vec3(0.2f + 0.01f * static_cast<float>(y)) +
                                  glm::vec3(0.1f, 0.0f, 0.3f) * static_cast<float>(x % 2));
    map->texels[64 * 9 + 50] = glm::vec3(5000.0f, 4000.0f, 3000.0f);
    return map;
}

TEST(EnvironmentSampler, DrawsASunAsOftenAsItsLightIsOfAll) {
    const auto map = map_with_a_sun();
    const EnvironmentSampler sampler(map);
    constexpr std::uint32_t kCount = 1 << 16;
    const glm::vec3 to_sun = texel_direction(*map, 50, 9);
    const float reach = std::cos(2.0f * glm::pi<float>() / 32.0f);  // two texels
    double sun = 0.0;
    glm::dvec3 irradiance(0.0);  // on a surface that faces +Y
    for (std::uint32_t i = 0; i < kCount; ++i) {
        const EnvironmentSample sample = sampler.sample(sobol_point(i));
        ASSERT_GT(sample.density, 0.0f);
        ASSERT_NEAR(glm::length(sample.towards), 1.0f, 1e-5f);
        if (glm::dot(sample.towards, to_sun) > reach) sun += 1.0 / kCount;
        irradiance += glm::dvec3(sample.radiance_linear) *
                      (std::max(double{sample.towards.y}, 0.0) / double{sample.density} / kCount);
    }
    // What lies around the sun, within reach of it, is 0.31 bright.
    const double around = 0.31 * 2.0 * glm::pi<double>() * (1.0 - double{reach});
    const double of_sun = 4138.4 * texel_solid_angle(*map, 9) + around;
    EXPECT_NEAR(sun, of_sun / sampler.total_luminance(), 1e-3);
    EXPECT_GT(irradiance.x, irradiance.y);
}

TEST(EnvironmentSampler, DrawsEveryDirectionAsDenselyAsItIsReadBright) {
    const auto map = map_with_a_sun();
    const EnvironmentSampler sampler(map);
    double light = 0.0;
    constexpr std::uint32_t kCount = 1 << 12;
    for (std::uint32_t i = 0; i < kCount; ++i) {
        const EnvironmentSample sample = sampler.sample(sobol_point(i));
        const double all = luminance_of(sample.radiance_linear) / double{sample.density};
        light += all / kCount;
        // Rows near the poles differ in how wide their texels are.
        if (std::abs(sample.towards.y) < 0.9f) {
            EXPECT_NEAR(all / sampler.total_luminance(), 1.0, 0.1);
        }
    }
    EXPECT_NEAR(light / sampler.total_luminance(), 1.0, 0.01);
}

TEST(EnvironmentSampler, TheMeanOfAFunctionOverItsDensityIsTheIntegral) {
    const EnvironmentSampler sampler(map_with_a_sun());
    constexpr std::uint32_t kCount = 1 << 15;
    double sphere = 0.0;
    double up = 0.0;
    for (std::uint32_t i = 0; i < kCount; ++i) {
        const EnvironmentSample sample = sampler.sample(sobol_point(i));
        sphere += 1.0 / double{sample.density} / kCount;
        up += double{sample.towards.y} * sample.towards.y / double{sample.density} / kCount;
    }
    EXPECT_NEAR(sphere / (4.0 * glm::pi<double>()), 1.0, 0.02);
    EXPECT_NEAR(up / (4.0 / 3.0 * glm::pi<double>()), 1.0, 0.03);
}

TEST(EnvironmentSampler, ABlackMapHasNoLight) {
    auto black = std::make_shared<RadianceMap>();
    black->width = 4;
    black->height = 2;
    black->texels.assign(8, glm::vec3(0.0f));
    EXPECT_FALSE(EnvironmentSampler(black).has_light());
}

TEST(EnvironmentSampler, EveryRunOfPointsIsOneToAStrip) {
    for (const std::uint32_t strips : {4u, 16u, 256u})
        for (const std::uint32_t run : {0u, 3u}) {
            std::vector<int> across(strips);
            std::vector<int> down(strips);
            for (std::uint32_t i = 0; i < strips; ++i) {
                const glm::vec2 point = sobol_point(run * strips + i);
                ++across[static_cast<std::size_t>(point.x * static_cast<float>(strips))];
                ++down[static_cast<std::size_t>(point.y * static_cast<float>(strips))];
            }
            for (std::uint32_t i = 0; i < strips; ++i) {
                EXPECT_EQ(across[i], 1);
                EXPECT_EQ(down[i], 1);
            }
        }
}

}  // namespace
}  // namespace patina::render
