// SPDX-License-Identifier: MIT
#include "render/sky_light.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "render/environment.h"

namespace patina::render {
namespace {

bool is_of_a_sun(const glm::vec3& direction, const std::vector<EnvironmentSun>& suns) {
    return std::any_of(suns.begin(), suns.end(), [&](const EnvironmentSun& sun) {
        return glm::dot(direction, sun.towards_map) > std::cos(kSunReach * sun.radius_radians);
    });
}

/// The sum of luminance over the texels of a row, by azimuth.
std::array<double, kSkyAzimuths> row_light(const RadianceMap& map, int y,
                                           const std::vector<EnvironmentSun>& suns) {
    std::array<double, kSkyAzimuths> light = {};
    for (int x = 0; x < map.width; ++x) {
        if (!suns.empty() && is_of_a_sun(texel_direction(map, x, y), suns)) continue;
        const auto azimuth = static_cast<std::size_t>((2 * x + 1) * kSkyAzimuths / (2 * map.width));
        light[azimuth] += luminance_of(map.at(x, y));
    }
    return light;
}

}  // namespace

SkyShares even_sky() {
    SkyShares shares;
    for (auto& bands : shares) bands.fill(1.0f / (kSkyAzimuths * kSkyBands));
    return shares;
}

SkyShares sky_shares(const RadianceMap& map, const std::vector<EnvironmentSun>& suns) {
    std::array<std::array<double, kSkyBands>, kSkyAzimuths> light = {};
    double total = 0.0;
    for (int y = 0; 2 * y < map.height; ++y) {
        const double upper = std::cos(glm::pi<double>() * y / map.height);
        const double lower =
            std::cos(std::min(glm::pi<double>() * (y + 1) / map.height, glm::half_pi<double>()));
        const auto row = row_light(map, y, suns);
        for (std::size_t band = 0; band < kSkyBands; ++band) {
            const double first = static_cast<double>(band) / kSkyBands;
            const double share =
                std::min(upper * upper, first + 1.0 / kSkyBands) - std::max(lower * lower, first);
            if (share <= 0.0) continue;
            for (std::size_t azimuth = 0; azimuth < kSkyAzimuths; ++azimuth) {
                light[azimuth][band] += share * row[azimuth];
                total += share * row[azimuth];
            }
        }
    }
    if (total <= 0.0) return even_sky();
    SkyShares shares;
    for (std::size_t azimuth = 0; azimuth < kSkyAzimuths; ++azimuth)
        for (std::size_t band = 0; band < kSkyBands; ++band)
            shares[azimuth][band] = static_cast<float>(light[azimuth][band] / total);
    return shares;
}

}  // namespace patina::render
