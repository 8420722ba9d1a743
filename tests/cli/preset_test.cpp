// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <fstream>

#include "cli/program.h"

namespace patina::cli_tests {
namespace {

using testing::HasSubstr;

class PresetCommand : public ProgramTest {};

TEST_F(PresetCommand, ListsWhatShips) {
    const Outcome list = patina({"preset", "list"});
    ASSERT_TRUE(succeeded(list));
    for (const char* id : {"rusted-iron", "painted-wood", "brushed-brass"})
        EXPECT_THAT(list.out, HasSubstr(id));
    const nlohmann::json json = nlohmann::json::parse(patina({"preset", "list", "--json"}).out);
    for (const nlohmann::json& preset : json) {
        EXPECT_FALSE(preset["description"].get<std::string>().empty());
        EXPECT_FALSE(preset["licence"].get<std::string>().empty());
        EXPECT_GT(preset["layers"], 1);
    }
}

TEST_F(PresetCommand, WhatShowPrintsIsAGoodPreset) {
    const Outcome shown = patina({"preset", "show", "rusted-iron"});
    ASSERT_TRUE(succeeded(shown));
    std::ofstream(at("copy.json")) << shown.out;
    EXPECT_TRUE(succeeded(patina({"preset", "check", at("copy.json")})));
}

TEST_F(PresetCommand, CheckNamesWhatIsWrong) {
    std::ofstream(at("bad.json")) << "{\"id\": 7}";
    const Outcome outcome = patina({"preset", "check", at("bad.json")});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.out, HasSubstr("bad.json"));
    EXPECT_THAT(outcome.errors, HasSubstr("1 of 1"));
}

TEST_F(PresetCommand, AnExportedStackCanBeLaidOnAgain) {
    ASSERT_TRUE(succeeded(patina({"bake", sample(), "--preset", "rusted-iron@Ball", "--size", "256",
                                  "-o", at("first.glb")})));
    ASSERT_TRUE(
        succeeded(patina({"preset", "export", at("first.glb"), "--material", "Ball", "--id",
                          "old-iron", "--category", "Metal", "--author", "A", "--licence",
                          "CC0-1.0", "--description", "Rust.", "-o", at("old-iron.json")})));
    ASSERT_TRUE(succeeded(patina({"bake", sample(), "--preset", at("old-iron.json") + "@Ball",
                                  "--size", "256", "-o", at("second.glb")})));
    EXPECT_TRUE(glb_json(at("second.glb"))["materials"][0]["extras"].contains("patina"));
}

}  // namespace
}  // namespace patina::cli_tests
