// SPDX-License-Identifier: MIT
// The shelf of presets: favourites, and knobs that are turned before a preset is laid on.
#include <gtest/gtest.h>

#include <algorithm>

#include "editor/editor_fixture.h"

namespace patina::editor_tests {
namespace {

namespace fs = std::filesystem;

class ShelfTest : public EditorTest {
  protected:
    static std::vector<std::string> cards(const Editor& editor) {
        std::vector<std::string> result;
        for (const Control& control : editor.controls())
            if (control.kind == "card") result.push_back(control.label);
        return result;
    }
    /// Types into the search field and waits for all that it leaves; the card is to be among it.
    static bool search(const Editor& editor, const std::string& word, const std::string& card) {
        if (!editor.click("Shelf", "Search the shelf", "search")) return false;
        for (const char letter : word) editor.key(std::string(1, letter));
        return editor.wait_for("the presets that match", [&] {
            const std::optional<Control> field = editor.find("Shelf", "Search the shelf", "search");
            const std::vector<std::string> found = cards(editor);
            return field && field->value == word && found.size() < 4 &&
                   std::find(found.begin(), found.end(), card) != found.end();
        });
    }
};

TEST_F(ShelfTest, FavouritesAreShownAloneAndRemembered) {
    const fs::path file = sample();
    std::string favourite;
    {
        Editor editor(display_.name(), folder_, arguments(file));
        ASSERT_TRUE(open(editor, file));
        const std::vector<std::string> all = cards(editor);
        ASSERT_GT(all.size(), 2u);
        favourite = all[1];
        ASSERT_TRUE(editor.click("Shelf/" + favourite, "Not a favourite", "star"));
        ASSERT_TRUE(editor.wait_for("the star", [&] {
            return editor.find("Shelf/" + favourite, "Favourite", "star").has_value();
        }));
        // A star lays nothing on.
        EXPECT_EQ(editor.fact("edited"), "no");
        ASSERT_TRUE(editor.settle());
        editor.key("ctrl+q");
        EXPECT_EQ(editor.wait_for_end(), 0);
    }
    Editor again(display_.name(), folder_, arguments(file));
    ASSERT_TRUE(open(again, file));
    ASSERT_TRUE(again.click("Shelf", "Show favourites alone", "button"));
    ASSERT_TRUE(again.wait_for("one card", [&] { return cards(again).size() == 1; }));
    EXPECT_EQ(cards(again).front(), favourite);
}

TEST_F(ShelfTest, ADoubleClickLaysAPresetOnOnce) {
    const fs::path file = sample();
    Editor editor(display_.name(), folder_, arguments(file));
    ASSERT_TRUE(open(editor, file));
    ASSERT_TRUE(editor.double_click("Shelf", "Asphalt", "card"));
    ASSERT_TRUE(editor.wait_fact("layer", "Asphalt"));
    ASSERT_TRUE(editor.settle());
    EXPECT_EQ(editor.layers().size(), 2u);
    EXPECT_EQ(editor.fact("steps"), "2") << "opened, laid on";
}

TEST_F(ShelfTest, KnobsAreTurnedBeforeAPresetIsLaidOn) {
    const fs::path file = sample();
    Editor editor(display_.name(), folder_, arguments(file));
    ASSERT_TRUE(open(editor, file));
    const std::string before = editor.fact("content");
    ASSERT_TRUE(search(editor, "rusted", "Rusted iron"));
    // Lays it on and takes it back; empty when a control does not come, so that none is waited for
    // after that.
    const auto lay = [&](double share) {
        std::string content;
        if (!editor.open_menu("Shelf", "Rusted iron", "card") ||
            !editor.click("Shelf", "Turn its knobs\u2026", "item") ||
            (share != 0.5 && !editor.drag("Preset", "Rust", "slider", 0.5, share)) ||
            !editor.click("Preset", "Replace the stack", "button") ||
            !editor.wait_for("the stack", [&] { return editor.fact("content") != before; }))
            return content;
        content = editor.fact("content");
        editor.key("ctrl+z");
        return editor.wait_fact("content", before) ? content : std::string();
    };
    const std::string plain = lay(0.5);
    ASSERT_NE(plain, "");
    const std::string rusty = lay(0.9);
    ASSERT_NE(rusty, "");
    EXPECT_NE(plain, rusty);
    // A knob that stays where it stands changes nothing.
    ASSERT_TRUE(editor.click("Shelf", "Rusted iron", "card"));
    EXPECT_TRUE(editor.wait_for("the layers", [&] { return editor.fact("content") != before; }));
    editor.key("ctrl+z");
    ASSERT_TRUE(editor.wait_fact("content", before));
    ASSERT_TRUE(editor.open_menu("Shelf", "Rusted iron", "card"));
    ASSERT_TRUE(editor.click("Shelf", "Replace the stack", "item"));
    ASSERT_TRUE(editor.wait_for("the stack", [&] { return editor.fact("content") != before; }));
    EXPECT_EQ(editor.fact("content"), plain);
}

}  // namespace
}  // namespace patina::editor_tests
