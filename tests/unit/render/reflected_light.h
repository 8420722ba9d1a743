// SPDX-License-Identifier: MIT
#pragma once

/// What the renderer's pictures stand for: the integral of glTF 2.0's BRDF (Appendix B) over an
/// environment, summed over its texels in double precision. Slow, plain, and written apart from the
/// renderer; the terms themselves are the shared formulae.

#include <glm/glm.hpp>
#include <vector>

#include "render/radiance_map.h"

namespace patina::render {

struct ReflectingMaterial {
    glm::vec3 base_color_linear = glm::vec3(1.0f);
    float metalness = 0.0f;  ///< 0 to 1
    float roughness = 0.0f;  ///< 0 to 1
    bool is_smooth() const { return roughness < 0.08f; }
};

/// An environment as what its texels send out. The map must outlive it.
class ReflectedLight {
  public:
    explicit ReflectedLight(const RadianceMap& map);
    /// Radiance towards v of a surface with normal n, both unit, in the world: all of it for a
    /// rough surface, what a smooth one scatters.
    glm::dvec3 summed(const glm::vec3& n, const glm::vec3& v,
                      const ReflectingMaterial& material) const;
    /// What a smooth surface mirrors: its lobe is narrower than a texel, so the map is read.
    glm::dvec3 mirrored(const glm::vec3& n, const glm::vec3& v,
                        const ReflectingMaterial& material) const;

  private:
    struct Texel {
        glm::vec3 direction;
        glm::dvec3 power;  ///< radiance x solid angle
        int x;
        int y;
    };
    /// As the sum over points within a texel, radiance between texels.
    template <typename Reflected>
    glm::dvec3 summed_within(const Texel& texel, const Reflected& reflected) const;

    const RadianceMap& map_;
    std::vector<Texel> texels_;
};

/// How far a picture is from the truth: sqrt(mean((x - t)^2 / (t^2 + 0.01))) over all channels, of
/// radiance clamped to 8.
class RelativeError {
  public:
    void add(const glm::dvec3& seen, const glm::dvec3& truth);
    double value() const;

  private:
    double sum_ = 0.0;
    double count_ = 0.0;
};

}  // namespace patina::render
