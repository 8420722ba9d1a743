// SPDX-License-Identifier: MIT
// Good files that were cut off or changed by chance: none may crash or hang the program.
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>

#include "io/sample_gltf.h"
#include "mutation.h"
#include "quiet_load.h"

namespace patina::io {
namespace {

Bytes first_bytes(const Bytes& bytes, std::size_t size) {
    return Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
}

TEST(DamagedFile, CutOffAnywhereNeverCrashes) {
    const Bytes glb = test::sample_gltf().glb();
    for (std::size_t size = 0; size < glb.size(); ++size)
        test::load_quietly(first_bytes(glb, size));
}

TEST(DamagedFile, CutOffAnywhereWithRepairedLengthsNeverCrashes) {
    const auto sample = test::sample_gltf();
    for (std::size_t size = 0; size < sample.binary.size(); ++size)
        test::load_quietly(test::make_glb(sample.json.dump(), first_bytes(sample.binary, size)));
}

TEST(DamagedFile, WhoseTextIsCutOffAnywhereNeverCrashes) {
    for (const auto& model : test::models_to_mutate()) {
        const std::string text = model.json.dump();
        for (std::size_t size = 0; size < text.size(); ++size)
            test::load_quietly(test::make_glb(text.substr(0, size), model.binary));
    }
}

std::uint64_t number_from_environment(const char* name, std::uint64_t fallback) {
    const char* const text = std::getenv(name);
    return text ? std::strtoull(text, nullptr, 10) : fallback;
}

/// PATINA_MUTANT_SEED, where that is "new" a random one.
std::uint64_t first_seed() {
    const char* const text = std::getenv("PATINA_MUTANT_SEED");
    return text && std::string_view(text) == "new"
               ? std::random_device{}()
               : number_from_environment("PATINA_MUTANT_SEED", 1);
}

/// PATINA_MUTANTS sets how many; each has a seed of its own, counted up from the first. The line
/// that was printed last tells where to begin again after a crash.
TEST(DamagedFile, ChangedAtRandomNeverCrashes) {
    constexpr std::uint64_t kReportEvery = 5000;
    const auto models = test::models_to_mutate();
    const std::uint64_t first = first_seed();
    const std::uint64_t count = number_from_environment("PATINA_MUTANTS", 2000);
    std::uint64_t opened = 0;
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        if ((seed - first) % kReportEvery == 0) std::cout << "mutants from seed " << seed << '\n';
        test::Random random(seed);
        opened += test::load_quietly(test::mutant(models[seed % models.size()], random)) ? 1u : 0u;
        if (testing::Test::HasFailure()) FAIL() << "the mutant of seed " << seed;
    }
    // Mutants that are all refused at the door would test nothing behind it.
    std::cout << opened << " of " << count << " opened\n";
    EXPECT_GT(opened, count / 20);
}

}  // namespace
}  // namespace patina::io
