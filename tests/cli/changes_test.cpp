// SPDX-License-Identifier: MIT
// What bake lays on: --layer, --set, --textures.
#include <gmock/gmock.h>

#include <fstream>

#include "cli/program.h"

namespace patina::cli_tests {
namespace {

using testing::HasSubstr;

class Changes : public ProgramTest {
  protected:
    nlohmann::json info(const std::string& file) {
        return nlohmann::json::parse(patina({"info", at(file), "--json"}).out);
    }
};

constexpr const char* kGold =
    R"({"name": "Gold", "channels": {"base-color": {"source": [1, 0.77, 0.34]}, "metalness": {"source": 1}}})";

TEST_F(Changes, ALayerOfJsonGoesOnTopOfTheNamedMaterial) {
    ASSERT_TRUE(succeeded(
        patina({"bake", sample(), "--layer", std::string(kGold) + "@Ball", "-o", at("a.glb")})));
    const auto json = info("a.glb");
    EXPECT_EQ(json["materials"][0]["stack"].back()["name"], "Gold");
    EXPECT_NE(json["materials"][1]["stack"].back()["name"], "Gold");
    const auto gltf = glb_json(at("a.glb"));
    EXPECT_EQ(gltf["materials"][0]["pbrMetallicRoughness"]["metallicFactor"], 1);
    std::ofstream(at("gold.json")) << kGold;
    ASSERT_TRUE(succeeded(
        patina({"bake", sample(), "--layer", at("gold.json") + "@Ball", "-o", at("b.glb")})));
    EXPECT_EQ(file_text(at("a.glb")), file_text(at("b.glb")));
}

TEST_F(Changes, ALayerThatIsWrongIsOneLineThatSaysWhere) {
    const Outcome outcome =
        patina({"bake", sample(), "--layer", R"({"name": "A", "opacity": 7})", "-o", at("a.glb")});
    EXPECT_TRUE(failed_with_one_line(outcome));
    EXPECT_THAT(outcome.errors, HasSubstr("opacity"));
    EXPECT_TRUE(failed_with_one_line(
        patina({"bake", sample(), "--layer", at("none.json"), "-o", at("a.glb")})));
}

TEST_F(Changes, AMaskEntryWithoutANameIsCalledAsItsSource) {
    ASSERT_TRUE(
        succeeded(patina({"bake", sample(), "--layer",
                          R"({"name": "Dirt", "channels": {"roughness": {"source": 1}},
             "mask": {"entries": [{"source": {"kind": "perlin-noise"}}]}})",
                          "--set", "*/Dirt/mask/Perlin noise/opacity=0.5", "-o", at("a.glb")})));
}

TEST_F(Changes, AKnobThatNamesItsPresetTurnsThatOneAlone) {
    const auto bake = [&](const std::vector<std::string>& knobs, const char* name) {
        std::vector<std::string> arguments = {
            "bake",   sample(), "--preset", "rusted-iron@Ball", "--preset", "painted-steel@Stand",
            "--size", "64"};
        for (const std::string& knob : knobs) {
            arguments.emplace_back("--knob");
            arguments.push_back(knob);
        }
        arguments.insert(arguments.end(), {"-o", at(name)});
        EXPECT_TRUE(succeeded(patina(arguments)));
    };
    bake({"rust=0.3"}, "both.glb");
    bake({"rust=0.3", "rusted-iron/rust=0.9"}, "apart.glb");
    bake({"rusted-iron@Ball/rust=0.9", "rust=0.3"}, "reversed.glb");
    const Outcome outcome =
        patina({"compare", at("both.glb"), at("apart.glb"), "--size", "64", "--json"});
    const nlohmann::json report = nlohmann::json::parse(outcome.out);
    EXPECT_FALSE(report["differences"].empty());
    for (const auto& each : report["differences"]) EXPECT_EQ(each["material"], "Ball");
    EXPECT_EQ(file_text(at("apart.glb")), file_text(at("reversed.glb")));
    const Outcome unknown = patina({"bake", sample(), "--preset", "rusted-iron@Ball", "--knob",
                                    "painted-steel/rust=0.3", "-o", at("c.glb")});
    EXPECT_TRUE(failed_with_one_line(unknown));
    EXPECT_THAT(unknown.errors, HasSubstr("painted-steel"));
}

