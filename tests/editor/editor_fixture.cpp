// SPDX-License-Identifier: MIT
#include "editor/editor_fixture.h"

#include <cstdlib>
#include <fstream>

#include "document/record.h"
#include "io/load.h"

namespace patina::editor_tests {

namespace fs = std::filesystem;

EditorTest::EditorTest() {
    std::string pattern = (fs::temp_directory_path() / "patina-editor-XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
}

EditorTest::~EditorTest() {
    fs::remove_all(folder_);
}

void EditorTest::SetUp() {
    if (!display_.name().empty()) return;
    if (run_tool({"Xvfb", "-version"}, "") < 0) GTEST_SKIP() << "Xvfb is not installed";
    FAIL() << "Xvfb does not start";
}

std::vector<std::string> EditorTest::arguments(const fs::path& file) {
    // Without refinement: equal documents are equal pictures, whenever one looks.
    return {"--window", "1280x720", "--scale", "1", "--refine", "0", file.string()};
}

fs::path EditorTest::sample() const {
    fs::path file = folder_ / "sample.glb";
    EXPECT_EQ(run_tool({PATINA_PROGRAM, "sample", "-o", file.string()}, ""), 0);
    return file;
}

bool EditorTest::open(const Editor& editor, const fs::path& file) {
    return editor.wait_fact("document", file.filename().string()) && editor.settle();
}

std::string EditorTest::bytes(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::string EditorTest::stored(const fs::path& file) {
    const auto loaded = io::load_document(file);
    return loaded ? serialise(*loaded->document) : loaded.error().message;
}

bool add_layer(const Editor& editor, const std::string& item, const std::string& kind) {
    const std::size_t before = editor.layers().size();
    return editor.click("Layers", "Add layer", "button") &&
           editor.click("Layers/Popup", item, "item") &&
           (kind.empty() || editor.click("Layers/Popup", kind, "item")) &&
           editor.wait_for(item, [&] { return editor.layers().size() == before + 1; }) &&
           editor.settle();
}

}  // namespace patina::editor_tests
