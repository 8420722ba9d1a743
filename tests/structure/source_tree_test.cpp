// SPDX-License-Identifier: MIT
// The rules hold in this tree.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "structure/source_rules.h"

namespace patina::structure {
namespace {

const SourceTree& this_tree() {
    static const SourceTree tree = read_source_tree(PATINA_SOURCE_DIR);
    return tree;
}

TEST(SourceTree, IsReadWhole) {
    EXPECT_TRUE(this_tree().contains("app/main.cpp"));
    EXPECT_TRUE(this_tree().contains("engine/core/result.h"));
    EXPECT_TRUE(this_tree().contains("CMakeLists.txt"));
}

TEST(SourceTree, KeepsTheDirectionsOfIncludes) {
    EXPECT_THAT(include_direction_faults(this_tree()), testing::IsEmpty());
}

TEST(SourceTree, KeepsLibrariesWhereTheyAreWrapped) {
    EXPECT_THAT(library_faults(this_tree()), testing::IsEmpty());
}

TEST(SourceTree, HasNoCycleOfFilesOrFolders) {
    EXPECT_THAT(include_cycle_faults(this_tree()), testing::IsEmpty());
}

TEST(SourceTree, StatesTheLicenceInEverySource) {
    EXPECT_THAT(licence_faults(this_tree()), testing::IsEmpty());
}

TEST(SourceTree, HasNothingUnfinishedAndNothingOfOneMachine) {
    EXPECT_THAT(wording_faults(this_tree()), testing::IsEmpty());
}

}  // namespace
}  // namespace patina::structure
