// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include "cli/program.h"

namespace patina::cli_tests {
namespace {

using testing::HasSubstr;

class Info : public ProgramTest {};

TEST_F(Info, ShowsTheStackOfWhatWasBakedAsATree) {
    ASSERT_TRUE(succeeded(patina(
        {"bake", sample(), "--preset", "rusted-iron@Ball", "--size", "256", "-o", at("out.glb")})));
    const Outcome text = patina({"info", at("out.glb")});
    ASSERT_TRUE(succeeded(text));
    EXPECT_THAT(text.out, HasSubstr("material Ball"));
    EXPECT_THAT(text.out, HasSubstr("├─ Rusted iron"));
    EXPECT_THAT(text.out, HasSubstr("└─ "));
    const nlohmann::json json =
        nlohmann::json::parse(patina({"info", at("out.glb"), "--json"}).out);
    EXPECT_EQ(json["materials"][0]["name"], "Ball");
    EXPECT_THAT(text.out, HasSubstr("of the texture is used"));
    EXPECT_GT(json["materials"][0]["uvs"]["used"], 0.3);
    EXPECT_EQ(json["materials"][0]["uvs"]["triangles_without_uvs"], 0);
    const nlohmann::json& stack = json["materials"][0]["stack"];
    EXPECT_EQ(stack.back()["name"], "Rusted iron");
    EXPECT_GT(stack.back()["children"].size(), 1u);
}

TEST_F(Info, ListsTheCamerasOfTheFile) {
    const std::string file = triangle_with_cameras();
    const Outcome text = patina({"info", file});
    ASSERT_TRUE(succeeded(text));
    EXPECT_THAT(text.out, HasSubstr("camera 0 Close: perspective, 45.0 degrees"));
    EXPECT_THAT(text.out, HasSubstr("camera 1 Side: orthographic, 3 m high"));
    const nlohmann::json json = nlohmann::json::parse(patina({"info", file, "--json"}).out);
    EXPECT_EQ(json["cameras"][1]["name"], "Side");
    EXPECT_NEAR(json["cameras"][0]["fov_y_degrees"].get<double>(), 45.0, 1e-4);
}

TEST_F(Info, CheckFindsNothingWrongWithTheSample) {
    const Outcome check = patina({"check", sample(), "--json"});
    ASSERT_TRUE(succeeded(check));
    const nlohmann::json json = nlohmann::json::parse(check.out);
    EXPECT_EQ(json["faults"].size(), 0u);
    EXPECT_EQ(json["warnings"].size(), 0u);
}

}  // namespace
}  // namespace patina::cli_tests
