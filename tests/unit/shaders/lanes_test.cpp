// SPDX-License-Identifier: MIT
// The shared formulae over SIMD lanes give the bits that they give one value at a time, on every
// instruction set of this machine.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shaders/lanes_test.cpp"
#include <hwy/foreach_target.h>

#include "core/formulae/formulae-inl.h"

HWY_BEFORE_NAMESPACE();
namespace patina::HWY_NAMESPACE {
namespace formulae {
namespace {
#undef PROBES_GLSL
#include "shaders/probes.glsl"
}  // namespace
}  // namespace formulae

/// Runs one probe over `count` inputs (a multiple of 16) of eight planes into four planes.
void run_probe_in_lanes(int which, const float* const* in, float* const* out, std::size_t count) {
    using formulae::load;
    using formulae::Real4;
    for (std::size_t i = 0; i < count; i += formulae::lane_count()) {
        const Real4 a(load(in[0] + i), load(in[1] + i), load(in[2] + i), load(in[3] + i));
        const Real4 b(load(in[4] + i), load(in[5] + i), load(in[6] + i), load(in[7] + i));
        const Real4 result = formulae::probe(which, a, b);
        formulae::store(result.x, out[0] + i);
        formulae::store(result.y, out[1] + i);
        formulae::store(result.z, out[2] + i);
        formulae::store(result.w, out[3] + i);
    }
}

/// The instruction set that dispatch has picked.
std::int64_t running_target() {
    return HWY_TARGET;
}

}  // namespace patina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <gtest/gtest.h>

#include <cstring>

#include "core/formulae/formulae.h"
#include "core/hash.h"
#include "shaders/probes.h"

namespace patina {
namespace formulae {
namespace {
#undef PROBES_GLSL
#include "shaders/probes.glsl"
}  // namespace
}  // namespace formulae

namespace {

HWY_EXPORT(run_probe_in_lanes);
HWY_EXPORT(running_target);

using ProbeResults = std::array<std::vector<float>, 4>;

ProbeResults results_in_lanes(int which) {
    ProbeResults results;
    std::array<const float*, 8> in{};
    std::array<float*, 4> out{};
    for (std::size_t k = 0; k < in.size(); ++k) in[k] = probe_inputs()[k].data();
    for (std::size_t k = 0; k < out.size(); ++k) {
        results[k].resize(kProbeInputs);
        out[k] = results[k].data();
    }
    HWY_DYNAMIC_DISPATCH(run_probe_in_lanes)(which, in.data(), out.data(), kProbeInputs);
    return results;
}

ProbeResults results_one_by_one(int which) {
    ProbeResults results;
    const ProbeInputs& in = probe_inputs();
    for (std::size_t i = 0; i < kProbeInputs; ++i) {
        const formulae::Real4 a(in[0][i], in[1][i], in[2][i], in[3][i]);
        const formulae::Real4 b(in[4][i], in[5][i], in[6][i], in[7][i]);
        const formulae::Real4 result = formulae::probe(which, a, b);
        results[0].push_back(result.x);
        results[1].push_back(result.y);
        results[2].push_back(result.z);
        results[3].push_back(result.w);
    }
    return results;
}

/// How many values differ in their bits; the first of them is printed.
int differing_bits(const ProbeResults& expected, const ProbeResults& actual) {
    int count = 0;
    for (std::size_t k = 0; k < expected.size(); ++k)
        for (std::size_t i = 0; i < kProbeInputs; ++i) {
            if (std::memcmp(&expected[k][i], &actual[k][i], sizeof(float)) == 0) continue;
            if (count++ == 0)
                ADD_FAILURE() << "component " << k << " of input " << i << " is " << actual[k][i]
                              << ", expected " << expected[k][i];
        }
    return count;
}

TEST(Lanes, EveryInstructionSetGivesTheBitsOfOneValueAtATime) {
    std::vector<ProbeResults> expected;
    for (int which = 0; which < kProbeCount; ++which) expected.push_back(results_one_by_one(which));

    int sets_run = 0;
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        hwy::SetSupportedTargetsForTest(target);
        ASSERT_EQ(HWY_DYNAMIC_DISPATCH(running_target)(), target) << hwy::TargetName(target);
        for (int which = 0; which < kProbeCount; ++which)
            EXPECT_EQ(differing_bits(expected[which], results_in_lanes(which)), 0)
                << kProbes[which].name << " on " << hwy::TargetName(target);
        ++sets_run;
    }
    hwy::SetSupportedTargetsForTest(0);
    EXPECT_GE(sets_run, 1);
}

TEST(Lanes, EveryCompilerAndMachineGivesThePinnedBits) {
    // Changes with any formula or probe: a change that was not meant to move a texel moved one.
    Hasher hasher;
    for (int which = 0; which < kProbeCount; ++which)
        for (const std::vector<float>& values : results_one_by_one(which))
            for (const float value : values) hasher.add(value);
    EXPECT_EQ(to_hex(hasher.finish()), "c8021c59101ea73ee897bdf358c4344f");
}

TEST(Lanes, EveryProbeInTheTableIsAProbeOfTheText) {
    const formulae::Real4 none =
        formulae::probe(kProbeCount, formulae::Real4(0.5f), formulae::Real4(0.5f));
    EXPECT_EQ(none.x, -1.0f);
    EXPECT_EQ(none.w, -1.0f);
}

}  // namespace
}  // namespace patina

#endif  // HWY_ONCE
