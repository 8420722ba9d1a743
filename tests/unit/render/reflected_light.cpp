// SPDX-License-Identifier: MIT
#include "render/reflected_light.h"

#include <cmath>

#include "core/formulae/formulae.h"
#include "shaders/vectors.h"

namespace patina::render {
namespace {

constexpr float kDielectricF0 = 0.04f;
constexpr formulae::BrdfTerms kTerms = {formulae::DISTRIBUTION_GGX,
                                        formulae::GEOMETRY_SMITH_SEPARABLE,
                                        formulae::FRESNEL_SCHLICK, formulae::DIFFUSE_LAMBERT};

struct Terms {
    formulae::Real3 diffuse;
    formulae::Real3 dielectric_f0;
    formulae::Real3 f0;
};

Terms terms_of(const ReflectingMaterial& m) {
    const formulae::Real3 base = real3(m.base_color_linear);
    const formulae::Real3 dielectric(kDielectricF0);
    return {formulae::diffuse_color(base, m.metalness), dielectric,
            formulae::material_f0(dielectric, base, m.metalness)};
}

}  // namespace

ReflectedLight::ReflectedLight(const RadianceMap& map) : map_(map) {
    texels_.reserve(map.texels.size());
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x) {
            const double solid_angle = texel_solid_angle(map, y);
            texels_.push_back(
                {texel_direction(map, x, y), solid_angle * glm::dvec3(map.at(x, y)), x, y});
        }
}

template <typename Reflected>
glm::dvec3 ReflectedLight::summed_within(const Texel& texel, const Reflected& reflected) const {
    constexpr int kSide = 6;
    glm::dvec3 sum(0.0);
    for (int j = 0; j < kSide; ++j)
        for (int i = 0; i < kSide; ++i) {
            const float x = static_cast<float>(texel.x) + (static_cast<float>(i) + 0.5f) / kSide;
            const float y = static_cast<float>(texel.y) + (static_cast<float>(j) + 0.5f) / kSide;
            const glm::vec3 l = direction_at(x / static_cast<float>(map_.width),
                                             y / static_cast<float>(map_.height));
            sum += glm::dvec3(radiance_from(map_, l)) * reflected(l);
        }
    return sum * (double{texel_solid_angle(map_, texel.y)} / (kSide * kSide));
}

glm::dvec3 ReflectedLight::mirrored(const glm::vec3& n, const glm::vec3& v,
                                    const ReflectingMaterial& material) const {
    const Terms terms = terms_of(material);
    const formulae::Real3 f =
        formulae::fresnel(kTerms.fresnel, std::max(glm::dot(n, v), 0.0f), terms.f0, 1.0f);
    return dvec3(f) * glm::dvec3(radiance_from(map_, glm::reflect(-v, n)));
}

glm::dvec3 ReflectedLight::summed(const glm::vec3& n, const glm::vec3& v,
                                  const ReflectingMaterial& material) const {
    const Terms terms = terms_of(material);
    const auto reflected = [&](const glm::vec3& l) {
        const formulae::ReflectionAngles angles =
            formulae::reflection_angles(real3(n), real3(v), real3(l));
        formulae::Real3 brdf = formulae::brdf_diffuse(
            kTerms, angles, terms.diffuse, terms.dielectric_f0, 1.0f, material.roughness);
        if (!material.is_smooth())
            brdf =
                brdf + formulae::brdf_specular(kTerms, angles, terms.f0, 1.0f, material.roughness);
        return dvec3(brdf) * double{angles.n_dot_l};
    };
    // A lobe that is not much wider than a texel is summed between texels too.
    const bool narrow = material.roughness < 0.3f && !material.is_smooth();
    const float near = narrow ? 0.9f : 2.0f;
    const glm::vec3 r = glm::reflect(-v, n);
    glm::dvec3 sum(0.0);
    for (const Texel& texel : texels_) {
        if (glm::dot(texel.direction, r) > near)
            sum += summed_within(texel, reflected);
        else if (glm::dot(texel.direction, n) > 0.0f)
            sum += texel.power * reflected(texel.direction);
    }
    return sum;
}

void RelativeError::add(const glm::dvec3& seen, const glm::dvec3& truth) {
    constexpr double kBrightest = 8.0;
    for (int c = 0; c < 3; ++c) {
        const double x = std::min(seen[c], kBrightest);
        const double t = std::min(truth[c], kBrightest);
        sum_ += (x - t) * (x - t) / (t * t + 0.01);
        count_ += 1.0;
    }
}

double RelativeError::value() const {
    return std::sqrt(sum_ / count_);
}

}  // namespace patina::render
