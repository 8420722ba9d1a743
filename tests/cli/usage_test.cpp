// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include "cli/program.h"

namespace patina::cli_tests {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

class Usage : public ProgramTest {};

TEST_F(Usage, HelpNamesEveryCommandAndTheLimits) {
    const Outcome help = patina({"--help"});
    ASSERT_TRUE(succeeded(help));
    for (const char* word : {"bake", "render", "export", "info", "explain", "compare", "check",
                             "preset", "sample", "completion", "16384"})
        EXPECT_THAT(help.out, HasSubstr(word));
    EXPECT_THAT(help.errors, IsEmpty());
}

TEST_F(Usage, EveryCommandHasHelpWithAnExample) {
    for (const char* command :
         {"bake", "render", "export", "info", "explain", "compare", "check", "preset", "sample"}) {
        const Outcome help = patina({command, "--help"});
        ASSERT_TRUE(succeeded(help)) << command;
        EXPECT_THAT(help.out, HasSubstr(std::string("  patina ") + command)) << command;
    }
}

TEST_F(Usage, FlagsThatTurnSomethingOffAreNamedPlainlyInTheHelp) {
    const Outcome help = patina({"render", "--help"});
    EXPECT_THAT(help.out, HasSubstr("--no-shadows "));
    EXPECT_THAT(help.out, testing::Not(HasSubstr("{false}")));
}

TEST_F(Usage, TheVersionIsOneLine) {
    const Outcome version = patina({"--version"});
    ASSERT_TRUE(succeeded(version));
    EXPECT_THAT(version.out, testing::MatchesRegex("patina [0-9.]+\n"));
}

TEST_F(Usage, WrongUsageIsStatusTwoAndOneLineThatPointsToTheHelp) {
    const std::vector<std::vector<std::string>> wrong = {
        {"--no-such-flag"},
        {"bake"},
        {"bake", "in.glb"},
        {"bake", "in.glb", "-o", "out.obj"},
        {"bake", "in.glb", "-o", at("out.glb"), "--size", "0"},
        {"bake", "in.glb", "-o", at("out.glb"), "--threads", "0"},
        {"render", "in.glb", "-o", at("out.png"), "--size", "0x10"},
        {"render", "in.glb", "-o", at("out.png"), "--shading", "gouraud"},
        {"render", "in.glb", "-o", at("out.png"), "--channel", "smell"},
        {"render", "in.glb", "-o", at("out.png"), "--background", "#12345g"},
        {"render", "in.glb", "-o", at("out.png"), "--camera-position", "1,2"},
        {"render", "in.glb", "-o", at("out.png"), "--camera", "0", "--camera-target", "1,2,3"},
        {"preset"},
        {"sample", "--shape", "teapot", "-o", at("out.glb")},
    };
    for (const auto& arguments : wrong) {
        const Outcome outcome = patina(arguments);
        EXPECT_EQ(outcome.status, 2) << testing::PrintToString(arguments);
        EXPECT_THAT(outcome.out, IsEmpty());
        EXPECT_THAT(outcome.errors, StartsWith("patina: "));
        EXPECT_THAT(outcome.errors, HasSubstr("--help"));
        EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1)
            << outcome.errors;
    }
    EXPECT_EQ(files(), 0u);
}

TEST_F(Usage, AFileThatIsNotThereIsStatusOneAndOneLineThatNamesIt) {
    for (const auto& arguments :
         std::vector<std::vector<std::string>>{{"bake", at("no.glb"), "-o", at("out.glb")},
                                               {"render", at("no.glb"), "-o", at("out.png")},
                                               {"info", at("no.glb")},
                                               {"check", at("no.glb")}}) {
        const Outcome outcome = patina(arguments);
        EXPECT_TRUE(failed_with_one_line(outcome)) << arguments[0];
        EXPECT_THAT(outcome.errors, HasSubstr("no.glb"));
    }
    EXPECT_EQ(files(), 0u) << "a failed command leaves no file behind";
}

}  // namespace
}  // namespace patina::cli_tests
