// SPDX-License-Identifier: MIT
// Files that come from elsewhere: dropped on the window, named by a document, kept beside a save.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "core/files.h"
#include "document/edits.h"
#include "editor/editor_fixture.h"
#include "io/image_decode.h"
#include "io/load.h"
#include "io/save.h"

namespace patina::editor_tests {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;

class FilesTest : public EditorTest {
  protected:
    /// A panorama of one colour, in the format of Radiance.
    static void write_panorama(const fs::path& file) {
        std::ofstream out(file, std::ios::binary);
        out << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4 +X 8\n";
        for (int i = 0; i < 4 * 8; ++i) out << "\x80\x40\x20\x81";
    }
    /// What a hostile file may say.
    static void light_by(const fs::path& model, const std::string& environment) {
        const auto loaded = io::load_document(model);
        ASSERT_TRUE(loaded);
        const auto lit = set_environment_name(environment).apply(*loaded->document);
        ASSERT_TRUE(lit);
        ASSERT_TRUE(io::save_document(*lit, *loaded->images, model));
    }
    /// An image that is surely one: a picture of the sample.
    fs::path image(const std::string& size = "64x64") const {
        fs::path file = folder_ / "picture.png";
        EXPECT_EQ(run_tool({PATINA_PROGRAM, "render", sample().string(), "--size", size,
                            "--samples", "1", "-o", file.string()},
                           ""),
                  0);
        return file;
    }
};

TEST_F(FilesTest, WhatIsDroppedIsOpenedAddedOrLights) {
    const fs::path file = sample();
    const fs::path picture = image();
    const fs::path panorama = folder_ / "dawn.hdr";
    write_panorama(panorama);
    Editor editor(display_.name(), folder_, {"--window", "1280x720", "--scale", "1"});
    ASSERT_TRUE(editor.wait_for("the empty state", [&] {
        return editor.find("Viewport", "Try the sample", "button").has_value();
    }));
    // On the empty viewport a model is opened.
    ASSERT_TRUE(editor.drop(file, "Viewport", "Try the sample", "button"));
    ASSERT_TRUE(open(editor, file));

    // On the layers an image becomes a layer above the selected one, and is selected.
    const std::vector<std::string> rows = editor.layers();
    ASSERT_EQ(rows.size(), 1u);
    ASSERT_TRUE(add_layer(editor, "Add value layer"));
    ASSERT_TRUE(editor.click("Layers", rows[0], "row"));
    ASSERT_TRUE(editor.drop(picture, "Layers", "Fill", "row"));
    ASSERT_TRUE(editor.wait_for("a layer", [&] { return editor.layers().size() == 3; }));
    EXPECT_THAT(editor.layers(), ElementsAre("Fill", "picture.png", rows[0]));
    EXPECT_EQ(editor.fact("layer"), "picture.png");

    // On the model a panorama lights it: one step, which undo takes back.
    const Pixels studio = editor.viewport();
    ASSERT_TRUE(editor.drop(panorama, "Viewport", "Model", "viewport"));
    ASSERT_TRUE(editor.wait_fact("environment", "dawn.hdr"));
    EXPECT_GT(different_share(studio, editor.viewport()), 0.01);
    editor.key("ctrl+z");
    ASSERT_TRUE(editor.wait_fact("environment", "studio"));

    // What is none of these is refused in a sentence, and that is in the log.
    std::ofstream(folder_ / "notes.txt") << "hello";
    ASSERT_TRUE(editor.drop(folder_ / "notes.txt", "Viewport", "Model", "viewport"));
    ASSERT_TRUE(editor.click("Viewport/Toast", "Show log", "button"));
    ASSERT_TRUE(editor.wait_for("the log", [&] {
        return editor
            .find(
                "Log",
                "Cannot use notes.txt: not a model, image, preset, panorama or folder of textures",
                "log line")
            .has_value();
    }));
}

TEST_F(FilesTest, AFolderOfTexturesThatIsDroppedBecomesOneLayer) {
    const fs::path file = sample();
    const fs::path textures = folder_ / "old_oak";
    fs::create_directories(textures);
    fs::copy(image(), textures / "old_oak_basecolor.png");
    fs::copy(image("32x32"), textures / "old_oak_rough.png");
    Editor editor(display_.name(), folder_, arguments(file));
    ASSERT_TRUE(open(editor, file));
    const std::string before = editor.fact("content");
    ASSERT_TRUE(editor.drop(textures, "Viewport", "Model", "viewport"));
    ASSERT_TRUE(editor.wait_fact("layer", "old_oak"));
    EXPECT_EQ(editor.layers().front(), "old_oak");
    ASSERT_TRUE(editor.wait_for("its channels", [&] {
        const auto name = [&](const std::string& channel, const std::string& source) {
            const auto found = editor.find("Properties/" + channel, "Source", "source");
            return found && found->value == source;
        };
        return name("Base colour", "old_oak_basecolor.png") &&
               name("Roughness", "old_oak_rough.png");
    }));
    // One step, with its images.
    editor.key("ctrl+z");
    ASSERT_TRUE(editor.wait_fact("content", before));
}

TEST_F(FilesTest, GroupsReopenAsTheyWereFolded) {
    const fs::path file = sample();
    {
        Editor editor(display_.name(), folder_, arguments(file));
        ASSERT_TRUE(open(editor, file));
        ASSERT_TRUE(add_layer(editor, "Add value layer"));
        editor.key("ctrl+g");
        ASSERT_TRUE(editor.wait_for("a group", [&] { return editor.layers().size() == 3; }));
        ASSERT_TRUE(editor.click("Layers", "Unfolded", "angle"));
        ASSERT_TRUE(editor.wait_for("it to fold", [&] { return editor.layers().size() == 2; }));
        editor.key("ctrl+s");
        ASSERT_TRUE(editor.wait_fact("edited", "no"));
        ASSERT_TRUE(editor.settle());
    }
    Editor again(display_.name(), folder_, arguments(file));
    ASSERT_TRUE(open(again, file));
    EXPECT_EQ(again.layers().size(), 2u);
}

TEST_F(FilesTest, ADocumentMayOnlyBeLitByFilesBelowItsOwnFolder) {
    const fs::path secret = folder_ / "secret.hdr";
    write_panorama(secret);
    const fs::path inner = folder_ / "inner";
    fs::create_directories(inner);
    write_panorama(inner / "day.hdr");
    const fs::path model = inner / "model.glb";
    fs::rename(sample(), model);
    {
        // Chosen by hand it lights, and is named by its path from the model.
        Editor editor(display_.name(), folder_, arguments(model));
        ASSERT_TRUE(open(editor, model));
        ASSERT_TRUE(editor.drop(inner / "day.hdr", "Viewport", "Model", "viewport"));
        ASSERT_TRUE(editor.wait_fact("environment", "day.hdr"));
        editor.key("ctrl+s");
        ASSERT_TRUE(editor.wait_fact("edited", "no"));
        // Outside that it is named whole.
        ASSERT_TRUE(editor.drop(secret, "Viewport", "Model", "viewport"));
        ASSERT_TRUE(editor.wait_fact("environment", fs::canonical(secret).string()));
    }
    const auto names_a_file = [](const Editor& editor) {
        const std::vector<Control> all = editor.controls();
        return std::any_of(all.begin(), all.end(), [](const Control& each) {
            return each.kind == "toast" &&
                   each.label.starts_with("The document's environment is not used");
        });
    };
    {
        Editor editor(display_.name(), folder_, arguments(model));
        ASSERT_TRUE(open(editor, model));
        EXPECT_EQ(editor.fact("environment"), "day.hdr");
        EXPECT_FALSE(names_a_file(editor));
    }
    // A document that names a file outside is not believed: the studio lights, and that is said.
    for (const std::string name : {"../secret.hdr", "%2e%2e/secret.hdr", secret.c_str()}) {
        SCOPED_TRACE(name);
        light_by(model, name);
        Editor editor(display_.name(), folder_, arguments(model));
        ASSERT_TRUE(open(editor, model));
        EXPECT_EQ(editor.fact("environment"), name);
        ASSERT_TRUE(editor.wait_for("the refusal", [&] { return names_a_file(editor); }));
        EXPECT_EQ(editor.fact("edited"), "no");
    }
}

TEST_F(FilesTest, TheFirstSaveOfASessionKeepsTheVersionBefore) {
    const fs::path file = sample();
    const fs::path kept = folder_ / "sample.glb~";
    const std::string before = bytes(file);
    Editor editor(display_.name(), folder_, arguments(file));
    ASSERT_TRUE(open(editor, file));
    for (int save = 1; save <= 2; ++save) {
        ASSERT_TRUE(add_layer(editor, "Add value layer"));
        editor.key("ctrl+s");
        ASSERT_TRUE(editor.wait_fact("edited", "no"));
        ASSERT_TRUE(editor.settle());
        EXPECT_NE(bytes(file), before);
        EXPECT_TRUE(bytes(kept) == before) << "after save " << save;
    }
}

TEST_F(FilesTest, AViewIsSavedInTheSizeAndOnTheBackgroundThatAreChosen) {
    const fs::path file = sample();
    Editor editor(display_.name(), folder_, arguments(file));
    ASSERT_TRUE(open(editor, file));
    const auto choose = [&](const std::string& label, const std::string& ending) {
        ASSERT_TRUE(editor.click("Save the view", label, "combo"));
        std::string item;
        ASSERT_TRUE(editor.wait_for("the choice " + ending, [&] {
            for (const Control& control : editor.controls())
                if (control.kind == "item" && control.label.ends_with(ending)) item = control.label;
            return !item.empty();
        }));
        ASSERT_TRUE(editor.click("Save the view", item, "item"));
    };
    ASSERT_TRUE(editor.click("Viewport", "Save the view", "button"));
    choose("Size", " 540 px");
    choose("Samples", "16, a draft");
    choose("Background", "Transparent");
    ASSERT_TRUE(editor.click("Save the view", "Choose a file\u2026", "button"));
    ASSERT_TRUE(editor.click("File dialog", "Save", "button"));
    const fs::path saved = folder_ / "sample.png";
    ASSERT_TRUE(editor.wait_for("the toast", [&] {
        const auto controls = editor.controls();
        return fs::exists(saved) &&
               std::any_of(controls.begin(), controls.end(),
                           [](const auto& c) { return c.label == "Saved sample.png"; });
    }));
    const auto picture = io::decode_image(*read_file(saved), "sample.png");
    ASSERT_TRUE(picture) << picture.error().message;
    EXPECT_EQ((*picture)->height, 540);
    ASSERT_EQ((*picture)->channels, 4);
    EXPECT_EQ((*picture)->data[3], std::byte{0}) << "the corner is beside the model";
}

}  // namespace
}  // namespace patina::editor_tests
