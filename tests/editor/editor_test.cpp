// SPDX-License-Identifier: MIT
// One walk through the editor as an artist would take it, and its parts on models of strangers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/editor_fixture.h"

namespace patina::editor_tests {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

TEST_F(EditorTest, WhatIsLayeredMaskedSavedAndReopenedIsWhatWasOnScreen) {
    const fs::path file = sample();
    const std::string untouched = bytes(file);
    Pixels on_screen;
    std::vector<std::string> rows;
    {
        Editor editor(display_.name(), folder_, arguments(file));
        ASSERT_TRUE(editor.wait_fact("document", "sample.glb"));
        ASSERT_TRUE(editor.settle());
        const Pixels at_first = editor.viewport();

        // Three layers, the last one masked.
        ASSERT_TRUE(add_layer(editor, "Add noise layer"));
        ASSERT_TRUE(add_layer(editor, "Add noise layer"));
        ASSERT_TRUE(add_layer(editor, "Add value layer"));
        const Pixels unmasked = editor.viewport();
        EXPECT_GT(different_share(at_first, unmasked), 0.01);
        ASSERT_TRUE(editor.click("Properties/Mask", "Add mask entry", "button"));
        ASSERT_TRUE(editor.click("Properties/Mask/Popup", "Worley noise (F1)", "item"));
        ASSERT_TRUE(editor.wait_for("a mask entry", [&] {
            return editor.find("Properties/Mask", "Worley noise (F1)", "mask entry").has_value();
        }));
        ASSERT_TRUE(editor.settle());
        const Pixels masked = editor.viewport();
        EXPECT_GT(different_share(unmasked, masked), 0.005);

        // Blend mode, then opacity by one drag: one step each.
        ASSERT_TRUE(editor.click("Properties", "Blend mode", "combo"));
        ASSERT_TRUE(editor.click("Properties/Popup", "Multiply", "item"));
        ASSERT_TRUE(editor.wait_for("Multiply", [&] {
            const auto mode = editor.find("Properties", "Blend mode", "combo");
            return mode && mode->value == "Multiply";
        }));
        const int steps = std::stoi(editor.fact("steps"));
        ASSERT_TRUE(editor.drag("Properties", "Opacity", "slider", 0.9, 0.5));
        ASSERT_TRUE(editor.wait_for("a lower opacity", [&] {
            const auto opacity = editor.find("Properties", "Opacity", "slider");
            return opacity && opacity->value != "100 %";
        }));
        ASSERT_TRUE(editor.settle());
        EXPECT_EQ(std::stoi(editor.fact("steps")), steps + 1);
        const std::string lowered = editor.find("Properties", "Opacity", "slider")->value;
        const Pixels blended = editor.viewport();
        EXPECT_GT(different_share(masked, blended), 0.005);

        // Undo and redo give back the very pixels.
        const auto opacity_is = [&](const std::string& value) {
            return editor.wait_for("opacity " + value, [&] {
                const auto opacity = editor.find("Properties", "Opacity", "slider");
                return opacity && opacity->value == value;
            });
        };
        editor.key("ctrl+z");
        ASSERT_TRUE(opacity_is("100 %"));
        editor.key("ctrl+shift+z");
        ASSERT_TRUE(opacity_is(lowered));
        EXPECT_LT(different_share(editor.viewport(), blended), 0.001);

        // Phong is another picture; PBR is the same one again.
        editor.key("o");
        ASSERT_TRUE(editor.wait_fact("left", "phong"));
        const Pixels phong = editor.viewport();
        EXPECT_GT(different_share(phong, blended), 0.01);
        editor.key("p");
        ASSERT_TRUE(editor.wait_fact("left", "pbr"));

        // Both at once, and the divider between them.
        editor.key("v");
        ASSERT_TRUE(editor.wait_fact("compare", "split"));
        ASSERT_TRUE(editor.settle());
        const Pixels split = editor.viewport();
        ASSERT_TRUE(editor.drag("Viewport", "Divider", "handle", 0.5, 4.5));
        ASSERT_TRUE(editor.wait_for("the divider to move",
                                    [&] { return editor.fact("divider") > "0.550"; }));
        EXPECT_GT(different_share(split, editor.viewport()), 0.005);
        ASSERT_TRUE(editor.click("Viewport bar", "Single", "segment"));
        ASSERT_TRUE(editor.wait_fact("compare", "single"));

        // Every channel of the strip is a picture of its own.
        Pixels last = editor.viewport();
        for (int digit = 1; digit <= 9; ++digit) {
            const std::string before = editor.fact("channel");
            editor.key(std::to_string(digit));
            ASSERT_TRUE(editor.wait_for("another channel",
                                        [&] { return editor.fact("channel") != before; }));
            const Pixels channel = editor.viewport();
            EXPECT_GT(different_share(last, channel), 0.002) << "channel " << digit;
            last = channel;
        }
        editor.key("0");
        ASSERT_TRUE(editor.wait_fact("channel", "final"));

        on_screen = editor.viewport();
        rows = editor.layers();
        EXPECT_EQ(editor.fact("edited"), "yes");
        editor.key("ctrl+s");
        ASSERT_TRUE(editor.wait_fact("edited", "no"));
        ASSERT_TRUE(editor.settle());
        editor.key("ctrl+q");
        EXPECT_EQ(editor.wait_for_end(), 0);
    }
    EXPECT_NE(bytes(file), untouched);
    EXPECT_THAT(stored(file), HasSubstr("multiply"));

    Editor again(display_.name(), folder_, arguments(file));
    ASSERT_TRUE(again.wait_fact("document", "sample.glb"));
    ASSERT_TRUE(again.settle());
    EXPECT_EQ(again.layers(), rows);
    EXPECT_EQ(again.fact("edited"), "no");
    EXPECT_LT(different_share(again.viewport(), on_screen), 0.005);
    again.key("ctrl+q");
    EXPECT_EQ(again.wait_for_end(), 0);
}

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
