// SPDX-License-Identifier: MIT
// Controls of the Layer and Material tabs that do more than a field does: the curve, channels that
// are moved together, names, modes that are unset, presets that are made here.
#include <gtest/gtest.h>

#include "editor/editor_fixture.h"

namespace patina::editor_tests {
namespace {

namespace fs = std::filesystem;

const std::string kCurve = "Properties/Adjustment/Curve";

class ControlsTest : public EditorTest {
  protected:
    static std::size_t curve_points(const Editor& editor) {
        std::size_t count = 0;
        for (const Control& control : editor.controls()) count += control.kind == "point" ? 1 : 0;
        return count;
    }
    static bool wait_points(const Editor& editor, std::size_t count) {
        return editor.wait_for("so many points", [&] { return curve_points(editor) == count; });
    }
    static bool wait_value(const Editor& editor, const Control& control, const std::string& value) {
        return editor.wait_for(control.label + " to be " + value, [&] {
            const auto now = editor.find(control.place, control.label, control.kind);
            return now && now->value == value;
        });
    }
    /// The command line for a window in which the whole Layer tab is seen, with its Blend column.
    static std::vector<std::string> large(const fs::path& file) {
        return {"--window", "1600x1000", "--scale", "1", "--refine", "0", file.string()};
    }

    Display large_{1600, 1000};
};

/// A control of so many pixels about a place in another one.
Control spot(const Control& in, double x_share, double y_share) {
    Control at = in;
    at.x = in.x + static_cast<int>(x_share * in.width) - 1;
    at.y = in.y + static_cast<int>(y_share * in.height) - 1;
    at.width = at.height = 2;
    return at;
}

TEST_F(ControlsTest, APointOfACurveIsAddedDraggedAndRemovedInOneStepEach) {
    const fs::path file = sample();
    Editor editor(large_.name(), folder_, large(file));
    ASSERT_TRUE(open(editor, file));
    ASSERT_TRUE(add_layer(editor, "Add adjustment\u2026", "Curves"));
    const std::string straight = editor.fact("content");
    ASSERT_TRUE(wait_points(editor, 2));
    const auto graph = editor.find(kCurve, "Curve", "curve");
    ASSERT_TRUE(graph);

    // A press between the points adds one, which follows the pointer.
    ASSERT_TRUE(editor.drag_to(spot(*graph, 0.5, 0.5), spot(*graph, 0.3, 0.2)));
    ASSERT_TRUE(wait_points(editor, 3));
    ASSERT_TRUE(editor.settle());
    const std::string bent = editor.fact("content");
    EXPECT_NE(bent, straight);
    editor.key("ctrl+z");
    EXPECT_TRUE(editor.wait_fact("content", straight)) << "it was more than one step";
    editor.key("ctrl+shift+z");
    ASSERT_TRUE(editor.wait_fact("content", bent));

    // Dragged off the graph it is gone, and comes back by one step.
    const auto point = editor.find(kCurve, "Point 2", "point");
    ASSERT_TRUE(point);
    ASSERT_TRUE(editor.drag_to(*point, spot(*graph, 0.5, -0.6)));
    ASSERT_TRUE(wait_points(editor, 2));
    ASSERT_TRUE(editor.settle());
    EXPECT_EQ(editor.fact("content"), straight);
    editor.key("ctrl+z");
    ASSERT_TRUE(editor.wait_fact("content", bent));

    // Delete over the graph removes the point, not the layer.
    ASSERT_TRUE(editor.click(kCurve, "Point 2", "point"));
    const std::size_t layers = editor.layers().size();
    editor.key("Delete");
    ASSERT_TRUE(wait_points(editor, 2));
    EXPECT_EQ(editor.layers().size(), layers);
    EXPECT_TRUE(editor.wait_fact("content", straight));
}

TEST_F(ControlsTest, ChannelsThatLieAlikeAreMovedTogetherInOneStep) {
    const fs::path file = sample();
    Editor editor(large_.name(), folder_, large(file));
    ASSERT_TRUE(open(editor, file));
    ASSERT_TRUE(add_layer(editor, "Add procedural layer\u2026", "Bricks"));
    ASSERT_TRUE(editor.click("Properties/Roughness", "Roughness", "checkbox"));
    ASSERT_TRUE(editor.click("Properties/Roughness", "Roughness", "name"));
    ASSERT_TRUE(editor.click("Properties/Roughness/Source", "Procedural", "segment"));
    ASSERT_TRUE(editor.settle());
    const std::string before = editor.fact("content");
    ASSERT_TRUE(editor.drag("Properties/UV transform", "Rotation", "slider", 0.5, 0.7));
    ASSERT_TRUE(editor.settle());
    const std::string together = editor.fact("content");
    EXPECT_NE(together, before);
    // One step back and both lie as they did; one forth, and both are turned.
    editor.key("ctrl+z");
    ASSERT_TRUE(editor.wait_fact("content", before));
    editor.key("ctrl+shift+z");
    ASSERT_TRUE(editor.wait_fact("content", together));
    const auto turned = editor.find("Properties/UV transform", "Rotation", "slider");
    ASSERT_TRUE(turned);
    ASSERT_TRUE(editor.click("Properties/Base colour", "Base colour", "name"));
    ASSERT_TRUE(wait_value(editor, *turned, turned->value)) << "of the base colour, as it is now";

    // Not linked, only the one that is shown moves.
    ASSERT_TRUE(editor.click("Properties/UV transform", "Link channels", "button"));
    ASSERT_TRUE(editor.drag("Properties/UV transform", "Rotation", "slider", 0.7, 0.6));
    ASSERT_TRUE(editor.settle());
    const auto alone = editor.find("Properties/UV transform", "Rotation", "slider");
    ASSERT_TRUE(alone);
    EXPECT_NE(alone->value, turned->value);
    ASSERT_TRUE(editor.click("Properties/Roughness", "Roughness", "name"));
    EXPECT_TRUE(wait_value(editor, *turned, turned->value));
}

TEST_F(ControlsTest, AMaskEntryIsMovedAndRenamed) {
    const fs::path file = sample();
    Editor editor(large_.name(), folder_, large(file));
    ASSERT_TRUE(open(editor, file));
    ASSERT_TRUE(add_layer(editor, "Add value layer"));
    ASSERT_TRUE(editor.click("Properties/Mask", "Add mask entry", "button"));
    ASSERT_TRUE(editor.click("Properties/Mask/Popup", "Bricks", "item"));
    ASSERT_TRUE(editor.click("Properties/Mask/Bricks", "Bricks", "mask entry"));
    const std::string transform = "Properties/Mask/Bricks/UV transform";
    ASSERT_TRUE(editor.wait_for(
        "its transform", [&] { return editor.find(transform, "Rotation", "slider").has_value(); }));
    ASSERT_TRUE(editor.settle());
    const std::string before = editor.fact("content");
    ASSERT_TRUE(editor.drag(transform, "Rotation", "slider", 0.5, 0.7));
    ASSERT_TRUE(editor.settle());
    EXPECT_NE(editor.fact("content"), before);

    ASSERT_TRUE(editor.open_menu("Properties/Mask/Bricks", "Bricks", "mask entry"));
    ASSERT_TRUE(editor.click("Properties/Mask/Bricks/Popup", "Rename entry", "item"));
    for (const char* letter : {"W", "a", "l", "l", "Return"}) editor.key(letter);
    EXPECT_TRUE(editor.wait_for("the name", [&] {
        return editor.find("Properties/Mask/Wall", "Wall", "mask entry").has_value();
    }));
}

TEST_F(ControlsTest, AChannelsBlendGoesBackToTheLayers) {
    const fs::path file = sample();
    Editor editor(large_.name(), folder_, large(file));
    ASSERT_TRUE(open(editor, file));
    ASSERT_TRUE(add_layer(editor, "Add value layer"));
    const auto combo = editor.find("Properties/Roughness", "Channel blend", "combo");
    ASSERT_TRUE(combo);
    const std::string unset = editor.fact("content");
    ASSERT_TRUE(editor.click("Properties/Roughness", "Channel blend", "combo"));
    ASSERT_TRUE(editor.click("Properties/Roughness/Popup", "Multiply", "item"));
    ASSERT_TRUE(wait_value(editor, *combo, "Multiply"));
    ASSERT_TRUE(editor.click("Properties/Roughness", "Channel blend", "combo"));
    ASSERT_TRUE(
        editor.click("Properties/Roughness/Popup", "Default (" + combo->value + ")", "item"));
    ASSERT_TRUE(wait_value(editor, *combo, combo->value));
    EXPECT_TRUE(editor.wait_fact("content", unset));
}

TEST_F(ControlsTest, ALayerThatIsSavedAsAPresetIsInTheShelfNowAndLater) {
    const fs::path file = sample();
    {
        Editor editor(large_.name(), folder_, large(file));
        ASSERT_TRUE(open(editor, file));
        ASSERT_TRUE(add_layer(editor, "Add value layer"));
        ASSERT_TRUE(editor.click("Top bar", "Layer", "menu"));
        ASSERT_TRUE(editor.click("Top bar", "Save layer as preset\u2026", "item"));
        ASSERT_TRUE(editor.wait_for("the dialog", [&] {
            return editor.find("Save as preset", "Name", "text").has_value();
        }));
        for (const char* key : {"ctrl+a", "Z", "i", "n", "c"}) editor.key(key);
        ASSERT_TRUE(editor.wait_for("the name", [&] {
            const auto name = editor.find("Save as preset", "Name", "text");
            return name && name->value == "Zinc";
        }));
        ASSERT_TRUE(editor.click("Save as preset", "Author", "text"));
        for (const char* key : {"ctrl+a", "M", "e"}) editor.key(key);
        ASSERT_TRUE(editor.click("Save as preset", "Save", "button"));
        ASSERT_TRUE(editor.click("Shelf", "Search the shelf", "search"));
        for (const char* key : {"Z", "i", "n", "c"}) editor.key(key);
        EXPECT_TRUE(editor.wait_for(
            "the card", [&] { return editor.find("Shelf", "Zinc", "card").has_value(); }));
        EXPECT_TRUE(fs::exists(folder_ / "settings" / "patina" / "presets" / "zinc.json"));
    }
    Editor again(large_.name(), folder_, large(file));
    ASSERT_TRUE(open(again, file));
    ASSERT_TRUE(again.click("Shelf", "Search the shelf", "search"));
    for (const char* key : {"Z", "i", "n", "c"}) again.key(key);
    EXPECT_TRUE(again.wait_for("the card",
                               [&] { return again.find("Shelf", "Zinc", "card").has_value(); }));
}

}  // namespace
}  // namespace patina::editor_tests
