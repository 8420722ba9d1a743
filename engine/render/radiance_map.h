// SPDX-License-Identifier: MIT
#pragma once

/// Equirectangular maps of linear radiance in 32-bit floats, as the filters read them. See
/// environment.h for the orientation.

#include <glm/glm.hpp>
#include <vector>

#include "core/result.h"
#include "scene/image.h"

namespace patina::render {

/// Row 0 at the top (+Y); finite, not negative.
struct RadianceMap {
    int width = 0;
    int height = 0;
    std::vector<glm::vec3> texels;
    const glm::vec3& at(int x, int y) const {
        return texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
};

/// Reads 1 to 4 channels; U8 and U16 are decoded from sRGB. What is not finite, or negative, is 0.
Result<RadianceMap> radiance_map(const Image& equirect);

/// Half of the width and height (at least 1): each texel is the mean of those it stands for,
/// weighted by solid angle, so the sum over the sphere is kept.
RadianceMap halved(const RadianceMap& map);
/// The map halved until it is at most `width` wide.
RadianceMap reduced_to_width(RadianceMap map, int width);

/// The direction of a point of the map, u and v in 0..1.
glm::vec3 direction_at(float u, float v);
/// The direction of the middle of a texel, unit.
glm::vec3 texel_direction(const RadianceMap& map, int x, int y);
/// Radiance from a unit direction of the map, bilinear between texels.
glm::vec3 radiance_from(const RadianceMap& map, const glm::vec3& direction_map);
/// Steradians that a texel of row `y` covers.
float texel_solid_angle(const RadianceMap& map, int y);
/// Steradians that one at the horizon covers of a map of that size; elsewhere times the cosine of
/// the elevation.
float texel_solid_angle_at_horizon(int width, int height);

/// Of linear Rec. 709; formulae::luminance of a vector.
float luminance_of(const glm::vec3& linear);

}  // namespace patina::render
