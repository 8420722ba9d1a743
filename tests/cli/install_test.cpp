// SPDX-License-Identifier: MIT
// An installed program works from wherever it is moved to.
#include <gmock/gmock.h>

#include "cli/program.h"

namespace patina::cli_tests {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

class Installed : public ProgramTest {
  protected:
    void SetUp() override {
        const Outcome outcome =
            run_executable(PATINA_CMAKE, {"--install", PATINA_BUILD_DIR, "--prefix", at("first")});
        ASSERT_TRUE(succeeded(outcome)) << outcome.out;
        fs::rename(at("first"), at("moved"));
    }

    std::string program_ = at("moved/bin/patina");
};

TEST_F(Installed, FindsItsShadersAndPresetsAfterAMove) {
    const std::string ball = at("ball.glb");
    ASSERT_TRUE(succeeded(run_executable(program_, {"sample", "-o", ball})));
    const Outcome list = run_executable(program_, {"preset", "list", "--json"});
    ASSERT_TRUE(succeeded(list));
    EXPECT_THAT(list.out, HasSubstr(at("moved/share/patina/presets/")));
    // Wires have a geometry shader.
    EXPECT_TRUE(succeeded(run_executable(program_, {"render", ball, "--size", "32x32", "--samples",
                                                    "1", "--wires", "-o", at("a.png")})));
}

TEST_F(Installed, FindsWhatReadsAndWritesImagesAfterAMove) {
    const std::string ball = at("ball.glb");
    ASSERT_TRUE(succeeded(run_executable(program_, {"sample", "-o", ball})));
    const std::vector<std::string> render = {"render",    ball, "--size", "32x32",
                                             "--samples", "1",  "-o",     at("a.exr")};
    EXPECT_TRUE(succeeded(run_executable(program_, render)));
    fs::remove(at("moved/lib/patina/patina-openimageio.so"));
    const Outcome without = run_executable(program_, render);
    EXPECT_TRUE(failed_with_one_line(without));
    EXPECT_THAT(without.errors, HasSubstr("patina-openimageio.so"));
}

TEST_F(Installed, HasItsFontsAndTheirLicencesBesideIt) {
    const fs::path fonts = at("moved/share/patina/fonts");
    for (const char* font : {"Inter-Regular.otf", "Inter-Medium.otf", "Inter-SemiBold.otf",
                             "FontAwesome.otf", "Inter-LICENCE", "FontAwesome-LICENCE"})
        EXPECT_TRUE(fs::is_regular_file(fonts / font)) << font;
}

TEST_F(Installed, TellsBashHowToCompleteIt) {
    EXPECT_THAT(file_text(at("moved/share/bash-completion/completions/patina")),
                HasSubstr("complete -F _patina patina"));
}

TEST_F(Installed, KeepsNoPathOfWhereItWasBuilt) {
    EXPECT_THAT(file_text(program_), Not(HasSubstr(PATINA_SOURCE_DIR)));
    EXPECT_THAT(file_text(at("moved/lib/patina/patina-openimageio.so")),
                Not(HasSubstr(PATINA_SOURCE_DIR)));
}

}  // namespace
}  // namespace patina::cli_tests
