// SPDX-License-Identifier: MIT
// What Patina writes, judged by the Khronos glTF validator (./test installs it into build/node).
#include <gmock/gmock.h>

#include "cli/program.h"
#include "support/gltf_validator.h"

namespace patina::cli_tests {
namespace {

namespace fs = std::filesystem;

const fs::path kModels = fs::path(PATINA_SOURCE_DIR) / "../shared/assets/models";

class Validator : public ProgramTest {
  protected:
    void SetUp() override {
        if (!tests::has_gltf_validator())
            GTEST_SKIP() << "gltf-validator is not installed in build/node; ./test does that";
    }

    static std::vector<std::string> errors_in(const std::string& file) {
        return tests::gltf_errors_in({file})[file];
    }
};

std::vector<fs::path> models() {
    std::vector<fs::path> found;
    std::error_code error;
    for (const auto& entry : fs::recursive_directory_iterator(kModels, error))
        if (entry.path().extension() == ".glb" || entry.path().extension() == ".gltf")
            found.push_back(entry.path());
    return found;
}

TEST_F(Validator, FindsNoErrorInAnySample) {
    for (const std::string shape :
         {"shader-ball", "sphere", "rounded-cube", "plane", "cylinder", "torus"}) {
        ASSERT_TRUE(succeeded(patina({"sample", "--shape", shape, "-o", at("a.glb")})));
        EXPECT_THAT(errors_in(at("a.glb")), testing::IsEmpty()) << shape;
    }
}

TEST_F(Validator, FindsNoErrorInTheBakedSample) {
    for (const std::string preset : {"rusted-iron", "painted-wood", "brushed-brass"})
        for (const std::string extension : {".glb", ".gltf"}) {
            const std::string output = at(preset + extension);
            ASSERT_TRUE(succeeded(
                patina({"bake", sample(), "--preset", preset, "--size", "256", "-o", output})));
            EXPECT_THAT(errors_in(output), testing::IsEmpty()) << output;
        }
}

TEST_F(Validator, FindsNoErrorInABakedModelThatWasNotInTheModel) {
    const std::vector<fs::path> inputs = models();
    if (inputs.empty()) GTEST_SKIP() << "no models in " << kModels;
    for (const fs::path& input : inputs) {
        ASSERT_TRUE(succeeded(patina({"bake", input.string(), "--preset", "rusted-iron", "--size",
                                      "256", "-o", at("out.glb")})))
            << input;
        const std::vector<std::string> before = errors_in(input.string());
        if (before.empty())
            EXPECT_THAT(errors_in(at("out.glb")), testing::IsEmpty()) << input;
        else
            EXPECT_LE(errors_in(at("out.glb")).size(), before.size()) << input;
    }
}

}  // namespace
}  // namespace patina::cli_tests
