// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include "cli/program.h"

namespace patina::cli_tests {
namespace {

using testing::HasSubstr;

class Bake : public ProgramTest {};

TEST_F(Bake, WithNothingToChangeGivesTheIdenticalFile) {
    const std::string input = sample();
    ASSERT_TRUE(succeeded(patina({"bake", input, "-o", at("out.glb")})));
    EXPECT_EQ(file_text(input), file_text(at("out.glb")));
}

TEST_F(Bake, APresetOnOneMaterialLeavesTheOtherAlone) {
    const std::string input = sample();
    ASSERT_TRUE(succeeded(patina(
        {"bake", input, "--preset", "rusted-iron@Ball", "--size", "256", "-o", at("out.glb")})));
    const nlohmann::json before = glb_json(input);
    const nlohmann::json after = glb_json(at("out.glb"));
    EXPECT_EQ(after["materials"][1], before["materials"][1]);
    const nlohmann::json& ball = after["materials"][0];
    EXPECT_TRUE(ball["pbrMetallicRoughness"].contains("baseColorTexture"));
    EXPECT_TRUE(ball["extras"].contains("patina"));
    EXPECT_GT(after["images"].size(), 0u);
}

TEST_F(Bake, WithoutAMaterialNameThePresetGoesOnAll) {
    ASSERT_TRUE(succeeded(patina(
        {"bake", sample(), "--preset", "rusted-iron", "--size", "256", "-o", at("out.glb")})));
    for (const nlohmann::json& material : glb_json(at("out.glb"))["materials"])
        EXPECT_TRUE(material["extras"].contains("patina"));
}

TEST_F(Bake, GivesTheSameBytesAtAnyNumberOfThreads) {
    const std::string input = sample();
    for (const std::string threads : {"1", "2", "5"})
        ASSERT_TRUE(succeeded(patina({"bake", input, "--preset", "painted-wood", "--size", "512",
                                      "--threads", threads, "-o", at(threads + ".glb")})));
    EXPECT_EQ(file_text(at("1.glb")), file_text(at("2.glb")));
    EXPECT_EQ(file_text(at("1.glb")), file_text(at("5.glb")));
}

TEST_F(Bake, BakingItsOwnOutputChangesNothing) {
    ASSERT_TRUE(succeeded(patina(
        {"bake", sample(), "--preset", "brushed-brass", "--size", "256", "-o", at("once.glb")})));
    ASSERT_TRUE(succeeded(patina({"bake", at("once.glb"), "-o", at("twice.glb")})));
    EXPECT_EQ(file_text(at("once.glb")), file_text(at("twice.glb")));
}

TEST_F(Bake, AlsoWritesTheMapsAsFilesAndReportsThem) {
    for (const std::string format : {"png", "tif"}) {
        const Outcome outcome =
            patina({"bake", sample(), "--preset", "rusted-iron@Ball", "--size", "256", "--maps",
                    at(format), "--map-format", format, "--json", "-o", at("out.glb")});
        ASSERT_TRUE(succeeded(outcome));
        const nlohmann::json report = nlohmann::json::parse(outcome.out);
        EXPECT_EQ(report["materials_written"], 1);
        ASSERT_GT(report["map_files"].size(), 0u);
        for (const auto& file : report["map_files"]) {
            const std::filesystem::path path = file.get<std::string>();
            EXPECT_EQ(path.extension(), "." + format);
            EXPECT_GT(std::filesystem::file_size(path), 0u);
        }
    }
}

TEST_F(Bake, WritesAllMapsOfTheResultThoughThisSaveBakedNone) {
    ASSERT_TRUE(succeeded(patina({"bake", sample(), "--preset", "rusted-iron@Ball", "--size", "256",
                                  "-o", at("once.glb")})));
    const Outcome outcome = patina({"bake", at("once.glb"), "--maps", at("maps"), "--size", "256",
                                    "--json", "-o", at("twice.glb")});
    ASSERT_TRUE(succeeded(outcome));
    const nlohmann::json report = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(report["maps_baked"], 0);
    EXPECT_GE(report["map_files"].size(), 3u);
}

TEST_F(Bake, MapsComeInTheBitsAndPackingThatWereAskedFor) {
    const Outcome outcome = patina({"bake", sample(), "--preset", "rusted-iron@Ball", "--size",
                                    "256", "--maps", at("maps"), "--map-format", "exr", "--bits",
                                    "32", "--packing", "separate", "--json", "-o", at("out.glb")});
    ASSERT_TRUE(succeeded(outcome));
    std::vector<std::string> names;
    const nlohmann::json report = nlohmann::json::parse(outcome.out);
    for (const auto& file : report["map_files"])
        names.push_back(std::filesystem::path(file.get<std::string>()).filename().string());
    EXPECT_THAT(names, testing::IsSupersetOf({"Ball_base-color.exr", "Ball_height.exr",
                                              "Ball_metalness.exr", "Ball_roughness.exr"}));
}

TEST_F(Bake, MapsAloneAreThoseThatComeBesideAFile) {
    const std::string input = sample();
    const auto bake = [&](const std::string& folder, std::vector<std::string> output) {
        std::vector<std::string> arguments = {"bake",   input, "--preset", "rusted-iron@Ball",
                                              "--size", "256", "--maps",   at(folder),
                                              "--json"};
        arguments.insert(arguments.end(), output.begin(), output.end());
        const Outcome outcome = patina(arguments);
        EXPECT_TRUE(succeeded(outcome));
        return nlohmann::json::parse(outcome.out);
    };
    const nlohmann::json beside = bake("beside", {"-o", at("out.glb")});
    const nlohmann::json alone = bake("alone", {});
    EXPECT_TRUE(alone["output"].is_null());
    ASSERT_EQ(alone["map_files"].size(), beside["map_files"].size());
    for (std::size_t i = 0; i < alone["map_files"].size(); ++i)
        EXPECT_EQ(file_text(alone["map_files"][i].get<std::string>()),
                  file_text(beside["map_files"][i].get<std::string>()));
}

TEST_F(Bake, WithoutAnywhereToWriteIsWrongUsage) {
    const Outcome outcome = patina({"bake", sample()});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.errors, HasSubstr("-o FILE, --maps DIR or both"));
}

TEST_F(Bake, WhatNoFileCanHoldIsWrongUsage) {
    const Outcome outcome =
        patina({"bake", sample(), "--maps", at("maps"), "--bits", "32", "-o", at("out.glb")});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.errors, HasSubstr("use tif or exr"));
}

TEST_F(Bake, AnUnknownPresetOrMaterialIsOneLineThatListsTheKnownOnes) {
    const std::string input = sample();
    const Outcome preset = patina({"bake", input, "--preset", "unobtainium", "-o", at("o.glb")});
    EXPECT_TRUE(failed_with_one_line(preset));
    EXPECT_THAT(preset.errors, HasSubstr("rusted-iron"));
    const Outcome material =
        patina({"bake", input, "--preset", "rusted-iron@Wheel", "-o", at("o.glb")});
    EXPECT_TRUE(failed_with_one_line(material));
    EXPECT_THAT(material.errors, HasSubstr("Ball, Stand"));
    EXPECT_EQ(files(), 1u) << "only the input may be there";
}

TEST_F(Bake, QuietSaysNothing) {
    const Outcome outcome = patina({"bake", sample(), "--quiet", "-o", at("out.glb")});
    ASSERT_TRUE(succeeded(outcome));
    EXPECT_EQ(outcome.out + outcome.errors, "");
}

}  // namespace
}  // namespace patina::cli_tests
