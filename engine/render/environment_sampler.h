// SPDX-License-Identifier: MIT
#pragma once

/// Directions of an environment, drawn as often as they are bright: what lights a converging still.
/// A map is read between its texels, and drawn so too: the light of a small sun reaches a texel
/// beyond it, where draws by texels alone would hardly ever look.

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "render/radiance_map.h"

namespace patina::render {

/// A direction of the map as a light.
struct EnvironmentSample {
    glm::vec3 towards;          ///< unit, in the directions of the map
    glm::vec3 radiance_linear;  ///< from there
    float density = 0.0f;       ///< of the drawing, per steradian; above 0
};

class EnvironmentSampler {
  public:
    explicit EnvironmentSampler(std::shared_ptr<const RadianceMap> map);

    /// False for a black map: nothing can be drawn.
    bool has_light() const { return total_luminance_ > 0.0; }
    /// The integral of luminance over the sphere. The density of a direction is its luminance
    /// divided by this, but for how much a texel shrinks from one row to the next.
    double total_luminance() const { return total_luminance_; }
    /// For u of the unit square, 1 excluded: points that are spread well there are spread well
    /// over the light. By rows, then along the row (M. Pharr and others, "Physically Based
    /// Rendering", section "Sampling of Infinite Area Lights"), then up to a texel aside, as often
    /// as the texel has a share in what is read there.
    EnvironmentSample sample(const glm::vec2& u) const;

  private:
    /// Of drawing the direction at a place of the map, in texels.
    float density_at(const glm::vec2& texel) const;

    std::shared_ptr<const RadianceMap> map_;
    std::vector<float> rows_;     ///< the share of light above the end of each row
    std::vector<float> columns_;  ///< of each row: the share at the left of the end of each texel
    double total_luminance_ = 0.0;
};

/// A map ready to be drawn from and to be uploaded.
struct EnvironmentSampling {
    std::shared_ptr<const EnvironmentSampler> sampler;
    int width = 0;
    int height = 0;
    float scale = 1.0f;  ///< of what `levels` hold to radiance: it brings them into half floats
    /// RGBA halves of the map and of its halves down to one texel, as RadianceMap has its rows.
    std::vector<std::vector<std::uint16_t>> levels;
};
/// Takes some 50 ms for the largest map: for a worker. Any thread.
std::shared_ptr<const EnvironmentSampling> environment_sampling(
    std::shared_ptr<const RadianceMap> map);

/// Point i of a sequence in the unit square of which every 2^k points are spread evenly, each run
/// of them one to a strip: a (0, 2) sequence. I. M. Sobol, 1967.
glm::vec2 sobol_point(std::uint32_t i);

}  // namespace patina::render
