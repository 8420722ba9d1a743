// SPDX-License-Identifier: MIT
#pragma once

/// What every test of the editor stands on: a display, a folder of its own, and the files in it.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "editor/driver.h"

namespace patina::editor_tests {

class EditorTest : public testing::Test {
  protected:
    EditorTest();
    ~EditorTest() override;
    void SetUp() override;

    /// The command line that opens `file` in a window of 1280x720 at 100 %.
    static std::vector<std::string> arguments(const std::filesystem::path& file);
    /// Patina's sample, written to the folder.
    std::filesystem::path sample() const;
    /// Whether the editor has opened the file, and shows it.
    static bool open(const Editor& editor, const std::filesystem::path& file);
    static std::string bytes(const std::filesystem::path& file);
    /// The document that the file holds, as Patina reads it back; the reason when it does not.
    static std::string stored(const std::filesystem::path& file);

    Display display_{1280, 720};
    std::filesystem::path folder_;
};

/// Adds a layer by the menu of the layer list.
/// @param kind  what is chosen in the second menu, of items that open one
bool add_layer(const Editor& editor, const std::string& item, const std::string& kind = {});

}  // namespace patina::editor_tests
