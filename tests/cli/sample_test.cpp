// SPDX-License-Identifier: MIT
#include "cli/program.h"

namespace patina::cli_tests {
namespace {

class Sample : public ProgramTest {};

TEST_F(Sample, IsTheShaderBallWithItsTwoMaterials) {
    const nlohmann::json json = glb_json(sample());
    EXPECT_EQ(json["materials"][0]["name"], "Ball");
    EXPECT_EQ(json["materials"][1]["name"], "Stand");
    EXPECT_EQ(json["asset"]["version"], "2.0");
}

TEST_F(Sample, EveryShapeIsWrittenTheSameTwice) {
    for (const std::string shape :
         {"shader-ball", "sphere", "rounded-cube", "plane", "cylinder", "torus"}) {
        ASSERT_TRUE(succeeded(patina({"sample", "--shape", shape, "-o", at("a.glb")})));
        ASSERT_TRUE(succeeded(patina({"sample", "--shape", shape, "-o", at("b.glb")})));
        EXPECT_EQ(file_text(at("a.glb")), file_text(at("b.glb"))) << shape;
    }
}

TEST_F(Sample, AFolderThatIsNotThereIsOneLine) {
    EXPECT_TRUE(failed_with_one_line(patina({"sample", "-o", at("no/such/ball.glb")})));
}

}  // namespace
}  // namespace patina::cli_tests
