// SPDX-License-Identifier: MIT
#pragma once

/// How a surface is lit, as values: the shading model, the terms of the physically based one and
/// the settings of the traditional ones. The formulae stand in shaders/shared/brdf.glsl and
/// phong.glsl. Enumerators have the numbers that the shaders compare with.

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <string_view>

namespace patina::render {

enum class ShadingModel { Pbr, Phong, BlinnPhong };

enum class DistributionTerm { Ggx, Beckmann, BlinnPhong };
enum class GeometryTerm { SmithSeparable, SmithCorrelated, SchlickGgx, Lecture };
enum class FresnelTerm { Schlick, SphericalGaussian };
enum class DiffuseTerm { Lambert, Burley, OrenNayar, Lecture };

/// A name for people, menus and the command line.
template <typename Enum>
struct Choice {
    Enum value;
    std::string_view id;
    std::string_view label;
    std::string_view tooltip;
};

inline constexpr std::array<Choice<ShadingModel>, 3> kShadingModels = {{
    {ShadingModel::Pbr, "pbr", "PBR", "Physically based, as glTF 2.0 Appendix B states it"},
    {ShadingModel::Phong, "phong", "Phong",
     "Ambient, diffuse and the mirrored light to a power; exponent from roughness"},
    {ShadingModel::BlinnPhong, "blinn-phong", "Blinn-Phong",
     "Ambient, diffuse and the half vector to a power; exponent from roughness"},
}};
inline constexpr std::array<Choice<DistributionTerm>, 3> kDistributionTerms = {{
    {DistributionTerm::Ggx, "ggx", "GGX", "Trowbridge-Reitz: a long tail; the glTF default"},
    {DistributionTerm::Beckmann, "beckmann", "Beckmann", "Gaussian slopes: a short tail"},
    {DistributionTerm::BlinnPhong, "blinn-phong", "Blinn-Phong", "A normalised cosine power"},
}};
inline constexpr std::array<Choice<GeometryTerm>, 4> kGeometryTerms = {{
    {GeometryTerm::SmithSeparable, "smith", "Smith", "Separable form, glTF B.3.2; the default"},
    {GeometryTerm::SmithCorrelated, "smith-correlated", "Smith, correlated",
     "Height-correlated, as the Khronos viewer and three.js"},
    {GeometryTerm::SchlickGgx, "schlick-ggx", "Schlick-GGX", "Schlick's rational approximation"},
    {GeometryTerm::Lecture, "lecture", "Lecture", "Smith with roughness in place of its square"},
}};
inline constexpr std::array<Choice<FresnelTerm>, 2> kFresnelTerms = {{
    {FresnelTerm::Schlick, "schlick", "Schlick", "The fifth power of 1 - v.h; the glTF default"},
    {FresnelTerm::SphericalGaussian, "spherical-gaussian", "Spherical Gaussian",
     "Schlick's curve as a power of two"},
}};
inline constexpr std::array<Choice<DiffuseTerm>, 4> kDiffuseTerms = {{
    {DiffuseTerm::Lambert, "lambert", "Lambert", "The same in all directions; the glTF default"},
    {DiffuseTerm::Burley, "burley", "Burley", "Brighter towards the edge of rough surfaces"},
    {DiffuseTerm::OrenNayar, "oren-nayar", "Oren-Nayar", "Flatter on rough surfaces, as clay"},
    {DiffuseTerm::Lecture, "lecture", "Lecture",
     "max(n.l, 0) without 1/pi and without energy balance"},
}};

struct PbrTerms {
    DistributionTerm distribution = DistributionTerm::Ggx;
    GeometryTerm geometry = GeometryTerm::SmithSeparable;
    FresnelTerm fresnel = FresnelTerm::Schlick;
    DiffuseTerm diffuse = DiffuseTerm::Lambert;
    bool multiple_scattering = false;  ///< gives back the energy that single scattering loses
    bool operator==(const PbrTerms&) const = default;
};
/// The lecture's set as one choice. It lacks 1/pi and energy balance.
inline constexpr PbrTerms kLectureTerms = {
    .geometry = GeometryTerm::Lecture,
    .diffuse = DiffuseTerm::Lecture,
};

/// What Phong and Blinn-Phong do not take from the material. Unset: by the stated conversion
/// (shaders/shared/phong.glsl).
struct PhongSettings {
    std::optional<float> exponent;                   ///< kLeastPhongExponent to kMostPhongExponent
    std::optional<glm::vec3> specular_color_linear;  ///< 0 to 1
    std::optional<glm::vec3> ambient_linear;  ///< irradiance / pi; else the environment's mean
    float specular_strength = 1.0f;  ///< times the specular colour, 0 to kMostPhongStrength
    bool operator==(const PhongSettings&) const = default;
};
inline constexpr float kLeastPhongExponent = 1.0f;
inline constexpr float kMostPhongExponent = 10000.0f;
inline constexpr float kMostPhongStrength = 4.0f;

/// How a side gets its picture. The shading is the same; what they cost is not.
enum class RenderPath {
    Deferred,  ///< surfaces are written to the G-buffer, and each pixel is lit once
    Forward,   ///< each fragment is lit as it is drawn
};
inline constexpr std::array<Choice<RenderPath>, 2> kRenderPaths = {{
    {RenderPath::Deferred, "deferred", "Deferred",
     "By way of the G-buffer: each pixel is lit once"},
    {RenderPath::Forward, "forward", "Forward",
     "Without a G-buffer: each fragment is lit as drawn"},
}};

struct Shading {
    ShadingModel model = ShadingModel::Pbr;
    RenderPath path = RenderPath::Deferred;
    PbrTerms terms = {};
    PhongSettings phong = {};
    bool operator==(const Shading&) const = default;
};

/// As people read it, such as "Blinn-Phong".
constexpr std::string_view label_of(const Shading& shading) {
    return kShadingModels[static_cast<std::size_t>(shading.model)].label;
}

}  // namespace patina::render
