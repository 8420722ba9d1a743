// SPDX-License-Identifier: MIT

/// Lamps that have a size, against sums over the directions towards them in double precision.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/glm.hpp>
#include <random>

#include "core/formulae/formulae.h"
#include "shaders/vectors.h"

namespace patina {
namespace {

using formulae::Real2;
using formulae::Real3;
using formulae::SeenRectangle;

/// The integral of f over the sphere's directions, by rings about its middle.
template <typename Function>
double over_sphere(const glm::dvec3& towards, double sine2, const Function& f) {
    constexpr int kRings = 400, kTurns = 400;
    const glm::dvec3 x = glm::normalize(glm::cross(towards, glm::dvec3(0.31, 0.59, -0.74)));
    const glm::dvec3 y = glm::cross(towards, x);
    const double height = 1.0 - std::sqrt(1.0 - sine2);
    double sum = 0.0;
    for (int i = 0; i < kRings; ++i) {
        const double c = 1.0 - height * (i + 0.5) / kRings;
        const double s = std::sqrt(1.0 - c * c);
        for (int j = 0; j < kTurns; ++j) {
            const double phi = 2.0 * kPi * (j + 0.5) / kTurns;
            sum += f(c * towards + s * (std::cos(phi) * x + std::sin(phi) * y));
        }
    }
    return sum * 2.0 * kPi * height / (kRings * kTurns);
}

/// The integral of f over the directions towards a rectangle, by its area.
template <typename Function>
double over_rectangle(const SeenRectangle& r, const Function& f) {
    constexpr int kSide = 500;
    double sum = 0.0;
    for (int i = 0; i < kSide; ++i)
        for (int j = 0; j < kSide; ++j) {
            const double u = (2.0 * i + 1.0) / kSide - 1.0;
            const double v = (2.0 * j + 1.0) / kSide - 1.0;
            const glm::dvec3 point = dvec3(r.middle) + u * double{r.half_width} * dvec3(r.across) +
                                     v * double{r.half_height} * dvec3(r.up);
            const double distance = glm::length(point);
            const double leaving = -glm::dot(point, dvec3(r.shines)) / distance;
            if (leaving > 0.0) sum += f(point / distance) * leaving / (distance * distance);
        }
    return sum * 4.0 * double{r.half_width} * double{r.half_height} / (kSide * kSide);
}

SeenRectangle rectangle(const glm::dvec3& middle, const glm::dvec3& shines, double turn,
                        double width, double height) {
    const glm::dvec3 z = glm::normalize(shines);
    const glm::dvec3 x = glm::normalize(glm::cross(z, glm::dvec3(0.2, 0.9, 0.1)));
    const glm::dvec3 across = std::cos(turn) * x + std::sin(turn) * glm::cross(z, x);
    SeenRectangle r;
    r.middle = real3(middle);
    r.shines = real3(z);
    r.across = real3(across);
    r.up = real3(glm::cross(z, across));
    r.half_width = static_cast<float>(0.5 * width);
    r.half_height = static_cast<float>(0.5 * height);
    return r;
}

std::vector<SeenRectangle> some_rectangles() {
    return {rectangle({0.0, 0.0, 2.0}, {0.0, 0.0, -1.0}, 0.0, 1.0, 1.0),
            rectangle({0.5, -0.3, 0.7}, {-0.4, 0.5, -1.0}, 0.7, 2.0, 0.5),
            rectangle({0.1, 0.2, 0.3}, {0.0, 0.1, -1.0}, 1.1, 3.0, 2.0),
            rectangle({-2.0, 1.0, 1.5}, {1.0, -1.0, -0.2}, -0.4, 0.4, 1.5),
            rectangle({3.0, 1.0, 4.0}, {-1.0, 0.0, -1.0}, 0.2, 0.3, 0.2)};
}

TEST(AreaLight, ASphereGivesASurfaceTheIntegralOfItsCosineEvenPartlyBelowTheHorizon) {
    for (const double sine2 : {1e-3, 0.04, 0.3, 0.8})
        for (double angle = 0.05; angle < 3.1; angle += 0.31) {
            const glm::dvec3 towards(std::sin(angle), 0.0, std::cos(angle));
            const double expected =
                over_sphere(towards, sine2,
                            [](const glm::dvec3& l) { return std::max(l.z, 0.0); }) /
                kPi;
            const float share = formulae::sphere_share(static_cast<float>(std::cos(angle)),
                                                       static_cast<float>(sine2));
            EXPECT_NEAR(share, expected, 2e-4 * sine2 + 2e-6) << sine2 << " " << angle;
        }
}

TEST(AreaLight, ARectanglesIrradianceVectorIsTheIntegralOfItsDirections) {
    for (const SeenRectangle& r : some_rectangles()) {
        const glm::dvec3 vector = dvec3(formulae::rectangle_irradiance(r));
        for (int c = 0; c < 3; ++c) {
            const double expected =
                over_rectangle(r, [c](const glm::dvec3& l) { return l[c]; }) / kPi;
            EXPECT_NEAR(vector[c], expected, 1e-4);
        }
    }
}

TEST(AreaLight, ARectangleAboveTheHorizonGivesTheIntegralOfItsCosine) {
    const SeenRectangle r = some_rectangles()[0];
    for (const glm::dvec3 n : {glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(0.6, 0.0, 0.8)}) {
        const double expected =
            over_rectangle(r, [n](const glm::dvec3& l) { return std::max(glm::dot(l, n), 0.0); }) /
            kPi;
        EXPECT_NEAR(formulae::share_of_vector(formulae::rectangle_irradiance(r), real3(n)),
                    expected, 2e-5);
    }
}

TEST(AreaLight, ARectanglePartlyBelowTheHorizonIsTakenForASphereWithinATwentieth) {
    for (const SeenRectangle& r : some_rectangles())
        for (double angle = 0.0; angle < 3.1; angle += 0.2) {
            const glm::dvec3 n(std::sin(angle), 0.3, std::cos(angle));
            const glm::dvec3 unit = glm::normalize(n);
            const double expected =
                over_rectangle(
                    r, [unit](const glm::dvec3& l) { return std::max(glm::dot(l, unit), 0.0); }) /
                kPi;
            EXPECT_NEAR(formulae::share_of_vector(formulae::rectangle_irradiance(r), real3(unit)),
                        expected, 0.05);
        }
}

TEST(AreaLight, ARectangleDoesNotShineBackwards) {
    SeenRectangle r = some_rectangles()[1];
    r.shines = -r.shines;
    EXPECT_EQ(formulae::length(formulae::rectangle_irradiance(r)), 0.0f);
    EXPECT_EQ(formulae::rectangle_is_met(formulae::normalize(r.middle), r), 0.0f);
}

TEST(AreaLight, FarAwayASphereAndARectangleAreAsBrightAsAPointOfTheirIntensity) {
    for (const double distance : {3.0, 30.0, 300.0}) {
        // Intensity 1: radiance 1 / (pi r^2), and 1 / (width x height). Irradiance is intensity /
        // distance^2, to the second order of size / distance.
        const double radius = 0.1;
        const auto sine2 = static_cast<float>(radius * radius / (distance * distance));
        const double sphere = double{formulae::sphere_share(1.0f, sine2)} / (radius * radius);
        EXPECT_NEAR(sphere * distance * distance, 1.0, 1e-3);
        const SeenRectangle r = rectangle({0.0, 0.0, distance}, {0.0, 0.0, -1.0}, 0.3, 0.2, 0.1);
        const double flat = kPi * glm::length(dvec3(formulae::rectangle_irradiance(r))) / 0.02;
        EXPECT_NEAR(flat * distance * distance, 1.0, 2e-3);
    }
}

TEST(AreaLight, FromTheirMiddleTheyGiveWhatAPointDoesAndAtMostPi) {
    EXPECT_FLOAT_EQ(formulae::sphere_from_middle(100.0f, 0.1f) / (0.01f * formulae::PI), 0.01f);
    EXPECT_FLOAT_EQ(formulae::rectangle_from_middle(100.0f, 0.02f, 0.5f) / 0.02f, 0.005f);
    EXPECT_FLOAT_EQ(formulae::sphere_from_middle(1e-8f, 0.1f), formulae::PI);
    EXPECT_FLOAT_EQ(formulae::rectangle_from_middle(1e-8f, 0.02f, 1.0f), formulae::PI);
    EXPECT_EQ(formulae::rectangle_from_middle(1.0f, 0.02f, -0.5f), 0.0f);
}

TEST(AreaLight, SphereDirectionsMeetItAndTheirMeanIsTheIntegral) {
    for (const float sine2 : {0.002f, 0.3f, 0.95f}) {
        const glm::dvec3 towards = glm::normalize(glm::dvec3(0.3, -0.5, 0.4));
        const glm::dvec3 n = glm::normalize(glm::dvec3(0.1, 0.2, 0.9));
        constexpr int kSide = 200;
        double sum = 0.0;
        for (int i = 0; i < kSide; ++i)
            for (int j = 0; j < kSide; ++j) {
                const Real3 l =
                    formulae::sphere_direction(Real2((static_cast<float>(i) + 0.5f) / kSide,
                                                     (static_cast<float>(j) + 0.5f) / kSide),
                                               real3(towards), sine2);
                ASSERT_NEAR(formulae::length(l), 1.0f, 1e-5f);
                ASSERT_EQ(formulae::sphere_is_met(l, real3(2.0 * towards),
                                                  2.0f * std::sqrt(sine2) * 1.001f),
                          1.0f);
                sum += std::max(glm::dot(dvec3(l), n), 0.0);
            }
        const double mean = sum / (kSide * kSide * double{formulae::sphere_density(sine2)});
        const double expected = over_sphere(towards, double{sine2}, [n](const glm::dvec3& l) {
            return std::max(glm::dot(l, n), 0.0);
        });
        EXPECT_NEAR(mean, expected, 1e-3 * expected + 1e-6) << sine2;
    }
}

TEST(AreaLight, RectangleDirectionsMeetItAndTheirMeanIsTheIntegral) {
    for (const SeenRectangle& r : some_rectangles()) {
        const glm::dvec3 n = glm::normalize(glm::dvec3(0.1, 0.2, 0.9));
        constexpr int kSide = 200;
        double sum = 0.0;
        for (int i = 0; i < kSide; ++i)
            for (int j = 0; j < kSide; ++j) {
                const Real3 l =
                    formulae::rectangle_direction(Real2((static_cast<float>(i) + 0.5f) / kSide,
                                                        (static_cast<float>(j) + 0.5f) / kSide),
                                                  r);
                SeenRectangle wider = r;
                wider.half_width *= 1.001f;
                wider.half_height *= 1.001f;
                ASSERT_EQ(formulae::rectangle_is_met(l, wider), 1.0f);
                sum += std::max(glm::dot(dvec3(l), n), 0.0) /
                       double{formulae::rectangle_density(l, r)};
            }
        const double expected =
            over_rectangle(r, [n](const glm::dvec3& l) { return std::max(glm::dot(l, n), 0.0); });
        EXPECT_NEAR(sum / (kSide * kSide), expected, 2e-3 * expected + 1e-6);
    }
}

TEST(AreaLight, TheSolidAngleOfARectangleIsThatOfItsTwoTriangles) {
    // A. van Oosterom and J. Strackee, "The solid angle of a plane triangle", 1983.
    const auto triangle = [](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
        const double numerator = std::abs(glm::dot(a, glm::cross(b, c)));
        const double denominator =
            glm::length(a) * glm::length(b) * glm::length(c) + glm::dot(a, b) * glm::length(c) +
            glm::dot(a, c) * glm::length(b) + glm::dot(b, c) * glm::length(a);
        return 2.0 * std::atan2(numerator, denominator);
    };
    for (const SeenRectangle& r : some_rectangles()) {
        const glm::dvec3 x = double{r.half_width} * dvec3(r.across);
        const glm::dvec3 y = double{r.half_height} * dvec3(r.up);
        const glm::dvec3 m = dvec3(r.middle);
        const double expected =
            triangle(m - x - y, m + x - y, m + x + y) + triangle(m - x - y, m + x + y, m - x + y);
        EXPECT_NEAR(formulae::spherical_rectangle(r).solid_angle, expected, 5e-6);
    }
}

/// The share of GGX's slopes that a part of their plane holds: `inside` says what is of it.
template <typename Inside>
double share_of_slopes(double alpha, const Inside& inside) {
    constexpr int kSide = 2000;
    constexpr double kReach = 4.0;
    double sum = 0.0;
    for (int i = 0; i < kSide; ++i)
        for (int j = 0; j < kSide; ++j) {
            const double x = kReach * ((2.0 * i + 1.0) / kSide - 1.0);
            const double y = kReach * ((2.0 * j + 1.0) / kSide - 1.0);
            if (!inside(x, y)) continue;
            const double divisor = alpha * alpha + x * x + y * y;
            sum += alpha * alpha / (kPi * divisor * divisor);
        }
    return sum * 4.0 * kReach * kReach / (double{kSide} * kSide);
}

TEST(AreaLight, ADiscOfSlopesHoldsTheShareOfGgxThatLiesInIt) {
    for (const double alpha : {0.1, 0.5, 1.0})
        for (const double radius : {0.2, 0.8})
            for (const double aside : {0.0, 0.5, 1.5}) {
                const double expected = share_of_slopes(alpha, [&](double x, double y) {
                    return (x - aside) * (x - aside) + y * y < radius * radius;
                });
                const formulae::Highlight highlight = formulae::disc_highlight(
                    Real2(static_cast<float>(aside), 0.0f),
                    static_cast<float>(kPi * radius * radius), static_cast<float>(alpha));
                EXPECT_NEAR(highlight.share, expected, 2e-3 * expected + 2e-5)
                    << alpha << " " << radius << " " << aside;
                EXPECT_LE(std::abs(static_cast<double>(highlight.slope.x) - aside), radius);
                EXPECT_LE(double{highlight.slope.x}, aside + 1e-6);
            }
}

TEST(AreaLight, AQuadrilateralOfSlopesHoldsTheShareOfGgxThatLiesInIt) {
    for (const double alpha : {0.1, 0.5, 1.0})
        for (const double aside : {0.0, 0.4, 1.5}) {
            const auto corner = [aside](double x, double y) {
                return Real2(static_cast<float>(aside + x), static_cast<float>(y));
            };
            const formulae::Highlight highlight =
                formulae::quad_highlight(corner(-0.5, -0.3), corner(0.5, -0.3), corner(0.5, 0.3),
                                         corner(-0.5, 0.3), static_cast<float>(alpha));
            const double expected = share_of_slopes(alpha, [&](double x, double y) {
                return std::abs(x - aside) < 0.5 && std::abs(y) < 0.3;
            });
            EXPECT_NEAR(highlight.share, expected, 3e-3 * expected + 2e-5) << alpha << " " << aside;
        }
}

TEST(AreaLight, AHighlightOfASmallLightIsThatOfAPoint) {
    const Real3 n = real3(glm::normalize(glm::dvec3(0.1, 0.9, 0.2)));
    const Real3 v = real3(glm::normalize(glm::dvec3(0.5, 0.6, 0.3)));
    for (const float roughness : {0.3f, 0.7f})
        for (const int distribution :
             {formulae::DISTRIBUTION_GGX, formulae::DISTRIBUTION_BECKMANN}) {
            const SeenRectangle r =
                rectangle({-1.0, 2.0, 0.5}, {0.5, -1.0, 0.0}, 0.3, 0.004, 0.002);
            const formulae::BrdfTerms terms{distribution, formulae::GEOMETRY_SMITH_SEPARABLE,
                                            formulae::FRESNEL_SCHLICK, formulae::DIFFUSE_LAMBERT};
            const Real3 l = formulae::normalize(r.middle);
            const float alpha = formulae::alpha_from_roughness(roughness);
            const auto shown = [&](const formulae::Highlight& highlight) {
                const auto angles = formulae::reflection_angles(
                    n, v, formulae::highlight_direction(highlight, v, n));
                return formulae::brdf_of_highlight(terms, angles, highlight.share, Real3(0.5f),
                                                   1.0f, roughness)
                    .x;
            };
            const auto angles = formulae::reflection_angles(n, v, l);
            const float point =
                formulae::brdf_specular(terms, angles, Real3(0.5f), 1.0f, roughness).x *
                angles.n_dot_l;
            const float facing =
                static_cast<float>(kPi) * formulae::length(formulae::rectangle_irradiance(r));
            EXPECT_NEAR(shown(formulae::rectangle_highlight(r, v, n, alpha)) / (point * facing),
                        1.0f, 5e-3f);
            const float sine2 = 1e-6f;
            EXPECT_NEAR(shown(formulae::sphere_highlight(l, sine2, v, n, alpha)) /
                            (point * static_cast<float>(kPi) * sine2),
                        1.0f, 5e-3f);
        }
}

TEST(AreaLight, TheFrameAcrossADirectionIsUnitRightHandedAndSquare) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 z = glm::normalize(glm::dvec3(any(random), any(random), any(random)));
        const formulae::Across frame = formulae::across_of(real3(z));
        const glm::dvec3 x = dvec3(frame.x_axis);
        const glm::dvec3 y = dvec3(frame.y_axis);
        EXPECT_NEAR(glm::length(x), 1.0, 1e-5);
        EXPECT_NEAR(glm::dot(x, z), 0.0, 1e-5);
        EXPECT_NEAR(glm::length(glm::cross(x, y) - z), 0.0, 1e-5);
    }
}

}  // namespace
}  // namespace patina
