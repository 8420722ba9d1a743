// SPDX-License-Identifier: MIT
// Materials that are made, copied, drawn on other parts of the model, saved and reopened.
#include <gtest/gtest.h>

#include "editor/editor_fixture.h"

namespace patina::editor_tests {
namespace {

namespace fs = std::filesystem;

class MaterialsTest : public EditorTest {
  protected:
    static std::size_t rows(const Editor& editor) {
        std::size_t count = 0;
        for (const Control& control : editor.controls())
            if (control.place.rfind("Materials/", 0) == 0 && control.kind == "row") ++count;
        return count;
    }
    static bool wait_rows(const Editor& editor, std::size_t count) {
        return editor.wait_for("so many materials", [&] { return rows(editor) == count; });
    }
};

TEST_F(MaterialsTest, AMaterialIsMadeDraggedOntoThePartAndReadBack) {
    const fs::path file = sample();
    std::string content;
    Pixels painted;
    {
        Editor editor(display_.name(), folder_, arguments(file));
        ASSERT_TRUE(open(editor, file));
        ASSERT_TRUE(editor.settle());
        const std::size_t before = rows(editor);
        const std::string opened = editor.fact("content");
        const Pixels plain = editor.viewport();
        ASSERT_TRUE(editor.click("Materials", "Add material", "button"));
        ASSERT_TRUE(wait_rows(editor, before + 1));
        for (const char* letter : {"T", "i", "n", "Return"}) editor.key(letter);
        ASSERT_TRUE(editor.wait_fact("material", "Tin"));
        ASSERT_TRUE(editor.click("Shelf", "Brick wall", "card"));
        ASSERT_TRUE(editor.wait_for("a layer", [&] { return editor.layers().size() == 1; }));
        ASSERT_TRUE(editor.settle());
        EXPECT_LT(different_share(model_part(plain), model_part(editor.viewport())), 0.001)
            << "it is drawn on nothing yet";
        const auto row = editor.find("Materials/Tin", "Tin", "row");
        const auto model = editor.find("Viewport", "Model", "viewport");
        ASSERT_TRUE(row && model);
        content = editor.fact("content");
        ASSERT_TRUE(editor.drag_to(*row, *model));
        ASSERT_TRUE(editor.wait_for("the part", [&] { return editor.fact("content") != content; }));
        content = editor.fact("content");
        // Its message lies over the model.
        ASSERT_TRUE(editor.click("Viewport/Toast", "Dismiss", "button"));
        ASSERT_TRUE(editor.settle());
        painted = editor.viewport();
        EXPECT_GT(different_share(model_part(plain), model_part(painted)), 0.05);
        // Four steps back and forth again: made, named, layered, assigned.
        for (int i = 0; i < 4; ++i) editor.key("ctrl+z");
        ASSERT_TRUE(editor.wait_fact("content", opened));
        for (int i = 0; i < 4; ++i) editor.key("ctrl+shift+z");
        ASSERT_TRUE(editor.wait_fact("content", content));
        editor.key("ctrl+s");
        ASSERT_TRUE(editor.wait_fact("edited", "no"));
        ASSERT_TRUE(editor.settle());
        editor.key("ctrl+q");
        EXPECT_EQ(editor.wait_for_end(), 0);
    }
    Editor again(display_.name(), folder_, arguments(file));
    ASSERT_TRUE(open(again, file));
    EXPECT_TRUE(again.wait_fact("content", content));
    ASSERT_TRUE(again.settle());
    EXPECT_LT(different_share(model_part(painted), model_part(again.viewport())), 0.01);
}

TEST_F(MaterialsTest, ACopyIsTickedOntoAPartAndDeletedAgain) {
    const fs::path file = sample();
    Editor editor(display_.name(), folder_, arguments(file));
    ASSERT_TRUE(open(editor, file));
    const std::size_t before = rows(editor);
    const std::string opened = editor.fact("content");
    ASSERT_TRUE(editor.click("Top bar", "Material", "menu"));
    ASSERT_TRUE(editor.click("Top bar", "Duplicate material", "item"));
    ASSERT_TRUE(wait_rows(editor, before + 1));
    editor.key("Return");  // the name is offered for typing and stays
    ASSERT_TRUE(editor.wait_for(
        "the copy", [&] { return editor.fact("material").find(" copy") != std::string::npos; }));
    ASSERT_TRUE(editor.click("Properties", "Material", "tab"));
    ASSERT_TRUE(editor.click("Properties", "Parts", "section"));
    ASSERT_TRUE(editor.wait_for("the parts", [&] {
        for (const Control& control : editor.controls())
            if (control.place.find("Parts/") != std::string::npos) return true;
        return false;
    }));
    std::vector<Control> parts;
    for (const Control& control : editor.controls())
        if (control.place.find("Parts/") != std::string::npos && control.kind == "checkbox")
            parts.push_back(control);
    ASSERT_FALSE(parts.empty());
    EXPECT_EQ(parts.front().value, "off");
    const std::string unassigned = editor.fact("content");
    ASSERT_TRUE(editor.click(parts.front().place, parts.front().label, "checkbox"));
    ASSERT_TRUE(editor.wait_for("the tick", [&] {
        const auto part = editor.find(parts.front().place, parts.front().label, "checkbox");
        return part && part->value == "on" && editor.fact("content") != unassigned;
    }));
    ASSERT_TRUE(editor.click("Top bar", "Material", "menu"));
    ASSERT_TRUE(editor.click("Top bar", "Delete added material", "item"));
    ASSERT_TRUE(wait_rows(editor, before));
    EXPECT_TRUE(editor.wait_fact("content", opened)) << "its part is the file's again";
}

TEST_F(MaterialsTest, WiresAndTheCheckerComeAndGoByTheirKeys) {
    const fs::path file = sample();
    Editor editor(display_.name(), folder_, arguments(file));
    ASSERT_TRUE(open(editor, file));
    ASSERT_TRUE(editor.settle());
    const Pixels plain = editor.viewport();
    editor.key("w");
    ASSERT_TRUE(editor.settle());
    EXPECT_GT(different_share(model_part(plain), model_part(editor.viewport())), 0.02);
    editor.key("w");
    ASSERT_TRUE(editor.settle());
    EXPECT_LT(different_share(model_part(plain), model_part(editor.viewport())), 0.001);
    editor.key("u");
    ASSERT_TRUE(editor.wait_fact("channel", "uv-checker"));
    ASSERT_TRUE(editor.settle());
    EXPECT_GT(different_share(model_part(plain), model_part(editor.viewport())), 0.2);
    editor.key("u");
    EXPECT_TRUE(editor.wait_fact("channel", "final"));
    EXPECT_EQ(editor.fact("edited"), "no") << "looking is no edit";
}

}  // namespace
}  // namespace patina::editor_tests
