// SPDX-License-Identifier: MIT
// What is looked at and how: no part of the document, worked by keyboard too, kept for next time.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>

#include "editor/editor_fixture.h"
#include "support/triangle_with_cameras.h"

namespace patina::editor_tests {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;

class ViewTest : public EditorTest {};

TEST_F(ViewTest, FoldingAGroupIsNoEdit) {
    Editor editor(display_.name(), folder_, arguments(sample()));
    ASSERT_TRUE(open(editor, "sample.glb"));
    ASSERT_TRUE(add_layer(editor, "Add value layer"));
    editor.key("ctrl+g");
    ASSERT_TRUE(editor.wait_fact("layer", "Group"));
    const std::string steps = editor.fact("steps");
    const std::string content = editor.fact("content");
    const std::vector<std::string> unfolded = editor.layers();
    ASSERT_TRUE(editor.click("Layers/Group", "Unfolded", "angle"));
    ASSERT_TRUE(editor.wait_for("the group to fold",
                                [&] { return editor.layers().size() + 1 == unfolded.size(); }));
    EXPECT_EQ(editor.fact("steps"), steps);
    EXPECT_EQ(editor.fact("content"), content);
    ASSERT_TRUE(editor.click("Layers/Group", "Unfolded", "angle"));
    ASSERT_TRUE(editor.wait_for("it to unfold", [&] { return editor.layers() == unfolded; }));
}

TEST_F(ViewTest, TheKeyboardReachesAndPressesControls) {
    Editor editor(display_.name(), folder_, arguments(sample()));
    ASSERT_TRUE(open(editor, "sample.glb"));
    // The first control of the window is the File menu; its first row is Open.
    editor.key("Tab");
    editor.key("Return");
    ASSERT_TRUE(editor.wait_for("the File menu", [&] {
        return editor.find("Top bar/Popup", "Save as\u2026", "item").has_value();
    }));
    editor.key("Down");
    editor.key("Return");
    ASSERT_TRUE(editor.wait_for(
        "the dialog", [&] { return editor.find("File dialog", "Open", "button").has_value(); }));
    editor.key("Escape");
    ASSERT_TRUE(editor.wait_for(
        "it to close", [&] { return !editor.find("File dialog", "Open", "button").has_value(); }));
}

TEST_F(ViewTest, TheLayoutIsAsItWasLeft) {
    const fs::path file = sample();
    const auto width_of = [](const Editor& editor) {
        const auto row = editor.find("Layers", "Imported textures", "row");
        return row ? row->width : 0;
    };
    int before = 0;
    int after = 0;
    {
        Editor editor(display_.name(), folder_, arguments(file));
        ASSERT_TRUE(open(editor, "sample.glb"));
        before = width_of(editor);
        ASSERT_TRUE(editor.drag("", "Left splitter", "splitter", 0.5, -5.0));
        ASSERT_TRUE(editor.settle());
        after = width_of(editor);
        EXPECT_LT(after, before);
        ASSERT_TRUE(editor.click("Shelf", "Fold the shelf", "button"));
        ASSERT_TRUE(editor.settle());
        editor.key("ctrl+q");
        EXPECT_EQ(editor.wait_for_end(), 0);
    }
    Editor again(display_.name(), folder_, arguments(file));
    ASSERT_TRUE(open(again, "sample.glb"));
    EXPECT_EQ(width_of(again), after);
    EXPECT_TRUE(again.find("Shelf", "Unfold the shelf", "button").has_value());
}

TEST_F(ViewTest, ANarrowWindowHasItsLayersInATab) {
    Editor editor(display_.name(), folder_,
                  {"--window", "1100x700", "--scale", "1", sample().string()});
    ASSERT_TRUE(open(editor, "sample.glb"));
    EXPECT_THAT(editor.layers(), ElementsAre("Imported textures"));
    ASSERT_TRUE(editor.click("Properties", "Layer", "tab"));
    ASSERT_TRUE(editor.wait_for("the layer's opacity", [&] {
        return editor.find("Properties", "Opacity", "slider").has_value();
    }));
    EXPECT_TRUE(editor.layers().empty());
}

TEST_F(ViewTest, WhatIsExplainedFollowsEdits) {
    Editor editor(display_.name(), folder_, arguments(sample()));
    ASSERT_TRUE(open(editor, "sample.glb"));
    editor.key("i");
    ASSERT_TRUE(editor.settle());
    ASSERT_TRUE(editor.click("Viewport", "Model", "viewport"));
    const auto steps = [&] {
        std::vector<std::string> names;
        for (const Control& control : editor.controls())
            if (control.kind == "step") names.push_back(control.label);
        return names;
    };
    ASSERT_TRUE(editor.wait_for("the explanation", [&] { return steps().size() == 1; }));
    ASSERT_TRUE(add_layer(editor, "Add procedural layer\u2026", "Perlin noise"));
    ASSERT_TRUE(editor.wait_for("the new layer in it", [&] { return steps().size() == 2; }));
    editor.key("ctrl+z");
    ASSERT_TRUE(editor.wait_for("the old explanation", [&] { return steps().size() == 1; }));
}

TEST_F(ViewTest, TheCameraLooksFromEverySideThroughAnyLensAndFramesAMaterial) {
    Editor editor(display_.name(), folder_, arguments(sample()));
    ASSERT_TRUE(open(editor, "sample.glb"));
    const auto choose = [&](const std::string& item) {
        EXPECT_TRUE(editor.click("Viewport/Tools", "Camera", "button"));
        EXPECT_TRUE(editor.click("Viewport/Tools/Popup", item, "item"));
        EXPECT_TRUE(editor.settle());
        return editor.fact("camera");
    };
    std::set<std::string> places = {editor.fact("camera")};
    for (const std::string side : {"Front", "Back", "Left", "Right", "Top", "Bottom"})
        places.insert(choose(side + " view"));
    EXPECT_EQ(places.size(), 7u);
    const std::string framed = choose("Three-quarter view");
    EXPECT_EQ(choose("Orthographic"), framed);
    EXPECT_EQ(editor.fact("lens"), "orthographic");
    EXPECT_EQ(choose("Orthographic"), framed);
    EXPECT_EQ(editor.fact("lens"), "30");
    ASSERT_TRUE(editor.click("Viewport/Axes", "Y", "axis"));
    ASSERT_TRUE(
        editor.wait_for("the view from above", [&] { return editor.fact("camera") != framed; }));
    EXPECT_EQ(choose("Three-quarter view"), framed);
    // The ball is smaller than the ball on its stand.
    editor.key("shift+f");
    ASSERT_TRUE(editor.wait_for("the ball alone", [&] { return editor.fact("camera") != framed; }));
    editor.key("f");
    ASSERT_TRUE(editor.wait_fact("camera", framed));
    EXPECT_EQ(editor.fact("edited"), "no");
}

TEST_F(ViewTest, TheCameraMenuGoesToTheCamerasOfTheFile) {
    const fs::path file = folder_ / "triangle.gltf";
    std::ofstream(file) << tests::kTriangleWithCameras;
    Editor editor(display_.name(), folder_, arguments(file));
    ASSERT_TRUE(open(editor, "triangle.gltf"));
    const auto choose = [&](const std::string& item) {
        ASSERT_TRUE(editor.click("Viewport/Tools", "Camera", "button"));
        ASSERT_TRUE(editor.click("Viewport/Tools/Popup", item, "item"));
        ASSERT_TRUE(editor.settle());
    };
    choose("Close");
    EXPECT_EQ(editor.fact("lens"), "45");
    const std::string close = editor.fact("camera");
    choose("Side");
    EXPECT_EQ(editor.fact("lens"), "orthographic");
    EXPECT_NE(editor.fact("camera"), close);
}

TEST_F(ViewTest, EveryShapeIsThereWithoutAFile) {
    Editor editor(display_.name(), folder_, {"--window", "1280x720", "--scale", "1"});
    for (const std::string shape : {"sphere", "rounded cube", "plane", "cylinder", "torus"}) {
        ASSERT_TRUE(editor.click("Top bar", "File", "menu"));
        ASSERT_TRUE(editor.click("Top bar/Popup", "New " + shape, "item"));
        ASSERT_TRUE(editor.wait_fact(
            "document", (shape == "rounded cube" ? "rounded_cube" : shape) + std::string(".glb")));
        EXPECT_EQ(editor.fact("edited"), "no");
    }
}

TEST_F(ViewTest, ThePlainBackgroundTakesAColour) {
    Editor editor(display_.name(), folder_, arguments(sample()));
    ASSERT_TRUE(open(editor, "sample.glb"));
    ASSERT_TRUE(editor.click("Viewport bar", "Background and edges", "button"));
    EXPECT_FALSE(editor.find("Viewport bar/Popup", "Background colour", "color").has_value());
    ASSERT_TRUE(editor.click("Viewport bar/Popup", "Colour", "item"));
    ASSERT_TRUE(editor.click("Viewport bar", "Background and edges", "button"));
    ASSERT_TRUE(editor.wait_for("its colour", [&] {
        return editor.find("Viewport bar/Popup", "Background colour", "color").has_value();
    }));
    EXPECT_EQ(editor.find("Viewport bar/Popup", "Background colour", "color")->value, "#191919");
    EXPECT_EQ(editor.fact("edited"), "no");
}

TEST_F(ViewTest, PhongTakesItsOwnSettingsWhereTheirBoxesAreTicked) {
    Editor editor(display_.name(), folder_, arguments(sample()));
    ASSERT_TRUE(open(editor, "sample.glb"));
    editor.key("o");
    ASSERT_TRUE(editor.wait_fact("left", "phong"));
    ASSERT_TRUE(editor.click("Properties", "Material", "tab"));
    ASSERT_TRUE(editor.settle());
    const std::string content = editor.fact("content");
    EXPECT_FALSE(editor.find("Properties/Shading terms", "Exponent", "slider").has_value());
    ASSERT_TRUE(editor.click("Properties/Shading terms", "Set exponent", "checkbox"));
    ASSERT_TRUE(editor.wait_for("the exponent", [&] {
        const auto field = editor.find("Properties/Shading terms", "Exponent", "slider");
        return field && field->value == "32";
    }));
    ASSERT_TRUE(editor.click("Properties/Shading terms", "Set exponent", "checkbox"));
    ASSERT_TRUE(editor.wait_for("it to go", [&] {
        return !editor.find("Properties/Shading terms", "Exponent", "slider").has_value();
    }));
    EXPECT_EQ(editor.fact("content"), content) << "no edit of the document";
}

TEST_F(ViewTest, TwoViewsAndTheirDifferenceSayHowFarTheyAreApart) {
    Editor editor(display_.name(), folder_, arguments(sample()));
    ASSERT_TRUE(open(editor, "sample.glb"));
    ASSERT_TRUE(editor.click("Viewport bar", "Two views", "segment"));
    ASSERT_TRUE(editor.click("Properties", "Compare", "tab"));
    ASSERT_TRUE(editor.click("Properties", "Show the difference beside them", "checkbox"));
    ASSERT_TRUE(editor.wait_for(
        "the histogram", [&] { return editor.find("Difference", "mean", "figure").has_value(); }));
    ASSERT_TRUE(editor.settle());
    EXPECT_NE(editor.find("Difference", "mean", "figure")->value, "mean 0.000");
    // In the middle of the middle view lies the model.
    ASSERT_TRUE(editor.click("Viewport", "Model", "viewport"));
    ASSERT_TRUE(editor.wait_for(
        "values", [&] { return editor.find("Properties", "Luminance", "figure").has_value(); }));
    // The same shading at both sides does not differ.
    ASSERT_TRUE(editor.click("Properties", "Right", "combo"));
    ASSERT_TRUE(editor.click("Properties/Popup", "PBR", "item"));
    ASSERT_TRUE(editor.wait_for("no difference", [&] {
        const auto mean = editor.find("Difference", "mean", "figure");
        return mean && mean->value == "mean 0.000";
    }));
    EXPECT_EQ(editor.fact("edited"), "no");
}

TEST_F(ViewTest, ThePictureRefinesWhileNothingMovesAndStartsAgainAfterEveryChange) {
    Editor editor(display_.name(), folder_,
                  {"--window", "1280x720", "--scale", "1", "--refine", "20", sample().string()});
    ASSERT_TRUE(open(editor, "sample.glb"));
    const auto refined = [&] {
        EXPECT_TRUE(editor.wait_fact("samples", "20/20"));
        return model_part(editor.viewport());
    };
    const Pixels before = refined();
    editor.key("bracketright");
    ASSERT_TRUE(editor.settle());
    EXPECT_GT(different_share(refined(), before), 0.0);
    editor.key("bracketleft");
    ASSERT_TRUE(editor.settle());
    EXPECT_TRUE(refined() == before);
    // A channel holds exact numbers.
    editor.key("3");
    ASSERT_TRUE(editor.wait_fact("samples", "0/0"));
    editor.key("0");
    EXPECT_TRUE(refined() == before);
    // Switched off and on again.
    ASSERT_TRUE(editor.click("Viewport bar", "Background and edges", "button"));
    ASSERT_TRUE(editor.click("Viewport bar/Popup", "Refine when idle", "item"));
    ASSERT_TRUE(editor.wait_fact("samples", "0/0"));
    EXPECT_GT(different_share(model_part(editor.viewport()), before), 0.0);
    ASSERT_TRUE(editor.click("Viewport bar", "Background and edges", "button"));
    ASSERT_TRUE(editor.click("Viewport bar/Popup", "Refine when idle", "item"));
    EXPECT_TRUE(refined() == before);
    EXPECT_EQ(editor.fact("edited"), "no");
}

}  // namespace
}  // namespace patina::editor_tests
