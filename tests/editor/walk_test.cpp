// SPDX-License-Identifier: MIT
// The same walk over the sample and models of ../shared/assets, nightly over all of them: layers, a
// mask, blending, undo and redo, shading, divider, channels, saving, reopening. After every step
// the picture, the file and the document are what they have to be.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>

#include "core/hash.h"
#include "editor/editor_fixture.h"
#include "editor/gltf_errors.h"

namespace patina::editor_tests {
namespace {

namespace fs = std::filesystem;

const fs::path kModels = fs::path(PATINA_SOURCE_DIR) / "../shared/assets/models";
constexpr const char* kSample = "the sample";

/// Maps in files beside it, nothing but colours of vertices, and several materials in one binary.
bool is_walked_always(const std::string& model) {
    return model == "Avocado/Avocado.gltf" || model == "BoxVertexColors.glb" ||
           model == "CesiumMilkTruck.glb";
}

std::vector<std::string> models(bool walked_always) {
    std::vector<std::string> found;
    std::error_code error;
    for (const auto& entry : fs::recursive_directory_iterator(kModels, error)) {
        if (entry.path().extension() != ".glb" && entry.path().extension() != ".gltf") continue;
        std::string model = fs::relative(entry.path(), kModels).string();
        if (is_walked_always(model) == walked_always) found.push_back(std::move(model));
    }
    std::sort(found.begin(), found.end());
    return found;
}

std::vector<std::string> sample_and_models() {
    std::vector<std::string> walked = models(true);
    walked.insert(walked.begin(), kSample);
    return walked;
}

std::string test_name(const testing::TestParamInfo<std::string>& info) {
    std::string name = info.param == kSample ? "Sample" : fs::path(info.param).stem().string();
    std::erase_if(name, [](unsigned char letter) { return std::isalnum(letter) == 0; });
    return name;
}

/// Names and contents of all files in a folder.
std::map<std::string, std::string> files_in(
    const fs::path& folder, const std::function<std::string(const fs::path&)>& read) {
    std::map<std::string, std::string> result;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file())
            result[fs::relative(entry.path(), folder).string()] = read(entry.path());
    return result;
}

/// The columns from one share of the width to another.
Pixels columns(const Pixels& all, double from, double to) {
    const int x0 = static_cast<int>(from * all.width);
    Pixels part{static_cast<int>(to * all.width) - x0, all.height, {}};
    for (int y = 0; y < all.height; ++y) {
        const auto row = all.rgb.begin() + (y * all.width + x0) * 3;
        part.rgb.insert(part.rgb.end(), row, row + part.width * 3);
    }
    return part;
}

class Walk : public EditorTest, public testing::WithParamInterface<std::string> {
  protected:
    /// What is compared at every step.
    struct Seen {
        std::string content;
        Pixels picture;
    };

    void SetUp() override {
        EditorTest::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        model_ = folder_ / "model" / "sample.glb";
        fs::create_directories(model_.parent_path());
        if (is_sample()) {
            ASSERT_EQ(run_tool({PATINA_PROGRAM, "sample", "-o", model_.string()}, ""), 0);
        } else {
            const fs::path source = kModels / GetParam();
            if (!fs::exists(source)) GTEST_SKIP() << "no " << source;
            model_ = folder_ / "model" / source.filename();
            // What lies beside a model in a folder of its own belongs to it.
            if (source.extension() == ".gltf")
                fs::copy(source.parent_path(), model_.parent_path(), fs::copy_options::recursive);
            else
                fs::copy(source, model_);
        }
        untouched_ = files();
        errors_before_ = errors_in_gltf(model_);
    }

    bool is_sample() const { return GetParam() == kSample; }
    std::map<std::string, std::string> files() const {
        return files_in(model_.parent_path(), &EditorTest::bytes);
    }

    /// The model as it is on screen, when nothing lies on top and all is done.
    static Seen look(const Editor& editor) {
        editor.wait_for("the last message to go", [&] {
            const std::vector<Control> all = editor.controls();
            return std::none_of(all.begin(), all.end(),
                                [](const Control& each) { return each.kind == "toast"; });
        });
        Pixels picture = model_part(editor.viewport());
        return {editor.fact("content"), std::move(picture)};
    }
    enum class NextPicture { Differs, MayBeEqual };
    /// One more step of the history has been made: another document, another picture, and on the
    /// disk nothing yet.
    void expect_step(const Editor& editor, const std::string& what,
                     NextPicture picture = NextPicture::Differs) {
        SCOPED_TRACE(what);
        Seen now = look(editor);
        EXPECT_EQ(std::stoul(editor.fact("steps")), steps_.size() + 1);
        EXPECT_NE(now.content, steps_.back().content);
        if (picture == NextPicture::Differs) {
            EXPECT_GT(different_share(now.picture, steps_.back().picture, 0), 0.0);
        }
        EXPECT_EQ(files(), untouched_);
        steps_.push_back(std::move(now));
    }
    static void expect_same(const Seen& now, const Seen& before) {
        EXPECT_EQ(now.content, before.content);
        EXPECT_EQ(different_share(now.picture, before.picture, 0), 0.0);
    }

