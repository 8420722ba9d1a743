// SPDX-License-Identifier: MIT
// formula/NAME/SET: one shared formula over a tile that stays in the cache, on one instruction set,
// in ns a texel (items are texels). The rival is formula/copy/SET, the same loop without a formula.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "formulae_bench.cpp"
#include <hwy/foreach_target.h>

#include "core/formulae/formulae-inl.h"

HWY_BEFORE_NAMESPACE();
namespace patina::HWY_NAMESPACE {

using formulae::Real;
using formulae::Real2;

/// out = formula(a, b) over planes of `count` floats.
#define FORMULA_LOOP(NAME, EXPRESSION)                                                           \
    HWY_FLATTEN void NAME(const float* in_a, const float* in_b, float* out, std::size_t count) { \
        for (std::size_t i = 0; i < count; i += formulae::lane_count()) {                        \
            const Real a = formulae::load(in_a + i);                                             \
            const Real b = formulae::load(in_b + i);                                             \
            formulae::store(EXPRESSION, out + i);                                                \
        }                                                                                        \
    }

FORMULA_LOOP(copy, a + b)
FORMULA_LOOP(over_soft_light, formulae::over_opaque(a, formulae::blend_soft_light_w3c(a, b), 0.7f))
FORMULA_LOOP(over_overlay, formulae::over_opaque(a, formulae::blend_overlay(a, b), 0.7f))
FORMULA_LOOP(encode_srgb, formulae::srgb_from_linear(a) + b)
FORMULA_LOOP(decode_srgb, formulae::linear_from_srgb(a) + b)
FORMULA_LOOP(power, formulae::pow_poly(a, b))
FORMULA_LOOP(value, formulae::value_noise(Real2(a * 64.0f, b * 64.0f), 64, 1u))
FORMULA_LOOP(perlin, formulae::perlin_noise(Real2(a * 64.0f, b * 64.0f), 64, 1u))
FORMULA_LOOP(worley, formulae::worley_noise(Real2(a * 64.0f, b * 64.0f), 64, 1u))
FORMULA_LOOP(perlin_fbm,
             formulae::fbm(formulae::NOISE_PERLIN, Real2(a * 8.0f, b * 8.0f), 8, 1u, 6, 0.5f, 0.0f))
FORMULA_LOOP(worley_fbm,
             formulae::fbm(formulae::NOISE_WORLEY, Real2(a * 8.0f, b * 8.0f), 8, 1u, 6, 0.5f, 0.0f))
#undef FORMULA_LOOP

}  // namespace patina::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <benchmark/benchmark.h>

#include <cmath>
#include <string>
#include <vector>

namespace patina {
namespace {

constexpr std::size_t kTexels = 4096;

HWY_EXPORT(copy);
HWY_EXPORT(over_soft_light);
HWY_EXPORT(over_overlay);
HWY_EXPORT(encode_srgb);
HWY_EXPORT(decode_srgb);
HWY_EXPORT(power);
HWY_EXPORT(value);
HWY_EXPORT(perlin);
HWY_EXPORT(worley);
HWY_EXPORT(perlin_fbm);
HWY_EXPORT(worley_fbm);

using Loop = void (*)(const float* in_a, const float* in_b, float* out, std::size_t count);

struct NamedLoop {
    const char* name;
    Loop run;  // on the instruction set that is switched on
};

#define NAMED_LOOP(NAME, FUNCTION)                                                      \
    NamedLoop {                                                                         \
        NAME, [](const float* in_a, const float* in_b, float* out, std::size_t count) { \
            HWY_DYNAMIC_DISPATCH(FUNCTION)(in_a, in_b, out, count);                     \
        }                                                                               \
    }
const NamedLoop kLoops[] = {
    NAMED_LOOP("copy", copy),
    NAMED_LOOP("over-soft-light", over_soft_light),
    NAMED_LOOP("over-overlay", over_overlay),
    NAMED_LOOP("encode-srgb", encode_srgb),
    NAMED_LOOP("decode-srgb", decode_srgb),
    NAMED_LOOP("power", power),
    NAMED_LOOP("value-noise", value),
    NAMED_LOOP("perlin-noise", perlin),
    NAMED_LOOP("worley-noise", worley),
    NAMED_LOOP("perlin-fbm6", perlin_fbm),
    NAMED_LOOP("worley-fbm6", worley_fbm),
};
#undef NAMED_LOOP

std::vector<float> plane(float step) {
    std::vector<float> values(kTexels);
    for (std::size_t i = 0; i < kTexels; ++i)
        values[i] = std::fmod(static_cast<float>(i) * step, 1.0f);
    return values;
}

void run_loop(benchmark::State& state, std::int64_t target, Loop loop) {
    const std::vector<float> a = plane(0.61803f), b = plane(0.41421f);
    std::vector<float> out(kTexels);
    hwy::SetSupportedTargetsForTest(target);
    for (auto _ : state) {
        loop(a.data(), b.data(), out.data(), kTexels);
        benchmark::DoNotOptimize(out.data());
        benchmark::ClobberMemory();
    }
    hwy::SetSupportedTargetsForTest(0);
    state.counters["s_a_texel"] = benchmark::Counter(
        kTexels, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// Registers every loop on every instruction set that this machine and build have.
const bool kRegistered = [] {
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets())
        for (const NamedLoop& loop : kLoops) {
            const std::string name =
                std::string("formula/") + loop.name + "/" + hwy::TargetName(target);
            benchmark::RegisterBenchmark(name.c_str(), run_loop, target, loop.run);
        }
    return true;
}();

}  // namespace
}  // namespace patina

#endif  // HWY_ONCE
