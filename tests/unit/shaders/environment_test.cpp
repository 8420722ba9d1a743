// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "core/formulae/formulae.h"
#include "shaders/vectors.h"

namespace patina {
namespace {

using formulae::Real2;
using formulae::Real3;

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
    // OpenGL 4.1, "Cube Map Texture Selection": for each face the major axis and what s and t read
    // of the direction.
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

TEST(Environment, TheTexelsOfACubeCoverTheSphere) {
    const int size = 64;
    double face = 0;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const float s = 2.0f * (static_cast<float>(x) + 0.5f) / size - 1.0f;
            const float t = 2.0f * (static_cast<float>(y) + 0.5f) / size - 1.0f;
            face += double{formulae::cube_texel_solid_angle(s, t, size)};
        }
    EXPECT_NEAR(6 * face, 4 * kPi, 2e-3);
}

TEST(Environment, AFilteredLevelHasTexelsAsLargeAsWhatIsRead) {
    EXPECT_EQ(formulae::filtered_level(0.5f, 0.5f), 0.0f);
    EXPECT_EQ(formulae::filtered_level(0.1f, 0.5f), 0.0f);
    EXPECT_EQ(formulae::filtered_level(8.0f, 0.5f), 2.0f);
}

TEST(Environment, ADiscInALevelIsSpreadLikeTheLobe) {
    // What all directions together show of it is the mean of n.l over the lobe, times its
    // irradiance.
    const float roughness = 0.5f, radius = 0.05f;
    const float alpha =
        formulae::alpha_from_roughness(formulae::roughness_under_disc(roughness, radius));
    double shown = 0, mean = 0;
    const int steps = 4000;
    for (int i = 0; i < steps; ++i) {
        const double polar = (i + 0.5) * kPi / 2 / steps;
        shown += double{formulae::disc_in_level(static_cast<float>(std::cos(polar)), roughness,
                                                radius)} *
                 2 * kPi * std::sin(polar) * kPi / 2 / steps;
        const Real3 h =
            formulae::sample_ggx_half_vector({0.0f, (static_cast<float>(i) + 0.5f) / steps}, alpha);
        mean += std::max(2.0 * h.z * h.z - 1.0, 0.0) / steps;
    }
    EXPECT_NEAR(shown, mean, 2e-3);
    EXPECT_EQ(formulae::disc_in_level(-0.5f, roughness, radius), 0.0f);
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
