// SPDX-License-Identifier: MIT
// compare and explain: what a file holds, in words and numbers.
#include <gmock/gmock.h>

#include "cli/program.h"

namespace patina::cli_tests {
namespace {

using testing::HasSubstr;

class Compare : public ProgramTest {
  protected:
    /// A baked file with a rusted ball, and the same with the rust at half opacity.
    void SetUp() override {
        const std::string input = sample();
        ASSERT_TRUE(succeeded(patina({"bake", input, "--preset", "rusted-iron@Ball", "--size",
                                      "256", "-o", at("full.glb")})));
        ASSERT_TRUE(succeeded(
            patina({"bake", input, "--preset", "rusted-iron@Ball", "--set",
                    "Ball/Rusted iron/opacity=0.5", "--size", "256", "-o", at("half.glb")})));
    }
};

TEST_F(Compare, SaysTheSameOfAFileAndItself) {
    const Outcome outcome = patina({"compare", at("full.glb"), at("full.glb"), "--size", "64"});
    ASSERT_TRUE(succeeded(outcome));
    EXPECT_THAT(outcome.out, HasSubstr("the documents say the same"));
    EXPECT_THAT(outcome.out, HasSubstr("the maps are the same"));
}

TEST_F(Compare, SaysWhichLayerDiffersAndByHowMuchTheMapsDo) {
    const Outcome text = patina({"compare", at("full.glb"), at("half.glb"), "--size", "64"});
    ASSERT_TRUE(succeeded(text));
    EXPECT_THAT(text.out, HasSubstr("Ball / Rusted iron: opacity is 0.5, was 1"));
    EXPECT_THAT(text.out, HasSubstr("base-color"));
    const auto json = nlohmann::json::parse(
        patina({"compare", at("full.glb"), at("half.glb"), "--size", "64", "--json"}).out);
    EXPECT_EQ(json["equal"], false);
    ASSERT_EQ(json["differences"].size(), 1u);
    bool roughness = false;
    for (const auto& map : json["maps"]) {
        EXPECT_EQ(map["material"], "Ball");
        EXPECT_GE(map["largest"].get<double>(), map["mean"].get<double>());
        roughness = roughness || map["channel"] == "roughness";
    }
    EXPECT_TRUE(roughness);
}

TEST_F(Compare, OfFilesWithoutACommonMaterialSaysThatThereAreNoMapsToCompare) {
    const std::string other = at("plain.glb");
    ASSERT_TRUE(succeeded(patina(
        {"bake", sample(), "--set", "Ball/name=Other", "--set", "Stand/name=Foot", "-o", other})));
    const Outcome outcome = patina({"compare", sample(), other, "--size", "64"});
    ASSERT_TRUE(succeeded(outcome));
    EXPECT_THAT(outcome.out, HasSubstr("no maps to compare"));
    EXPECT_THAT(outcome.out, testing::Not(HasSubstr("the maps are the same")));
    const auto json =
        nlohmann::json::parse(patina({"compare", sample(), other, "--size", "64", "--json"}).out);
    EXPECT_EQ(json["materials_compared"], 0);
}

TEST_F(Compare, ExplainEndsInTheValueThatIsBaked) {
    const auto json =
        nlohmann::json::parse(patina({"explain", at("full.glb"), "--material", "Ball", "--uv",
                                      "0.3,0.6", "--channel", "metalness", "--json"})
                                  .out);
    ASSERT_EQ(json["channels"].size(), 1u);
    const auto& steps = json["channels"][0]["steps"];
    ASSERT_GT(steps.size(), 1u);
    EXPECT_EQ(json["x"], 76);  // 0.3 of 256
    EXPECT_EQ(json["y"], 153);
    EXPECT_EQ(steps.back()["layer"], "Rusted iron");
    const Outcome text =
        patina({"explain", at("full.glb"), "--material", "Ball", "--uv", "0.3,0.6"});
    ASSERT_TRUE(succeeded(text));
    for (const char* word : {"Base colour", "Rusted iron", "weight", "value out"})
        EXPECT_THAT(text.out, HasSubstr(word));
}

TEST_F(Compare, ExplainAsksForTheMaterialWhereThereAreSeveral) {
    const Outcome outcome = patina({"explain", at("full.glb"), "--uv", "0.3,0.6"});
    EXPECT_TRUE(failed_with_one_line(outcome));
    EXPECT_THAT(outcome.errors, HasSubstr("--material"));
    EXPECT_EQ(patina({"explain", at("full.glb"), "--uv", "0.3"}).status, 2);
}

}  // namespace
}  // namespace patina::cli_tests
