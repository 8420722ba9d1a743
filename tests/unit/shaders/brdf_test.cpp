// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/formulae/formulae.h"
#include "shaders/vectors.h"

namespace patina {
namespace {

using formulae::Real2;
using formulae::Real3;

constexpr int kDistributions[] = {formulae::DISTRIBUTION_GGX, formulae::DISTRIBUTION_BECKMANN,
                                  formulae::DISTRIBUTION_BLINN_PHONG};
constexpr int kGeometries[] = {formulae::GEOMETRY_SMITH_SEPARABLE,
                               formulae::GEOMETRY_SMITH_CORRELATED, formulae::GEOMETRY_SCHLICK_GGX,
                               formulae::GEOMETRY_LECTURE};

/// A direction by its angles in a frame whose z is the normal.
Real3 direction(double polar, double azimuth) {
    return {static_cast<float>(std::sin(polar) * std::cos(azimuth)),
            static_cast<float>(std::sin(polar) * std::sin(azimuth)),
            static_cast<float>(std::cos(polar))};
}

/// The integral over the upper hemisphere of f(polar, azimuth) by the midpoint rule.
template <typename Integrand>
double hemisphere_integral(int steps, const Integrand& f) {
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        // Squaring puts more steps towards the normal, where narrow distributions lie.
        const double s0 = (i + 0.5) / steps;
        const double polar = s0 * s0 * kPi / 2, width = s0 * kPi / steps;
        for (int k = 0; k < steps; ++k)
            sum +=
                f(polar, (k + 0.5) * 2 * kPi / steps) * std::sin(polar) * width * 2 * kPi / steps;
    }
    return sum;
}

TEST(Brdf, EveryDistributionOfMicrofacetsProjectsToOne) {
    for (const int term : kDistributions)
        for (const double roughness : {0.2, 0.35, 0.5, 0.7, 0.9, 1.0}) {
            const auto alpha = static_cast<float>(roughness * roughness);
            double sum = 0;
            const int steps = 20000;
            for (int i = 0; i < steps; ++i) {
                const double s = (i + 0.5) / steps, polar = s * s * kPi / 2;
                const auto cosine = static_cast<float>(std::cos(polar));
                sum += formulae::distribution(term, cosine, alpha) * std::cos(polar) *
                       std::sin(polar) * 2 * kPi * (s * kPi / steps);
            }
            EXPECT_NEAR(sum, 1.0, 2e-3) << "distribution " << term << ", roughness " << roughness;
        }
}

TEST(Brdf, DistributionsHaveTheirClosedForms) {
    for (const double alpha : {0.04, 0.25, 0.6, 1.0})
        for (const double c : {0.1, 0.5, 0.9, 1.0}) {
            const auto a = static_cast<float>(alpha), cosine = static_cast<float>(c);
            const double a2 = double{a} * a, c2 = double{cosine} * cosine;
            const double ggx = a2 / (kPi * std::pow(c2 * (a2 - 1) + 1, 2));
            EXPECT_NEAR(formulae::distribution_ggx(cosine, a) / ggx, 1.0, 1e-4);
            const double beckmann = std::exp((c2 - 1) / (a2 * c2)) / (kPi * a2 * c2 * c2);
            if (beckmann > 1e-30) {
                EXPECT_NEAR(formulae::distribution_beckmann(cosine, a) / beckmann, 1.0, 1e-4);
            }
            const double exponent = 2 / a2 - 2;
            const double blinn = (exponent + 2) / (2 * kPi) * std::pow(double{cosine}, exponent);
            if (alpha < 1.0 && blinn > 1e-30) {
                EXPECT_NEAR(formulae::distribution_blinn_phong(cosine, a) / blinn, 1.0, 1e-4);
            }
        }
}

rc::Gen<float> cosines() {
    return rc::gen::map(rc::gen::inRange(1, 1001),
                        [](int value) { return static_cast<float>(value) / 1000.0f; });
}

RC_GTEST_PROP(Brdf, MaskingAndShadowingIsBetweenZeroAndOneAndReciprocal, ()) {
    const float n_dot_l = *cosines(), n_dot_v = *cosines();
    const float alpha = formulae::alpha_from_roughness(*cosines());
    for (const int term : kGeometries) {
        const float v = formulae::visibility(term, n_dot_l, n_dot_v, alpha);
        const float g = 4.0f * n_dot_l * n_dot_v * v;
        RC_ASSERT(g >= 0.0f && g <= 1.0f + 1e-6f);
        const float exchanged = formulae::visibility(term, n_dot_v, n_dot_l, alpha);
        RC_ASSERT(std::abs(exchanged - v) <= 1e-6f * v);
    }
}

RC_GTEST_PROP(Brdf, VisibilitiesHaveTheirClosedForms, ()) {
    const float n_dot_l = *cosines(), n_dot_v = *cosines(), roughness = *cosines();
    const float alpha = formulae::alpha_from_roughness(roughness);
    const auto g1 = [](double c, double a) {
        return 2 * c / (c + std::sqrt(a * a + (1 - a * a) * c * c));
    };
    const auto lambda = [](double c, double a) {
        return (std::sqrt(1 + a * a * (1 - c * c) / (c * c)) - 1) / 2;
    };
    const double to_visibility = 1 / (4.0 * n_dot_l * n_dot_v);
    const auto equal = [](double actual, double expected) {
        return std::abs(actual - expected) <= 2e-5 * std::abs(expected);
    };
    RC_ASSERT(equal(formulae::visibility_smith_separable(n_dot_l, n_dot_v, alpha),
                    g1(n_dot_l, alpha) * g1(n_dot_v, alpha) * to_visibility));
    RC_ASSERT(equal(formulae::visibility_smith_correlated(n_dot_l, n_dot_v, alpha),
                    to_visibility / (1 + lambda(n_dot_l, alpha) + lambda(n_dot_v, alpha))));
    const double r = std::sqrt(double{alpha});
    RC_ASSERT(equal(formulae::visibility_lecture(n_dot_l, n_dot_v, alpha),
                    g1(n_dot_l, r) * g1(n_dot_v, r) * to_visibility));
    const double k = alpha / 2;
    RC_ASSERT(equal(
        formulae::visibility_schlick_ggx(n_dot_l, n_dot_v, alpha),
        n_dot_l / (n_dot_l * (1 - k) + k) * n_dot_v / (n_dot_v * (1 - k) + k) * to_visibility));
}

TEST(Brdf, FresnelGoesFromF0HeadOnToF90AtGrazingAngles) {
    const Real3 f0(0.04f, 0.5f, 0.9f);
    for (const int term : {formulae::FRESNEL_SCHLICK, formulae::FRESNEL_SPHERICAL_GAUSSIAN}) {
        EXPECT_NEAR(formulae::fresnel(term, 1.0f, f0, 1.0f).x, 0.04f, 2e-4f);
        EXPECT_NEAR(formulae::fresnel(term, 0.0f, f0, 0.8f).y, 0.8f, 1e-6f);
        for (int i = 0; i < 100; ++i) {
            const float c = static_cast<float>(i) / 100.0f;
            EXPECT_GE(formulae::fresnel(term, c, f0, 1.0f).x,
                      formulae::fresnel(term, c + 0.01f, f0, 1.0f).x);
            EXPECT_NEAR(formulae::fresnel(term, c, f0, 1.0f).x,
                        0.04 + 0.96 * std::pow(1 - double{c}, 5), 0.01);
        }
    }
}

TEST(Brdf, F0FollowsTheIorAndSpecularExtensions) {
    EXPECT_NEAR(formulae::f0_from_ior(1.5f), 0.04f, 1e-8f);
    EXPECT_EQ(formulae::f0_from_ior(1.0f), 0.0f);
    EXPECT_EQ(formulae::f0_from_ior(0.0f), 1.0f);
    const Real3 tinted = formulae::dielectric_f0(1.5f, 0.5f, {1.0f, 2.0f, 100.0f});
    EXPECT_FLOAT_EQ(tinted.x, 0.02f);
    EXPECT_FLOAT_EQ(tinted.y, 0.04f);
    EXPECT_FLOAT_EQ(tinted.z, 0.5f);  // colour times F0 ends at 1
    const Real3 base(0.9f, 0.6f, 0.3f);
    EXPECT_EQ(formulae::material_f0(tinted, base, 1.0f).y, 0.6f);
    EXPECT_EQ(formulae::material_f0(tinted, base, 0.0f).y, tinted.y);
    const Real3 mixed = formulae::material_f0(tinted, base, 0.75f);
    EXPECT_NEAR(formulae::dielectric_part_f0(mixed, base, 0.75f).z, tinted.z, 1e-6f);
    EXPECT_EQ(formulae::material_f90(0.5f, 1.0f), 1.0f);
    EXPECT_EQ(formulae::diffuse_color(base, 1.0f).x, 0.0f);
}

formulae::BrdfTerms gltf_terms() {
    return {formulae::DISTRIBUTION_GGX, formulae::GEOMETRY_SMITH_SEPARABLE,
            formulae::FRESNEL_SCHLICK, formulae::DIFFUSE_LAMBERT};
}

/// What a surface of white specular sends back of uniform light, seen at a polar angle.
double specular_albedo(const formulae::BrdfTerms& terms, float roughness, double polar_v) {
    const Real3 v = direction(polar_v, 0.0), n(0.0f, 0.0f, 1.0f);
    return hemisphere_integral(150, [&](double polar, double azimuth) {
        const auto angles = formulae::reflection_angles(n, v, direction(polar, azimuth));
        return double{formulae::brdf_specular(terms, angles, Real3(1.0f), 1.0f, roughness).x} *
               angles.n_dot_l;
    });
}

TEST(Brdf, SingleScatteringNeverReflectsMoreThanItReceives) {
    for (const int distribution : kDistributions)
        for (const int geometry : kGeometries) {
            formulae::BrdfTerms terms = gltf_terms();
            terms.distribution = distribution;
            terms.geometry = geometry;
            // Only GGX has the masking that belongs to it; the others may gain a little.
            const bool matched = distribution == formulae::DISTRIBUTION_GGX &&
                                 geometry != formulae::GEOMETRY_SCHLICK_GGX;
            for (const float roughness : {0.5f, 0.75f, 1.0f})
                for (const double polar : {0.1, 0.8, 1.3})
                    EXPECT_LE(specular_albedo(terms, roughness, polar), matched ? 1.001 : 1.1)
                        << distribution << " " << geometry << " " << roughness << " " << polar;
        }
}

TEST(Brdf, MultipleScatteringCompensationReturnsWhatAWhiteMetalLoses) {
    const double albedo = specular_albedo(gltf_terms(), 0.9f, 0.6);
    ASSERT_LT(albedo, 0.9);
    const Real3 scale =
        formulae::multiple_scattering_scale(Real3(1.0f), static_cast<float>(albedo));
    EXPECT_NEAR(scale.x * albedo, 1.0, 1e-5);
    EXPECT_EQ(formulae::multiple_scattering_scale(Real3(0.0f), 0.5f).x, 1.0f);
}

TEST(Brdf, DiffuseTermsReflectAtMostWhatTheyReceiveAndAreReciprocal) {
    const Real3 n(0.0f, 0.0f, 1.0f);
    for (const float roughness : {0.0f, 0.5f, 1.0f})
        for (const int term :
             {formulae::DIFFUSE_LAMBERT, formulae::DIFFUSE_BURLEY, formulae::DIFFUSE_OREN_NAYAR}) {
            formulae::BrdfTerms terms = gltf_terms();
            terms.diffuse = term;
            const auto reflected = [&](const Real3& v, const Real3& l) {
                const auto angles = formulae::reflection_angles(n, v, l);
                return double{
                    formulae::brdf_diffuse(terms, angles, Real3(1.0f), Real3(0.0f), 0.0f, roughness)
                        .x};
            };
            for (const double polar : {0.1, 0.7, 1.2}) {
                const Real3 v = direction(polar, 0.0);
                const double albedo = hemisphere_integral(100, [&](double p, double azimuth) {
                    return reflected(v, direction(p, azimuth)) * std::cos(p);
                });
                // Burley's gains a tenth at grazing angles of rough surfaces: it is not
                // energy-balanced.
                EXPECT_LE(albedo, term == formulae::DIFFUSE_BURLEY ? 1.15 : 1.001)
                    << term << " " << roughness;
                EXPECT_GE(albedo, 0.5) << term << " " << roughness;
                const Real3 l = direction(0.9, 1.0);
                EXPECT_NEAR(reflected(v, l), reflected(l, v), 1e-6);
            }
        }
}

TEST(Brdf, OrenNayarOfASmoothSurfaceIsLambert) {
    EXPECT_FLOAT_EQ(formulae::diffuse_oren_nayar(0.3f, 0.6f, 0.5f, 0.0f), 0.318309886f);
}

TEST(Brdf, TheLectureSetHasNeitherPiNorEnergyBalance) {
    formulae::BrdfTerms terms = {formulae::DISTRIBUTION_GGX, formulae::GEOMETRY_LECTURE,
                                 formulae::FRESNEL_SCHLICK, formulae::DIFFUSE_LECTURE};
    const Real3 n(0.0f, 0.0f, 1.0f), v = direction(0.4, 0.0), l = direction(0.9, 2.0);
    const auto angles = formulae::reflection_angles(n, v, l);
    const float r = 0.6f;
    const double r2 = double{r} * r, r4 = r2 * r2, nh = angles.n_dot_h;
    const double d = r4 / (kPi * std::pow(nh * nh * (r4 - 1) + 1, 2));
    const auto g1 = [&](double c) { return 2 * c / (c + std::sqrt(r2 + (1 - r2) * c * c)); };
    const double f = 0.04 + 0.96 * std::pow(1 - angles.v_dot_h, 5);
    const double expected =
        d * f * g1(angles.n_dot_l) * g1(angles.n_dot_v) / (4.0 * angles.n_dot_l * angles.n_dot_v);
    EXPECT_NEAR(formulae::brdf_specular(terms, angles, Real3(0.04f), 1.0f, r).x, expected,
                1e-5 * expected);
    EXPECT_EQ(formulae::brdf_diffuse(terms, angles, Real3(0.7f), Real3(0.04f), 1.0f, r).x, 0.7f);
    EXPECT_EQ(formulae::ambient_terms(terms).diffuse, formulae::DIFFUSE_LAMBERT);
    EXPECT_EQ(formulae::ambient_terms(terms).geometry, formulae::GEOMETRY_LECTURE);
}

TEST(Brdf, ATintedReflectionKeepsAsMuchOfEveryColourOutOfTheDiffusePart) {
    const formulae::BrdfTerms terms = {formulae::DISTRIBUTION_GGX,
                                       formulae::GEOMETRY_SMITH_CORRELATED,
                                       formulae::FRESNEL_SCHLICK, formulae::DIFFUSE_LAMBERT};
    const auto angles =
        formulae::reflection_angles({0.0f, 0.0f, 1.0f}, direction(0.4, 0.0), direction(0.9, 2.0));
    const Real3 tinted(0.3f, 0.1f, 0.0f);
    const Real3 diffuse = formulae::brdf_diffuse(terms, angles, Real3(1.0f), tinted, 1.0f, 0.5f);
    // 1 - weight x max_value(fr) of the extension, with its fr written out.
    const double reflected = 0.3 + 0.7 * std::pow(1 - angles.v_dot_h, 5);
    for (const float share : {diffuse.x, diffuse.y, diffuse.z})
        EXPECT_NEAR(share * kPi, 1.0 - reflected, 1e-5);
}

TEST(Brdf, NothingIsInfiniteAtGrazingAnglesAndLeastRoughness) {
    const Real3 n(0.0f, 0.0f, 1.0f);
    for (const int distribution : kDistributions)
        for (const int geometry : kGeometries)
            for (const Real3& v : {Real3(0.0f, 0.0f, 1.0f), Real3(1.0f, 0.0f, 0.0f)})
                for (const Real3& l : {Real3(0.0f, 0.0f, 1.0f), Real3(-1.0f, 0.0f, 0.0f),
                                       Real3(0.0f, 0.0f, -1.0f)}) {
                    formulae::BrdfTerms terms = gltf_terms();
                    terms.distribution = distribution;
                    terms.geometry = geometry;
                    const auto angles = formulae::reflection_angles(n, v, l);
                    for (const float roughness : {0.0f, 1.0f}) {
                        const float value =
                            formulae::brdf_specular(terms, angles, Real3(1.0f), 1.0f, roughness).x;
                        EXPECT_TRUE(std::isfinite(value * angles.n_dot_l))
                            << distribution << " " << geometry << " " << roughness;
                    }
                }
}

TEST(Brdf, SampledHalfVectorsHaveTheDensityOfGgx) {
    // Chi-squared over equally likely rings: P(n.h < c) = (1 - c^2) / (1 + (alpha^2 - 1) c^2).
    for (const float alpha : {0.05f, 0.3f, 0.9f}) {
        std::array<int, 16> rings{};
        const formulae::uint count = 4096;
        for (formulae::uint i = 0; i < count; ++i) {
            const Real3 h = formulae::sample_ggx_half_vector(formulae::hammersley(i, count), alpha);
            const double c2 = double{h.z} * h.z, a2 = double{alpha} * alpha;
            const double share = (1 - c2) / (1 + (a2 - 1) * c2);
            ++rings[std::min<std::size_t>(15, static_cast<std::size_t>(share * 16))];
            ASSERT_NEAR(formulae::length(h), 1.0f, 1e-5f);
        }
        for (const int ring : rings) EXPECT_NEAR(ring, count / 16, 12) << alpha;
    }
}

TEST(Brdf, TheMeanOfSchlicksCurveIsTheFittedIntegral) {
    for (const float n_dot_v : {0.0f, 0.1f, 0.35f, 0.6f, 0.85f, 1.0f}) {
        const double sine = std::sqrt(1.0 - double{n_dot_v} * n_dot_v);
        double sum = 0.0;
        const int steps = 300;
        for (int i = 0; i < steps; ++i)
            for (int k = 0; k < steps; ++k) {
                // Points that are even in the square of the cosine are weighted by it.
                const double cosine = std::sqrt((i + 0.5) / steps);
                const double along = std::sqrt(1.0 - cosine * cosine) *
                                     std::cos((k + 0.5) * 3.14159265358979 / steps);
                const double v_dot_l = sine * along + double{n_dot_v} * cosine;
                sum += std::pow(1.0 - std::sqrt(std::max(0.5 + 0.5 * v_dot_l, 0.0)), 5.0);
            }
        EXPECT_NEAR(formulae::schlick_mean(n_dot_v), sum / (steps * steps), 1e-5) << n_dot_v;
    }
}

TEST(Brdf, ADiscWidensAHighlightAndAPointDoesNot) {
    for (const float roughness : {0.1f, 0.5f, 1.0f}) {
        EXPECT_NEAR(formulae::roughness_under_disc(roughness, 0.0f), roughness, 1e-6f);
        EXPECT_GT(formulae::roughness_under_disc(roughness, 0.1f), roughness);
    }
    // A mirror shows the disc: as wide as a lobe of alpha = radius / sqrt(8).
    EXPECT_NEAR(std::pow(formulae::roughness_under_disc(0.0f, 0.4f), 2.0f), 0.4f / std::sqrt(8.0f),
                1e-3f);
}

TEST(Brdf, VisibleHalfVectorsAreDrawnWithTheirStatedDensity) {
    // The mean of f / density over what is drawn is the integral of f, here of a smooth function
    // of l over the whole sphere of l: drawing may send light below the surface.
    const Real3 v = formulae::normalize({0.7f, 0.0f, 0.4f});
    for (const float alpha : {0.09f, 0.36f, 0.9f}) {
        const auto density_of = [&](const Real3& l) {
            const Real3 h = formulae::normalize(v + l);
            return double{formulae::ggx_visible_density(std::max(h.z, 0.0f), v.z, alpha)};
        };
        const auto f = [&](const Real3& l) { return density_of(l) * (1.0 + l.x + l.z * l.z); };
        double drawn = 0.0;
        const formulae::uint count = 16384;
        for (formulae::uint i = 0; i < count; ++i) {
            const Real3 h =
                formulae::sample_ggx_visible_half_vector(formulae::hammersley(i, count), v, alpha);
            EXPECT_GE(formulae::dot(v, h), -1e-5f);
            const Real3 l = h * (2.0f * formulae::dot(v, h)) - v;
            drawn += f(l) / density_of(l) / count;
        }
        double integral = 0.0;
        double total = 0.0;
        const int steps = 1000;
        for (int i = 0; i < steps; ++i)
            for (int k = 0; k < steps; ++k) {
                const double cosine = 1.0 - 2.0 * (i + 0.5) / steps;
                const double sine = std::sqrt(1.0 - cosine * cosine);
                const double azimuth = 2.0 * kPi * (k + 0.5) / steps;
                const Real3 l(static_cast<float>(sine * std::cos(azimuth)),
                              static_cast<float>(sine * std::sin(azimuth)),
                              static_cast<float>(cosine));
                if ((v + l).z <= 0.0f) continue;  // no half vector above the surface
                integral += f(l) * 4.0 * kPi / steps / steps;
                total += density_of(l) * 4.0 * kPi / steps / steps;
            }
        EXPECT_NEAR(total, 1.0, 0.01) << alpha;
        EXPECT_NEAR(drawn, integral, 0.01) << alpha;
    }
}

TEST(ReflectionOcclusion, AnOpenSurfaceMirrorsAllAndAClosedOneNothing) {
    for (const float n_dot_v : {0.0f, 0.3f, 1.0f})
        for (const float alpha : {0.002f, 0.25f, 1.0f}) {
            EXPECT_EQ(formulae::mirrored_share(n_dot_v, 1.0f, alpha), 1.0f);
            EXPECT_NEAR(formulae::mirrored_share(n_dot_v, 0.0f, alpha), 0.0f, 1e-5f);
            float before = 0.0f;
            for (float occlusion = 0.0f; occlusion <= 1.0f; occlusion += 0.0625f) {
                const float share = formulae::mirrored_share(n_dot_v, occlusion, alpha);
                EXPECT_GE(share, before - 1e-5f) << n_dot_v << " " << alpha << " " << occlusion;
                before = share;
            }
        }
}

TEST(ReflectionOcclusion, ARoughSurfaceSeenHeadOnMirrorsAsMuchAsItScatters) {
    // The lobe is as wide as that of diffuse light: the exponent of the sum is nearly 0.
    for (const float occlusion : {0.2f, 0.5f, 0.8f})
        EXPECT_NEAR(formulae::mirrored_share(1.0f, occlusion, 1.0f), occlusion, 1e-4f);
    // A narrow lobe looks out of the crevice.
    EXPECT_GT(formulae::mirrored_share(1.0f, 0.5f, 0.002f), 0.7f);
}

TEST(ReflectionOcclusion, TheHorizonLeavesAllAboveItAndLessAndLessBelow) {
    for (const float above : {0.0f, 0.2f, 1.0f}) EXPECT_EQ(formulae::horizon_share(above), 1.0f);
    EXPECT_LT(formulae::horizon_share(-0.2f), 0.8f);
    EXPECT_LT(formulae::horizon_share(-0.4f), formulae::horizon_share(-0.2f));
    EXPECT_EQ(formulae::horizon_share(-0.8f), 0.0f);
}

}  // namespace
}  // namespace patina
