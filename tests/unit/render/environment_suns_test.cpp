// SPDX-License-Identifier: MIT
#include "render/environment_suns.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/constants.hpp>

namespace patina::render {
namespace {

constexpr int kSkyWidth = 512;

/// A grey sky with a disc of that radius and radiance around a direction.
RadianceMap sky_with_disc(const glm::vec3& towards, float radius_radians, float radiance) {
    RadianceMap map{kSkyWidth, kSkyWidth / 2, {}};
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x) {
            const glm::vec3 direction = texel_direction(map, x, y);
            const bool inside = glm::dot(direction, towards) > std::cos(radius_radians);
            map.texels.push_back(inside ? glm::vec3(radiance, radiance, 0.5f * radiance)
                                        : glm::vec3(0.5f));
        }
    return map;
}

glm::dvec3 power_of(const RadianceMap& map) {
    glm::dvec3 power(0.0);
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x)
            power += double{texel_solid_angle(map, y)} * glm::dvec3(map.at(x, y));
    return power;
}

TEST(EnvironmentSuns, ADiscIsTakenOutWithItsPlaceItsPowerAndItsRadius) {
    const glm::vec3 towards = glm::normalize(glm::vec3(-1.0f, 0.6f, 0.05f));  // across the seam
    constexpr float kRadius = 0.05f;
    const RadianceMap map = sky_with_disc(towards, kRadius, 1000.0f);
    const MapWithoutSuns parted = take_out_suns(map);
    ASSERT_EQ(parted.suns.size(), 1u);
    const EnvironmentSun& sun = parted.suns.front();
    EXPECT_GT(glm::dot(sun.towards_map, towards), 0.99999f);
    EXPECT_NEAR(sun.radius_radians, kRadius, 0.1f * kRadius);
    const glm::dvec3 all = power_of(map);
    const glm::dvec3 rest = power_of(parted.rest);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR((double{sun.irradiance_linear[c]} + rest[c]) / all[c], 1.0, 1e-4) << c;
    for (const glm::vec3& texel : parted.rest.texels) ASSERT_NEAR(texel.x, 0.5f, 1e-4f);
}

TEST(EnvironmentSuns, SoftBoxesAndPlainSkiesStayInTheMap) {
    EXPECT_TRUE(take_out_suns(sky_with_disc({0, 1, 0}, 0.5f, 1000.0f)).suns.empty());
    EXPECT_TRUE(take_out_suns(sky_with_disc({0, 1, 0}, 0.05f, 5.0f)).suns.empty());
    const RadianceMap black{8, 4, std::vector<glm::vec3>(32, glm::vec3(0.0f))};
    EXPECT_TRUE(take_out_suns(black).suns.empty());
}

TEST(EnvironmentSuns, OnlyTheStrongestAreTakenOut) {
    RadianceMap map{kSkyWidth, kSkyWidth / 2, {}};
    map.texels.assign(static_cast<std::size_t>(kSkyWidth) * kSkyWidth / 2, glm::vec3(0.1f));
    for (int i = 0; i < 6; ++i)
        map.texels[std::size_t{kSkyWidth} * 100 + 40 + 60 * static_cast<std::size_t>(i)] =
            glm::vec3(20000.0f + 1000.0f * static_cast<float>(i));
    const MapWithoutSuns parted = take_out_suns(map);
    ASSERT_EQ(parted.suns.size(), kMostSuns);
    for (std::size_t i = 1; i < parted.suns.size(); ++i)
        EXPECT_GT(parted.suns[i - 1].irradiance_linear.x, parted.suns[i].irradiance_linear.x);
    EXPECT_EQ(parted.rest.texels[kSkyWidth * 100 + 40].x, 20000.0f);
}

}  // namespace
}  // namespace patina::render
