// SPDX-License-Identifier: MIT
// The rules can fail: each is tried on a made-up tree that breaks it.
#include "structure/source_rules.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace patina::structure {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kSpdx = "// SPDX-License-Identifier: MIT\n";

TEST(SourceRules, IncludesAreFoundWithTheirLinesWhateverTheSpacing) {
    const auto found = includes_of("// #include \"no.h\"\n#include \"a/b.h\"\n  # include <c>\n");
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].text, "a/b.h");
    EXPECT_TRUE(found[0].quoted);
    EXPECT_EQ(found[0].line, 2);
    EXPECT_EQ(found[1].text, "c");
    EXPECT_FALSE(found[1].quoted);
}

TEST(SourceRules, AnIncludeUpwardsIsAFaultAndOneDownwardsIsNone) {
    const SourceTree tree = {{"engine/core/log.h", "#include \"scene/mesh.h\"\n"},
                             {"engine/scene/mesh.h", "#include \"core/result.h\"\n"},
                             {"engine/core/result.h", ""}};
    EXPECT_THAT(
        include_direction_faults(tree),
        ElementsAre("engine/core/log.h:1: engine/core may not include engine/scene/mesh.h"));
}

TEST(SourceRules, GlIsForTheRendererAlone) {
    const SourceTree tree = {{"engine/gl/texture.h", "#include <epoxy/gl.h>\n"},
                             {"engine/render/renderer.cpp", "#include \"gl/texture.h\"\n"},
                             {"engine/io/load.cpp", "#include \"gl/texture.h\"\n"},
                             {"app/editor/panel.cpp", "#include <epoxy/gl.h>\n"}};
    EXPECT_THAT(include_direction_faults(tree), ElementsAre(HasSubstr("engine/io/load.cpp:1")));
    EXPECT_THAT(library_faults(tree), ElementsAre(HasSubstr("app/editor/panel.cpp:1: OpenGL")));
}

TEST(SourceRules, AnIncludeThatIsNoPathFromTheRootsIsAFault) {
    const SourceTree tree = {{"engine/core/log.cpp", "#include \"log.h\"\n"},
                             {"engine/core/log.h", ""}};
    EXPECT_THAT(include_direction_faults(tree), ElementsAre(HasSubstr("is not a path from")));
}

TEST(SourceRules, AFileOutsideEveryLayerIsAFault) {
    const SourceTree tree = {{"engine/misc/thing.h", "#include \"core/log.h\"\n"},
                             {"engine/core/log.h", ""}};
    EXPECT_THAT(include_direction_faults(tree), ElementsAre(HasSubstr("lies in no layer")));
}

TEST(SourceRules, ACycleOfFilesIsNamedFromEndToEnd) {
    const SourceTree tree = {{"engine/core/a.h", "#include \"core/b.h\"\n"},
                             {"engine/core/b.h", "#include \"core/c.h\"\n"},
                             {"engine/core/c.h", "#include \"core/a.h\"\n"}};
    EXPECT_THAT(include_cycle_faults(tree),
                ElementsAre("cycle of files: engine/core/a.h -> engine/core/b.h -> "
                            "engine/core/c.h -> engine/core/a.h"));
}

TEST(SourceRules, ACycleOfFoldersIsAFaultThoughNoFileIncludesItself) {
    const SourceTree tree = {{"app/editor/theme.h", ""},
                             {"app/editor/frame.h", "#include \"editor/widgets/slider.h\"\n"},
                             {"app/editor/widgets/slider.h", "#include \"editor/theme.h\"\n"}};
    EXPECT_THAT(include_cycle_faults(tree),
                ElementsAre("cycle of folders: app/editor -> app/editor/widgets -> app/editor"));
}

TEST(SourceRules, ASourceWithoutTheLicenceIsAFaultAndAVersionLineMayComeFirst) {
    const SourceTree tree = {{"engine/core/a.h", kSpdx},
                             {"engine/core/b.h", "#pragma once\n"},
                             {"shaders/passes/a.frag", "#version 410 core\n" + kSpdx},
                             {"shaders/passes/a.geom", "#version 410 core\n"}};
    EXPECT_THAT(licence_faults(tree),
                ElementsAre(HasSubstr("engine/core/b.h"), HasSubstr("shaders/passes/a.geom")));
}

TEST(SourceRules, UnfinishedBusinessAndVagueNamesAreFaults) {
    const SourceTree tree = {{"engine/core/a.h", kSpdx + "// TO"
                                                         "DO later\n"},
                             {"engine/core/string_utils.h", kSpdx},
                             {"engine/core/utility_pole.h", kSpdx}};
    EXPECT_THAT(wording_faults(tree),
                ElementsAre(HasSubstr("engine/core/a.h:2"), HasSubstr("string_utils.h")));
}

TEST(SourceRules, SharedFormulaeMayNotIncludeAPassNorAPassAMissingFile) {
    const SourceTree tree = {{"shaders/shared/brdf.glsl", "#include \"passes/lights.glsl\"\n"},
                             {"shaders/passes/lights.glsl", "#include \"shared/lamp.glsl\"\n"},
                             {"shaders/passes/wires.geom", "#include \"passes/gone.glsl\"\n"},
                             {"shaders/shared/lamp.glsl", ""}};
    EXPECT_THAT(include_direction_faults(tree),
                ElementsAre(HasSubstr("shaders/passes/wires.geom:1"),
                            "shaders/shared/brdf.glsl:1: shaders/shared may not include "
                            "shaders/passes/lights.glsl"));
}

TEST(SourceRules, ADocumentOutsideOfTheRepositoryIsNoReason) {
    const SourceTree tree = {{"engine/core/a.h", kSpdx + "/// As DES"
                                                         "IGN section 3 says.\n"}};
    EXPECT_THAT(wording_faults(tree), ElementsAre(HasSubstr("engine/core/a.h:2")));
}

TEST(SourceRules, AGoodTreeHasNoFaults) {
    const SourceTree tree = {{"engine/core/log.h", kSpdx},
                             {"engine/scene/mesh.h", kSpdx + "#include \"core/log.h\"\n"}};
    EXPECT_THAT(include_direction_faults(tree), IsEmpty());
    EXPECT_THAT(library_faults(tree), IsEmpty());
    EXPECT_THAT(include_cycle_faults(tree), IsEmpty());
    EXPECT_THAT(licence_faults(tree), IsEmpty());
    EXPECT_THAT(wording_faults(tree), IsEmpty());
}

}  // namespace
}  // namespace patina::structure
