// SPDX-License-Identifier: MIT
// The completion script, run by bash as bash runs it.
#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

#include "cli/program.h"

namespace patina::cli_tests {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;

class Completion : public ProgramTest {
  protected:
    void SetUp() override {
        const Outcome script = patina({"completion"});
        ASSERT_TRUE(succeeded(script));
        std::ofstream(at("patina.bash")) << script.out;
    }
    /// What is offered for the last of the words.
    std::vector<std::string> offered(const std::string& words) {
        const Outcome outcome = run_executable(
            "bash", {"-c", "source '" + at("patina.bash") + "'; patina() { '" PATINA_PROGRAM +
                               "' \"$@\"; }; COMP_WORDS=(" + words +
                               "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _patina 2>/dev/null; "
                               "printf '%s\\n' \"${COMPREPLY[@]}\""});
        std::vector<std::string> lines;
        std::istringstream text(outcome.out);
        for (std::string line; std::getline(text, line);)
            if (!line.empty()) lines.push_back(line);
        return lines;
    }
};

TEST_F(Completion, OffersCommandsOptionsAndTheirValues) {
    EXPECT_THAT(offered("patina ba"), ElementsAre("bake"));
    EXPECT_THAT(offered("patina ''"), Contains("explain"));
    EXPECT_THAT(offered("patina bake in.glb --map"),
                testing::UnorderedElementsAre("--maps", "--map-format"));
    EXPECT_THAT(offered("patina bake in.glb --map-format ''"),
                ElementsAre("png", "tif", "exr", "jpg"));
    EXPECT_THAT(offered("patina render in.glb --shading ph"), ElementsAre("phong"));
    EXPECT_THAT(offered("patina preset ''"), Contains("export"));
    EXPECT_THAT(offered("patina preset export --lic"), ElementsAre("--licence"));
}

TEST_F(Completion, OffersTheKnobsOfThePresetsThatWereGiven) {
    const auto knobs = offered("patina bake in.glb --preset rusted-iron --knob ''");
    EXPECT_THAT(knobs, Contains("rust="));
    EXPECT_THAT(knobs, Contains("rusted-iron/rust="));
    EXPECT_THAT(knobs, Not(Contains(testing::HasSubstr("painted-steel"))));
    EXPECT_THAT(offered("patina bake in.glb --preset rusted-iron --knob painted-st"), IsEmpty());
    EXPECT_THAT(offered("patina bake in.glb --knob painted-steel/"), Not(IsEmpty()));
}

TEST_F(Completion, OffersTheMaterialsOfTheFile) {
    const std::string file = sample();
    EXPECT_THAT(offered("patina explain '" + file + "' --material ''"),
                ElementsAre("Ball", "Stand"));
    // As bash splits "rusted-iron@B", and as it does not where "@" is no break.
    EXPECT_THAT(offered("patina bake '" + file + "' --preset rusted-iron @ B"),
                ElementsAre("Ball"));
    EXPECT_THAT(offered("patina bake '" + file + "' --preset rusted-iron @"),
                ElementsAre("Ball", "Stand"));
    EXPECT_THAT(offered("patina bake '" + file + "' --textures wood@S"), ElementsAre("wood@Stand"));
}

TEST_F(Completion, LeavesFilesToTheShell) {
    EXPECT_THAT(offered("patina bake mod"), IsEmpty());
    EXPECT_THAT(offered("patina bake in.glb -o ou"), IsEmpty());
    EXPECT_THAT(offered("patina info ''"), Not(Contains("--json")));
}

}  // namespace
}  // namespace patina::cli_tests
