// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include <cmath>

#include "core/formulae/formulae.h"

namespace patina {
namespace {

using formulae::Real3;

const Real3 kFlat(0.0f, 0.0f, 1.0f);

/// A unit normal up to 80 degrees from flat.
rc::Gen<Real3> normals() {
    return rc::gen::map(rc::gen::pair(rc::gen::inRange(0, 1000), rc::gen::inRange(0, 1000)),
                        [](const std::pair<int, int>& at) {
                            const double polar = at.first * (80.0 / 1000.0) * M_PI / 180.0;
                            const double azimuth = at.second * (2.0 * M_PI / 1000.0);
                            return Real3(static_cast<float>(std::sin(polar) * std::cos(azimuth)),
                                         static_cast<float>(std::sin(polar) * std::sin(azimuth)),
                                         static_cast<float>(std::cos(polar)));
                        });
}

bool near(Real3 a, Real3 b, float tolerance = 1e-6f) {
    return formulae::length(a - b) <= tolerance;
}

/// The rotation that takes flat to `base` by the shortest way, applied to `detail` (Rodrigues).
Real3 rotated(Real3 base, Real3 detail) {
    const double axis_x = -base.y, axis_y = base.x, cosine = base.z;
    const double sine = std::hypot(axis_x, axis_y);
    if (sine < 1e-12) return detail;
    const double kx = axis_x / sine, ky = axis_y / sine;
    const double along = kx * detail.x + ky * detail.y;
    const double cross_x = ky * detail.z, cross_y = -kx * detail.z;
    const double cross_z = kx * detail.y - ky * detail.x;
    return {static_cast<float>(detail.x * cosine + cross_x * sine + kx * along * (1 - cosine)),
            static_cast<float>(detail.y * cosine + cross_y * sine + ky * along * (1 - cosine)),
            static_cast<float>(detail.z * cosine + cross_z * sine)};
}

RC_GTEST_PROP(NormalBlend, RnmIsTheRotationFromFlatToTheBackdrop, ()) {
    const Real3 base = *normals(), detail = *normals();
    RC_ASSERT(near(formulae::normal_blend_rnm(base, detail), rotated(base, detail)));
}

RC_GTEST_PROP(NormalBlend, FlatDetailLeavesTheBackdropInEveryMode, ()) {
    const Real3 base = *normals();
    RC_ASSERT(near(formulae::normal_blend_rnm(base, kFlat), base));
    RC_ASSERT(near(formulae::normal_blend_udn(base, kFlat), base));
    RC_ASSERT(near(formulae::normal_blend_whiteout(base, kFlat), base));
}

RC_GTEST_PROP(NormalBlend, AFlatBackdropLeavesTheDetailInRnmAndWhiteout, ()) {
    const Real3 detail = *normals();
    RC_ASSERT(near(formulae::normal_blend_rnm(kFlat, detail), detail));
    RC_ASSERT(near(formulae::normal_blend_whiteout(kFlat, detail), detail));
}

RC_GTEST_PROP(NormalBlend, ResultsAreUnitVectors, ()) {
    const Real3 base = *normals(), detail = *normals();
    const float weight = static_cast<float>(*rc::gen::inRange(0, 65)) / 64.0f;
    for (const Real3& result :
         {formulae::normal_blend_rnm(base, detail), formulae::normal_blend_udn(base, detail),
          formulae::normal_blend_whiteout(base, detail), formulae::normal_faded(base, weight),
          formulae::normal_over(base, detail, weight)})
        RC_ASSERT(std::abs(formulae::length(result) - 1.0f) < 2e-6f);
}

RC_GTEST_PROP(NormalBlend, FadingGoesFromFlatToTheNormal, ()) {
    const Real3 normal = *normals();
    RC_ASSERT(near(formulae::normal_faded(normal, 0.0f), kFlat));
    RC_ASSERT(near(formulae::normal_faded(normal, 1.0f), normal));
    RC_ASSERT(formulae::normal_faded(normal, 0.5f).z >= normal.z - 1e-6f);
    RC_ASSERT(near(formulae::normal_over(kFlat, normal, 1.0f), normal));
}

RC_GTEST_PROP(NormalBlend, EncodingANormalAndDecodingItReturnsIt, ()) {
    const Real3 normal = *normals();
    RC_ASSERT(near(formulae::signed_from_encoded(formulae::encoded_from_signed(normal)), normal));
}

RC_GTEST_PROP(NormalBlend, InAGroupTheSourceStandsByItselfWhereNothingIsBelow, ()) {
    const Real3 laid = *normals();
    const Real3 source = *normals();
    RC_ASSERT(near(formulae::normal_in_group(laid, 1.0f, source, 0.3f), laid));
    RC_ASSERT(near(formulae::normal_in_group(laid, 0.0f, source, 0.3f), source));
}

TEST(NormalBlend, AVectorWithoutLengthIsFlat) {
    EXPECT_TRUE(near(formulae::unit_normal(Real3(0.0f)), kFlat));
}

}  // namespace
}  // namespace patina
