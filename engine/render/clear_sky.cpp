// SPDX-License-Identifier: MIT
#include "render/clear_sky.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "render/bearing.h"
#include "render/environment.h"

namespace patina::render {
namespace {

/// How much air the sun is seen through, over that at the zenith: Kasten and Young, "Revised
/// optical air mass tables and approximation formula", Applied Optics 28 (1989), equation 3.
float air_mass(float elevation_degrees) {
    return 1.0f / (std::sin(glm::radians(elevation_degrees)) +
                   0.50572f * std::pow(elevation_degrees + 6.07995f, -1.6364f));
}

/// What passes of the sun's light, over what does where it stands by default. Optical depths of
/// clean air with a little haze at some 630, 530 and 460 nm.
glm::vec3 passing(float elevation_degrees) {
    const glm::vec3 depth(0.12f, 0.17f, 0.27f);
    return glm::exp(-depth * (air_mass(elevation_degrees) - air_mass(kSunElevationDegrees)));
}

/// Relative luminance of a clear sky: CIE S 011/E:2003, type 12 (a -1, b -0.32, c 10, d -3,
/// e 0.45), over that of the zenith with the sun there.
float clear_sky_luminance(float cos_zenith, float sun_angle) {
    const float gradation = 1.0f - std::exp(-0.32f / std::max(cos_zenith, 0.03f));
    const float indicatrix =
        1.0f + 10.0f * (std::exp(-3.0f * sun_angle) - std::exp(-1.5f * glm::pi<float>())) +
        0.45f * std::cos(sun_angle) * std::cos(sun_angle);
    return gradation / (1.0f - std::exp(-0.32f)) * indicatrix;
}

}  // namespace

ClearSky::ClearSky(float sun_elevation_degrees) : sun_(bearing(-40.0f, sun_elevation_degrees)) {
    const glm::vec3 through = passing(sun_elevation_degrees);
    const float height = sun_.y / std::sin(glm::radians(kSunElevationDegrees));
    sun_radiance_ = 2900.0f * glm::vec3(1.0f, 0.93f, 0.82f) * through;
    warmth_ = through / std::max({through.x, through.y, through.z});
    // Of the light on the ground by default some three quarters come from the sun. What the sky
    // sends falls with the sun's height, and no longer grows where the sun stands high.
    strength_ = glm::mix(0.15f, 1.0f, std::min(height, 1.0f));
    ground_ =
        glm::vec3(0.17f, 0.155f, 0.13f) * glm::mix(glm::vec3(strength_), through * height, 0.75f);
}

glm::vec3 ClearSky::radiance(const glm::vec3& direction) const {
    if (direction.y < -0.02f) return ground_;
    const float angle = std::acos(std::clamp(glm::dot(direction, sun_), -1.0f, 1.0f));
    const float height = std::max(direction.y, 0.0f);
    glm::vec3 tint = glm::mix(glm::vec3(0.86f, 0.93f, 1.0f), glm::vec3(0.36f, 0.6f, 1.0f),
                              std::pow(height, 0.45f));
    // A low sun reddens the sky about it and, less, all of the horizon.
    const float reddened =
        std::min(1.0f, std::exp(-2.2f * angle) + 0.4f * std::exp(-7.0f * height));
    tint *= glm::mix(glm::vec3(1.0f), warmth_, reddened);
    glm::vec3 radiance = 0.16f * strength_ * clear_sky_luminance(height, angle) * tint;
    const float disc = 1.0f - glm::smoothstep(0.018f, 0.024f, angle);
    radiance += disc * sun_radiance_;
    return glm::mix(ground_, radiance, glm::smoothstep(-0.02f, 0.01f, direction.y));
}

}  // namespace patina::render
