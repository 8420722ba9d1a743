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

TEST_F(Export, TakesAnySizeAndAFormatForEachMap) {
    ASSERT_TRUE(succeeded(patina({"bake", sample(), "--preset", "rusted-iron@Ball", "--size", "100",
                                  "--maps", at("maps"), "--png-level", "1", "--quiet"})));
    const std::string png = file_text(at("maps/Ball_base-color.png"));
    EXPECT_EQ(png.substr(16, 8), std::string("\0\0\0\x64\0\0\0\x64", 8));
    ASSERT_TRUE(succeeded(patina({"bake", sample(), "--preset", "rusted-iron@Ball", "--size", "256",
                                  "--quiet", "-o", at("in.glb")})));
    const Outcome outcome = patina({"export", at("in.glb"), "--size", "3", "--map-format", "jpg",
                                    "--jpg-quality", "50", "-o", at("small")});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_THAT(outcome.errors, HasSubstr("normal stays png"));
    EXPECT_EQ(file_text(at("small/Ball_base-color.jpg")).substr(0, 2), "\xff\xd8");
    EXPECT_TRUE(std::filesystem::exists(at("small/Ball_normal.png")));
    EXPECT_EQ(patina({"export", at("in.glb"), "--size", "16385", "-o", at("maps")}).status, 2);
    EXPECT_EQ(
        patina({"export", at("in.glb"), "--map-format", "jpg", "--bits", "16", "-o", at("maps")})
            .status,
        2);
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
