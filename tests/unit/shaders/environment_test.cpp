// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "core/formulae/formulae.h"

namespace patina {
namespace {

using formulae::Real2;
using formulae::Real3;
using formulae::Sh9;

constexpr double kPi = 3.14159265358979323846;

TEST(Environment, TheCentreOfAnEquirectLooksAlongXAndTheTopRowUp) {
    const Real2 centre = formulae::equirect_uv({1.0f, 0.0f, 0.0f});
    EXPECT_NEAR(centre.x, 0.5f, 1e-6f);
    EXPECT_NEAR(centre.y, 0.5f, 1e-6f);
    EXPECT_NEAR(formulae::equirect_uv({0.0f, 1.0f, 0.0f}).y, 0.0f, 1e-6f);
    EXPECT_NEAR(formulae::equirect_uv({0.0f, 0.0f, 1.0f}).x, 0.75f, 1e-6f);
    EXPECT_NEAR(formulae::equirect_uv({0.0f, 0.0f, -1.0f}).x, 0.25f, 1e-6f);
}

TEST(Environment, DirectionsAndEquirectCoordinatesAreInverse) {
    for (int y = 1; y < 32; ++y)
        for (int x = 0; x < 64; ++x) {
            const Real2 uv((static_cast<float>(x) + 0.5f) / 64.0f, static_cast<float>(y) / 32.0f);
            const Real3 direction = formulae::equirect_direction(uv);
            EXPECT_NEAR(formulae::length(direction), 1.0f, 1e-6f);
            const Real2 back = formulae::equirect_uv(direction);
            EXPECT_NEAR(back.x, uv.x, 2e-6f);
            EXPECT_NEAR(back.y, uv.y, 2e-6f);
        }
}

TEST(Environment, CubeFacesFollowOpenGl) {
    // OpenGL 4.1, table 3.19: for each face the major axis and what s and t read of the direction.
    for (int face = 0; face < 6; ++face) {
        const float s = 0.25f, t = -0.5f;
        const Real3 d = formulae::cube_direction(face, s, t);
        const float axis[6] = {d.x, -d.x, d.y, -d.y, d.z, -d.z};
        const float s_of[6] = {-d.z, d.z, d.x, d.x, d.x, -d.x};
        const float t_of[6] = {-d.y, -d.y, d.z, -d.z, -d.y, -d.y};
        EXPECT_EQ(axis[face], 1.0f);
        EXPECT_EQ(s_of[face], s);
        EXPECT_EQ(t_of[face], t);
    }
}

/// Sums `f(direction, solid angle)` over the texels of a cube.
template <typename Function>
void for_each_cube_texel(int size, const Function& f) {
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const float s =
                    2.0f * (static_cast<float>(x) + 0.5f) / static_cast<float>(size) - 1.0f;
                const float t =
                    2.0f * (static_cast<float>(y) + 0.5f) / static_cast<float>(size) - 1.0f;
                f(formulae::normalize(formulae::cube_direction(face, s, t)),
                  double{formulae::cube_texel_solid_angle(s, t, static_cast<float>(size))});
            }
}

TEST(Environment, TheTexelsOfACubeCoverTheSphere) {
    double total = 0;
    for_each_cube_texel(64, [&](const Real3&, double solid_angle) { total += solid_angle; });
    EXPECT_NEAR(total, 4 * kPi, 2e-3);
}

TEST(Environment, TheHarmonicsAreOrthonormal) {
    double products[9][9] = {};
    for_each_cube_texel(48, [&](const Real3& direction, double solid_angle) {
        const Sh9 basis = formulae::sh9_basis(direction);
        for (int i = 0; i < 9; ++i)
            for (int k = 0; k < 9; ++k)
                products[i][k] += double{basis.value[i]} * basis.value[k] * solid_angle;
    });
    for (int i = 0; i < 9; ++i)
        for (int k = 0; k < 9; ++k) EXPECT_NEAR(products[i][k], i == k ? 1.0 : 0.0, 2e-3);
}

/// Radiance, a function of direction, projected onto the basis.
template <typename Radiance>
Sh9 projected(const Radiance& radiance) {
    double sums[9] = {};
    for_each_cube_texel(48, [&](const Real3& direction, double solid_angle) {
        const Sh9 basis = formulae::sh9_basis(direction);
        for (int i = 0; i < 9; ++i)
            sums[i] += double{basis.value[i]} * radiance(direction) * solid_angle;
    });
    Sh9 result;
    for (int i = 0; i < 9; ++i) result.value[i] = static_cast<float>(sums[i]);
    return result;
}

TEST(Environment, UniformLightGivesItselfAsIrradiance) {
    const Sh9 radiance = projected([](const Real3&) { return 2.5f; });
    for (const Real3& normal : {Real3(0.0f, 1.0f, 0.0f), Real3(0.6f, 0.0f, -0.8f)})
        EXPECT_NEAR(formulae::sh9_irradiance_over_pi(radiance, formulae::sh9_basis(normal)), 2.5f,
                    5e-3f);
}

TEST(Environment, IrradianceOfASmoothSkyIsItsConvolutionWithACosine) {
    const auto sky = [](const Real3& d) { return 1.0f + 0.5f * d.y + 0.3f * d.x * d.z; };
    const Sh9 radiance = projected(sky);
    const Real3 normal = formulae::normalize({0.5f, 0.7f, -0.3f});
    double expected = 0;
    for_each_cube_texel(96, [&](const Real3& d, double solid_angle) {
        expected += sky(d) * std::max(0.0f, formulae::dot(d, normal)) * solid_angle / kPi;
    });
    EXPECT_NEAR(formulae::sh9_irradiance_over_pi(radiance, formulae::sh9_basis(normal)), expected,
                2e-3);
}

/// A texel of the split sum's table.
Real2 table_entry(float n_dot_v, float roughness) {
    Real2 sum(0.0f, 0.0f);
    const formulae::uint count = 1024;
    for (formulae::uint i = 0; i < count; ++i) {
        const formulae::SplitSumSample sample = formulae::split_sum_sample(
            {}, formulae::hammersley(i, count), n_dot_v, formulae::alpha_from_roughness(roughness));
        sum = sum + Real2(sample.scale, sample.bias);
    }
    return sum * (1.0f / static_cast<float>(count));
}

TEST(Environment, TheSplitSumOfASmoothSurfaceIsItsFresnelTerm) {
    for (const float n_dot_v : {0.2f, 0.5f, 1.0f}) {
        const Real2 entry = table_entry(n_dot_v, 0.05f);
        const double grazing = std::pow(1 - double{n_dot_v}, 5);
        EXPECT_NEAR(entry.x, 1 - grazing, 5e-3);
        EXPECT_NEAR(entry.y, grazing, 5e-3);
    }
}

TEST(Environment, TheSplitSumIsTheIntegralOfTheBrdf) {
    // By a grid over directions instead of samples of the distribution.
    const float roughness = 0.7f, n_dot_v = 0.6f;
    const Real3 n(0.0f, 0.0f, 1.0f), v(std::sqrt(1 - n_dot_v * n_dot_v), 0.0f, n_dot_v);
    const formulae::BrdfTerms terms = {formulae::DISTRIBUTION_GGX,
                                       formulae::GEOMETRY_SMITH_SEPARABLE,
                                       formulae::FRESNEL_SCHLICK, formulae::DIFFUSE_LAMBERT};
    double albedo = 0;
    const int steps = 500;
    for (int i = 0; i < steps; ++i)
        for (int k = 0; k < steps; ++k) {
            const double polar = (i + 0.5) * kPi / 2 / steps, azimuth = (k + 0.5) * 2 * kPi / steps;
            const Real3 l(static_cast<float>(std::sin(polar) * std::cos(azimuth)),
                          static_cast<float>(std::sin(polar) * std::sin(azimuth)),
                          static_cast<float>(std::cos(polar)));
            const auto angles = formulae::reflection_angles(n, v, l);
            albedo += formulae::brdf_specular(terms, angles, Real3(0.3f), 1.0f, roughness).x *
                      angles.n_dot_l * std::sin(polar) * (kPi / 2 / steps) * (2 * kPi / steps);
        }
    const Real2 entry = table_entry(n_dot_v, roughness);
    EXPECT_NEAR(0.3 * entry.x + entry.y, albedo, 2e-3);
}

}  // namespace
}  // namespace patina
