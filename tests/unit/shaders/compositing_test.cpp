// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include "core/formulae/formulae.h"

namespace patina {
namespace {

rc::Gen<float> zero_to_one() {
    return rc::gen::map(rc::gen::inRange(0, 4097),
                        [](int value) { return static_cast<float>(value) / 4096.0f; });
}

RC_GTEST_PROP(Compositing, TheGeneralFormIsTheFormulaOfTheSpecification, ()) {
    const float cb = *zero_to_one(), cs = *zero_to_one(), blended = *zero_to_one(),
                ab = *zero_to_one(), as = *zero_to_one();
    const double published =
        double{as} * (1 - double{ab}) * cs + double{as} * ab * blended + (1 - double{as}) * ab * cb;
    RC_ASSERT(std::abs(formulae::over_premultiplied(cb, ab, cs, blended, as) - published) < 3e-7);
    RC_ASSERT(std::abs(formulae::over_coverage(ab, as) - (as + ab - double{as} * ab)) < 2e-7);
}

RC_GTEST_PROP(Compositing, OverAnOpaqueBackdropTheGeneralFormIsTheLerp, ()) {
    const float cb = *zero_to_one(), cs = *zero_to_one(), blended = *zero_to_one(),
                as = *zero_to_one();
    RC_ASSERT(formulae::over_coverage(1.0f, as) == 1.0f);
    RC_ASSERT(std::abs(formulae::over_premultiplied(cb, 1.0f, cs, blended, as) -
                       formulae::over_opaque(cb, blended, as)) < 2e-7f);
}

RC_GTEST_PROP(Compositing, WeightZeroLeavesTheBackdropAndOneGivesTheBlend, ()) {
    const float cb = *zero_to_one(), blended = *zero_to_one();
    RC_ASSERT(formulae::over_opaque(cb, blended, 0.0f) == cb);
    RC_ASSERT(formulae::over_opaque(cb, blended, 1.0f) == blended);
}

RC_GTEST_PROP(Compositing, OverNothingOnlyTheSourceIsSeen, ()) {
    const float cb = *zero_to_one(), cs = *zero_to_one(), blended = *zero_to_one(),
                as = *zero_to_one();
    RC_ASSERT(formulae::over_premultiplied(cb, 0.0f, cs, blended, as) == as * cs);
    RC_ASSERT(formulae::over_coverage(0.0f, as) == as);
    RC_ASSERT(formulae::unpremultiplied(0.0f, 0.0f) == 0.0f);
}

}  // namespace
}  // namespace patina