TEST_F(Changes, AScaleIsTheWholeNumberThatItIsTakenFor) {
    const auto bake = [&](const char* scale, const char* name) {
        ASSERT_TRUE(succeeded(
            patina({"bake", sample(), "--layer",
                    std::string(R"({"name": "N", "channels": {"roughness": {"source": )") +
                        R"({"kind": "perlin-noise", "scale": )" + scale + "}}}}",
                    "--size", "64", "-o", at(name)})));
    };
    bake("9.4", "a.glb");
    bake("9", "b.glb");
    EXPECT_EQ(file_text(at("a.glb")), file_text(at("b.glb")));
}

TEST_F(Changes, SetReachesIntoWhatAPresetLaidOn) {
    ASSERT_TRUE(succeeded(patina({"bake", sample(), "--preset", "rusted-iron@Ball", "--set",
                                  "Ball/Rusted iron/opacity=0.5", "--set", "Ball/resolution=256",
                                  "-o", at("a.glb")})));
    const auto ball = info("a.glb")["materials"][0];
    EXPECT_EQ(ball["stack"].back()["opacity"], 0.5);
    EXPECT_EQ(ball["resolution"], 256);
}

TEST_F(Changes, SettingWhatIsNotThereListsWhatIs) {
    const Outcome outcome =
        patina({"bake", sample(), "--set", "Ball/Chrome/opacity=1", "-o", at("a.glb")});
    EXPECT_TRUE(failed_with_one_line(outcome));
    EXPECT_THAT(outcome.errors, HasSubstr("there are:"));
    const Outcome usage = patina({"bake", sample(), "--set", "opacity", "-o", at("a.glb")});
    EXPECT_EQ(usage.status, 2);
}

TEST_F(Changes, AFolderOfTexturesBecomesALayerAndEachGuessIsPrinted) {
    ASSERT_TRUE(succeeded(
        patina({"bake", sample(), "--preset", "rusted-iron@Ball", "--size", "256", "--maps",
                at("rust"), "--packing", "separate", "--quiet", "-o", at("a.glb")})));
    const Outcome outcome =
        patina({"bake", sample(), "--textures", at("rust") + "@Stand", "-o", at("b.glb")});
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    for (const char* guess : {"Ball_base-color.png: base-color", "Ball_roughness.png: roughness",
                              "Ball_normal.png: normal", "Ball_height.png: height"})
        EXPECT_THAT(outcome.errors, HasSubstr(guess));
    const auto stand = info("b.glb")["materials"][1];
    EXPECT_EQ(stand["stack"].back()["name"], "rust");
    EXPECT_GE(stand["stack"].back()["channels"].size(), 4u);
    EXPECT_THAT(outcome.errors, testing::Not(HasSubstr("alpha-mode")));
    // A texture that nothing covers goes into the file as it is.
    const auto gltf = glb_json(at("b.glb"));
    EXPECT_TRUE(gltf["materials"][1]["pbrMetallicRoughness"].contains("baseColorTexture"));
}

TEST_F(Changes, TexturesOfTwoMaterialsAreRefusedInOneLineThatListsThem) {
    ASSERT_TRUE(succeeded(patina({"bake", sample(), "--preset", "rusted-iron", "--size", "16",
                                  "--maps", at("both"), "--packing", "separate", "--quiet"})));
    const Outcome outcome =
        patina({"bake", sample(), "--textures", at("both") + "@Stand", "-o", at("b.glb")});
    EXPECT_TRUE(failed_with_one_line(outcome));
    EXPECT_THAT(outcome.errors, HasSubstr("ball, stand"));
    const Outcome one =
        patina({"bake", sample(), "--textures", at("both/ball") + "@Stand", "-o", at("b.glb")});
    EXPECT_EQ(one.status, 0) << one.errors;
}

TEST_F(Changes, OpacityThatTheAlphaModeHidesIsAWarning) {
    const std::string clear = R"({"name": "Clear", "channels": {"opacity": {"source": 0.5}}})";
    const Outcome outcome =
        patina({"bake", sample(), "--layer", clear + "@Ball", "-o", at("a.glb")});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_THAT(outcome.errors, HasSubstr("alpha-mode"));
    ASSERT_TRUE(succeeded(patina({"bake", sample(), "--layer", clear + "@Ball", "--set",
                                  "Ball/alpha-mode=blend", "-o", at("b.glb")})));
}

}  // namespace
}  // namespace patina::cli_tests
