// SPDX-License-Identifier: MIT
#include "io/preset_library.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include "document/layer_edits.h"
#include "unit/io/temporary_folder.h"

namespace patina::io {
namespace {

TEST(PresetLibrary, AnIdIsMadeOfWhatAnIdMayHold) {
    EXPECT_EQ(preset_id_of("Worn paint, red"), "worn-paint-red");
    EXPECT_EQ(preset_id_of("  --Zinc 2!"), "zinc-2");
    EXPECT_EQ(preset_id_of("\u00e9"), "preset");
    EXPECT_EQ(preset_id_of(std::string(63, 'a') + " b"), std::string(63, 'a'));
}

TEST(PresetLibrary, APresetOfTheUsersIsFoundByItsIdWhenItIsWritten) {
    const TemporaryFolder folder;
    ASSERT_EQ(::setenv("XDG_DATA_HOME", folder.path().c_str(), 1), 0);
    const std::filesystem::path file = user_preset_folder() / "zinc.json";
    EXPECT_EQ(file, folder.path() / "patina" / "presets" / "zinc.json");
    EXPECT_FALSE(find_preset("zinc"));
    Preset preset;
    preset.id = "zinc";
    preset.name = "Zinc";
    preset.category = "Mine";
    preset.author = "A test";
    preset.licence = "CC0-1.0";
    preset.description = "Grey.";
    EXPECT_FALSE(write_preset(file, preset, {})) << "it has no layers";
    EXPECT_FALSE(std::filesystem::exists(file));
    Layer layer = value_layer();
    layer.id = {1};
    preset.layers = {std::make_shared<const Layer>(layer)};
    const auto written = write_preset(file, preset, {});
    ASSERT_TRUE(written) << written.error().message;
    const auto found = find_preset("zinc");
    ::unsetenv("XDG_DATA_HOME");
    ASSERT_TRUE(found) << found.error().message;
    EXPECT_EQ(found->path, file);
    EXPECT_EQ(found->preset.name, "Zinc");
    EXPECT_EQ(found->preset.layers.size(), 1u);
}

}  // namespace
}  // namespace patina::io
