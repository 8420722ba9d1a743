// SPDX-License-Identifier: MIT
#pragma once

/// A clear sky with its sun at any height: what the built-in environment "sky" shows. Luminance by
/// CIE S 011/E:2003, type 12; the air that the sun is seen through by Kasten and Young, 1989,
/// equation 3; colours are Patina's own.

#include <glm/glm.hpp>

namespace patina::render {

class ClearSky {
  public:
    /// @param sun_elevation_degrees  above the horizon, 0 to 90
    explicit ClearSky(float sun_elevation_degrees);

    /// Linear radiance from a direction, which is a unit vector with +Y up. The sun stands at a yaw
    /// of -40 degrees from +Z towards +X, a disc of 0.021 radians, four and a half times the real
    /// one's, and of its irradiance: some 4 on a facing surface where it stands as high as by
    /// default.
    glm::vec3 radiance(const glm::vec3& direction) const;

  private:
    glm::vec3 sun_;           ///< where it stands
    glm::vec3 sun_radiance_;  ///< of the disc
    glm::vec3 warmth_;        ///< colour of the sky near the sun, over that by default
    glm::vec3 ground_;        ///< radiance of what lies below
    float strength_;          ///< of the sky without the disc, over that by default
};

}  // namespace patina::render