    void add_three_layers(const Editor& editor);
    void mask_and_blend(const Editor& editor);
    void undo_and_redo_all(const Editor& editor) const;
    void compare_shadings(const Editor& editor) const;
    void show_channels(const Editor& editor) const;
    void save(const Editor& editor);

    fs::path model_;
    std::map<std::string, std::string> untouched_;
    ErrorCodes errors_before_;
    std::vector<Seen> steps_;  ///< of the history, from the opened document on
};

void Walk::add_three_layers(const Editor& editor) {
    for (const std::string item :
         {"Add value layer", "Add procedural layer\u2026", "Add value layer"}) {
        ASSERT_TRUE(add_layer(editor, item, item == "Add value layer" ? "" : "Perlin noise"));
        // Without UVs a noise is its mean: the same grey as the layer above it.
        ASSERT_NO_FATAL_FAILURE(expect_step(
            editor, item, is_sample() ? NextPicture::Differs : NextPicture::MayBeEqual));
    }
    EXPECT_GT(different_share(steps_.back().picture, steps_.front().picture), 0.0);
}

void Walk::mask_and_blend(const Editor& editor) {
    ASSERT_TRUE(editor.click("Properties/Mask", "Add mask entry", "button"));
    ASSERT_TRUE(editor.click("Properties/Mask/Popup", "Worley noise (F1)", "item"));
    ASSERT_TRUE(editor.wait_for("a mask entry", [&] {
        return editor.find("Properties/Mask", "Worley noise (F1)", "mask entry").has_value();
    }));
    ASSERT_NO_FATAL_FAILURE(expect_step(editor, "mask"));

    ASSERT_TRUE(editor.click("Properties", "Blend mode", "combo"));
    ASSERT_TRUE(editor.click("Properties/Popup", "Multiply", "item"));
    ASSERT_TRUE(editor.wait_for("Multiply", [&] {
        const auto mode = editor.find("Properties", "Blend mode", "combo");
        return mode && mode->value == "Multiply";
    }));
    ASSERT_NO_FATAL_FAILURE(expect_step(editor, "blend mode"));

    // Each drag is one step, however many values it went through.
    ASSERT_TRUE(editor.drag("Properties", "Opacity", "slider", 0.9, 0.5));
    ASSERT_NO_FATAL_FAILURE(expect_step(editor, "opacity of the layer"));
    ASSERT_TRUE(editor.drag("Properties/Base colour", "Opacity", "slider", 0.9, 0.3));
    ASSERT_NO_FATAL_FAILURE(expect_step(editor, "opacity of a channel"));
}

void Walk::undo_and_redo_all(const Editor& editor) const {
    for (std::size_t i = steps_.size() - 1; i-- > 0;) {
        SCOPED_TRACE("undone to step " + std::to_string(i));
        editor.key("ctrl+z");
        ASSERT_TRUE(editor.wait_fact("content", steps_[i].content));
        // Elsewhere the ends are enough to see that pictures follow documents.
        if (is_sample() || i == 0) expect_same(look(editor), steps_[i]);
    }
    EXPECT_EQ(editor.fact("edited"), "no");
    for (std::size_t i = 1; i < steps_.size(); ++i) {
        editor.key("ctrl+shift+z");
        ASSERT_TRUE(editor.wait_fact("content", steps_[i].content));
    }
    expect_same(look(editor), steps_.back());
}

void Walk::compare_shadings(const Editor& editor) const {
    const Seen& pbr = steps_.back();
    editor.key("o");
    ASSERT_TRUE(editor.wait_fact("left", "phong"));
    const Seen phong = look(editor);
    EXPECT_GT(different_share(phong.picture, pbr.picture), 0.0);
    EXPECT_EQ(phong.content, pbr.content);
    editor.key("p");
    ASSERT_TRUE(editor.wait_fact("left", "pbr"));

    // Each side of the divider is the whole picture of its kind, wherever it is dragged to.
    editor.key("v");
    ASSERT_TRUE(editor.wait_fact("compare", "split"));
    ASSERT_EQ(editor.fact("right"), "phong");
    const std::vector<double> places =
        is_sample() ? std::vector<double>{5.5, -8.0} : std::vector<double>{-4.0};
    for (const double to : places) {
        const std::string before = editor.fact("divider");
        ASSERT_TRUE(editor.drag("Viewport", "Divider", "handle", 0.5, to));
        ASSERT_TRUE(editor.wait_for("the divider to move",
                                    [&] { return editor.fact("divider") != before; }));
        const Seen split = look(editor);
        EXPECT_EQ(split.content, pbr.content);
        // The divider's share of what model_part keeps, with room for its handle.
        const double at = (std::stod(editor.fact("divider")) - 0.1) / 0.8;
        const double room = 0.04;
        EXPECT_EQ(different_share(columns(split.picture, 0.0, at - room),
                                  columns(pbr.picture, 0.0, at - room), 0),
                  0.0);
        EXPECT_EQ(different_share(columns(split.picture, at + room, 1.0),
                                  columns(phong.picture, at + room, 1.0), 0),
                  0.0);
    }
    ASSERT_TRUE(editor.click("Viewport bar", "Single", "segment"));
    ASSERT_TRUE(editor.wait_fact("compare", "single"));
    expect_same(look(editor), pbr);
}

void Walk::show_channels(const Editor& editor) const {
    const std::vector<int> digits =
        is_sample() ? std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8, 9} : std::vector<int>{1, 4};
    Seen last = steps_.back();
    for (const int digit : digits) {
        const std::string before = editor.fact("channel");
        editor.key(std::to_string(digit));
        ASSERT_TRUE(
            editor.wait_for("another channel", [&] { return editor.fact("channel") != before; }));
        Seen channel = look(editor);
        EXPECT_EQ(channel.content, last.content);
        EXPECT_GT(different_share(last.picture, channel.picture), 0.002) << "channel " << digit;
        last = std::move(channel);
    }
    editor.key("0");
    ASSERT_TRUE(editor.wait_fact("channel", "final"));
    expect_same(look(editor), steps_.back());
}

