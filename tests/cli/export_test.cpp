// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include "cli/program.h"

namespace patina::cli_tests {
namespace {

using testing::HasSubstr;

class Export : public ProgramTest {};

TEST_F(Export, WritesEachMapAndSaysWhich) {
    ASSERT_TRUE(succeeded(patina(
        {"bake", sample(), "--preset", "rusted-iron@Ball", "--size", "256", "-o", at("in.glb")})));
    const Outcome outcome =
        patina({"export", at("in.glb"), "--packing", "unreal", "-o", at("maps")});
    ASSERT_TRUE(succeeded(outcome));
    for (const char* map : {"BaseColor", "OcclusionRoughnessMetallic", "NormalDX"}) {
        const std::string file = at(std::string("maps/Ball_") + map + ".png");
        EXPECT_TRUE(std::filesystem::exists(file)) << file;
        EXPECT_THAT(outcome.out, HasSubstr(file));
    }
}

TEST_F(Export, OfAModelWithoutMapsSaysSo) {
    const Outcome outcome = patina({"export", sample(), "-o", at("maps")});
    ASSERT_TRUE(succeeded(outcome));
    EXPECT_THAT(outcome.out, HasSubstr("no map is needed"));
}

TEST_F(Export, RefusesAPackingThatIsNotThereAndListsThoseThatAre) {
    const Outcome outcome = patina({"export", sample(), "--packing", "maya", "-o", at("maps")});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.errors, HasSubstr("unreal"));
}

}  // namespace
}  // namespace patina::cli_tests
