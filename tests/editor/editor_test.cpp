// SPDX-License-Identifier: MIT
// What saving and closing do with edits.
#include <gtest/gtest.h>

#include "editor/editor_fixture.h"

namespace patina::editor_tests {
namespace {

namespace fs = std::filesystem;

TEST_F(EditorTest, SavingWithoutAnEditLeavesTheFileAsItWas) {
    const fs::path file = sample();
    const std::string before = bytes(file);
    Editor editor(display_.name(), folder_, arguments(file));
    ASSERT_TRUE(editor.wait_fact("document", "sample.glb"));
    ASSERT_TRUE(editor.settle());
    ASSERT_TRUE(add_layer(editor, "Add value layer"));
    editor.key("ctrl+z");
    ASSERT_TRUE(editor.wait_fact("edited", "no"));
    editor.key("ctrl+s");
    ASSERT_TRUE(editor.wait_for("the saving to be told", [&] {
        return editor.find("Viewport/Toast", "Saved sample.glb", "toast").has_value();
    }));
    EXPECT_EQ(bytes(file), before);
}

TEST_F(EditorTest, ClosingWithEditsAsksFirst) {
    const fs::path file = sample();
    Editor editor(display_.name(), folder_, arguments(file));
    ASSERT_TRUE(editor.wait_fact("document", "sample.glb"));
    ASSERT_TRUE(editor.settle());
    ASSERT_TRUE(add_layer(editor, "Add value layer"));
    editor.key("ctrl+q");
    ASSERT_TRUE(editor.click("Question", "Cancel", "button"));
    ASSERT_TRUE(editor.wait_for("the question to go", [&] {
        return !editor.find("Question", "Cancel", "button").has_value();
    }));
    EXPECT_EQ(editor.fact("edited"), "yes");
    editor.key("ctrl+q");
    ASSERT_TRUE(editor.click("Question", "Discard", "button"));
    EXPECT_EQ(editor.wait_for_end(), 0);
}

}  // namespace
}  // namespace patina::editor_tests