void Walk::save(const Editor& editor) {
    editor.key("ctrl+s");
    ASSERT_TRUE(editor.wait_fact("edited", "no"));
    ASSERT_TRUE(editor.settle());
    EXPECT_EQ(editor.fact("content"), steps_.back().content);
    EXPECT_EQ(to_hex(hash_text(stored(model_))), steps_.back().content);
    EXPECT_THAT(errors_in_gltf(model_), IsNotWorseThan(errors_before_));
}

TEST_P(Walk, EveryStepIsSeenKeptUndoneAndSaved) {
    std::map<std::string, std::string> saved;
    std::vector<std::string> rows;
    {
        Editor editor(display_.name(), folder_, arguments(model_));
        ASSERT_TRUE(open(editor, model_));
        steps_.push_back(look(editor));
        ASSERT_NO_FATAL_FAILURE(add_three_layers(editor));
        ASSERT_NO_FATAL_FAILURE(mask_and_blend(editor));
        ASSERT_NO_FATAL_FAILURE(undo_and_redo_all(editor));
        ASSERT_NO_FATAL_FAILURE(compare_shadings(editor));
        ASSERT_NO_FATAL_FAILURE(show_channels(editor));
        EXPECT_EQ(files(), untouched_);
        ASSERT_NO_FATAL_FAILURE(save(editor));
        saved = files();
        EXPECT_NE(saved, untouched_);
        rows = editor.layers();
        editor.key("ctrl+q");
        EXPECT_EQ(editor.wait_for_end(), 0);
    }
    Editor again(display_.name(), folder_, arguments(model_));
    ASSERT_TRUE(open(again, model_));
    EXPECT_EQ(again.layers(), rows);
    EXPECT_EQ(again.fact("edited"), "no");
    // Baked maps have 8 bits where the compositor has floats: a step of one is not another picture.
    const Seen reopened = look(again);
    EXPECT_EQ(reopened.content, steps_.back().content);
    EXPECT_LT(different_share(reopened.picture, steps_.back().picture), 0.001);
    again.key("ctrl+q");
    EXPECT_EQ(again.wait_for_end(), 0);
    EXPECT_EQ(files(), saved) << "opening changed a file";
}

INSTANTIATE_TEST_SUITE_P(Models, Walk, testing::ValuesIn(sample_and_models()), test_name);
INSTANTIATE_TEST_SUITE_P(NightlyModels, Walk, testing::ValuesIn(models(false)), test_name);

}  // namespace
}  // namespace patina::editor_tests
