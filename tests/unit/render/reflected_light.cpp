// SPDX-License-Identifier: MIT
#include "render/reflected_light.h"

#include <cmath>

#include "core/formulae/formulae.h"

namespace patina::render {
namespace {

constexpr float kDielectricF0 = 0.04f;
constexpr formulae::BrdfTerms kTerms = {formulae::DISTRIBUTION_GGX,
                                        formulae::GEOMETRY_SMITH_SEPARABLE,
                                        formulae::FRESNEL_SCHLICK, formulae::DIFFUSE_LAMBERT};

formulae::Real3 real3(const glm::vec3& v) {
    return {v.x, v.y, v.z};
}

glm::dvec3 dvec3(const formulae::Real3& v) {
    return {v.x, v.y, v.z};
}

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
        for (int x = 0; x < map.width; ++x)
            texels_.push_back(
                {direction_at((static_cast<float>(x) + 0.5f) / static_cast<float>(map.width),
                              (static_cast<float>(y) + 0.5f) / static_cast<float>(map.height)),
                 double{texel_solid_angle(map, y)} * glm::dvec3(map.at(x, y))});
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
    glm::dvec3 sum(0.0);
    for (const Texel& texel : texels_) {
        if (glm::dot(texel.direction, n) <= 0.0f) continue;
        const formulae::ReflectionAngles angles =
            formulae::reflection_angles(real3(n), real3(v), real3(texel.direction));
        formulae::Real3 brdf = formulae::brdf_diffuse(
            kTerms, angles, terms.diffuse, terms.dielectric_f0, 1.0f, material.roughness);
        if (!material.is_smooth())
            brdf =
                brdf + formulae::brdf_specular(kTerms, angles, terms.f0, 1.0f, material.roughness);
        sum += texel.power * dvec3(brdf) * double{angles.n_dot_l};
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
