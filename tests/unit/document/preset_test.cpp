// SPDX-License-Identifier: MIT
#include "document/preset.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <filesystem>

#include "core/files.h"
#include "document/layer_edits.h"
#include "document/record.h"
#include "unit/document/json_schema.h"
#include "unit/document/sample_document.h"

namespace patina {
namespace {

using nlohmann::json;
using test_support::schema_fault;

const std::filesystem::path kFolder = std::filesystem::path(PATINA_SOURCE_DIR) / "presets";

const json& schema() {
    static const json parsed = json::parse(read_text_file(kFolder / "schema.json").value());
    return parsed;
}

std::vector<std::filesystem::path> shipped_presets() {
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(kFolder))
        if (entry.path().extension() == ".json" && entry.path().filename() != "schema.json")
            paths.push_back(entry.path());
    return paths;
}

const std::string& rusted_iron() {
    static const std::string text = read_text_file(kFolder / "rusted-iron.json").value();
    return text;
}

/// Both judges of a preset: why the reader and why the schema refuse it.
struct Verdict {
    std::string reader;
    std::string schema;
};
Verdict verdict(const json& preset) {
    const Result<Preset> read = preset_from_json(preset.dump(), "test");
    return {read ? "" : read.error().message, schema_fault(schema(), schema(), preset)};
}

TEST(Preset, ThoseThatShipAreReadAndValidAgainstTheSchema) {
    std::set<std::string> names;
    for (const auto& path : shipped_presets()) {
        const std::string text = read_text_file(path).value();
        const Result<Preset> preset = preset_from_json(text, path.string());
        ASSERT_TRUE(preset) << preset.error().message;
        EXPECT_EQ(preset->id, path.stem());
        EXPECT_TRUE(names.insert(preset->name).second) << preset->name << " is there twice";
        EXPECT_EQ(schema_fault(schema(), schema(), json::parse(text)), "") << path;
        EXPECT_GE(preset->layers.size(), 2u) << path << " is not layered";
    }
    EXPECT_TRUE(names.contains("Rusted iron"));
    EXPECT_TRUE(names.contains("Painted wood"));
    EXPECT_TRUE(names.contains("Brushed brass"));
}

TEST(Preset, KnobsOfThoseThatShipStandWhereTheLayersAreAndChangeThemWhenTurned) {
    int knobs = 0;
    for (const auto& path : shipped_presets()) {
        const Preset preset = preset_from_json(read_text_file(path).value(), "").value();
        const auto text_with = [&](float value, const PresetKnob& knob) {
            Preset turned = preset;
            turned.layers = turned_layers(preset, {{knob.id, value}}).value();
            return preset_to_json(turned);
        };
        for (const PresetKnob& knob : preset.knobs) {
            EXPECT_EQ(text_with(knob.value, knob), preset_to_json(preset))
                << path << ": " << knob.id << " does not stand at its value";
            EXPECT_NE(text_with(0.0f, knob), text_with(1.0f, knob)) << path << ": " << knob.id;
            ++knobs;
        }
    }
    EXPECT_GE(knobs, 24);
}

TEST(Preset, AKnobThatIsNotThereOrTurnedTooFarOrMovesNoNumberIsRefused) {
    json preset = json::parse(rusted_iron());
    preset["knobs"] = {{{"id", "wear"},
                        {"name", "Wear"},
                        {"targets", {{{"path", "/1/opacity"}, {"from", 0.2}, {"to", 1}}}}}};
    const Preset read = preset_from_json(preset.dump(), "test").value();
    EXPECT_FLOAT_EQ((*turned_layers(read, {{"wear", 0.5f}}))[1]->opacity, 0.6f);
    EXPECT_FALSE(turned_layers(read, {{"rust", 0.5f}}));
    EXPECT_FALSE(turned_layers(read, {{"wear", 1.5f}}));
    for (const char* path : {"/1/name", "/99/opacity", "/1/mask", "opacity", "/1/sheen"}) {
        preset["knobs"][0]["targets"][0]["path"] = path;
        EXPECT_FALSE(preset_from_json(preset.dump(), "test")) << path;
    }
    preset["knobs"][0]["targets"][0] = {{"path", "/1/opacity"}, {"from", 0.2}, {"to", 3}};
    EXPECT_FALSE(preset_from_json(preset.dump(), "test"));
}

TEST(Preset, ThoseThatShipAreWrittenAsPatinaWritesThem) {
    for (const auto& path : shipped_presets()) {
        const std::string text = read_text_file(path).value();
        EXPECT_EQ(preset_to_json(preset_from_json(text, "").value()), text) << path;
    }
}

TEST(Preset, WhateverLayersADocumentHoldsMakeAValidPreset) {
    const bool holds = rc::check([](const std::vector<std::uint32_t>& numbers) {
        Document document = test_support::sample_document();
        test_support::Choices choices(numbers);
        while (!choices.used_up())
            if (auto after = test_support::random_edit(document, choices).apply(document))
                document = *after;
        Preset preset;
        preset.id = "any-layers";
        preset.name = preset.category = preset.author = preset.description = "Any";
        preset.licence = "CC0-1.0";
        preset.layers = document.materials.front()->stack;
        RC_PRE(!preset.layers.empty());
        const std::string text = preset_to_json(preset);
        const Result<Preset> read = preset_from_json(text, "any");
        if (!read) RC_FAIL(read.error().message);
        RC_ASSERT(preset_to_json(*read) == text);
        RC_ASSERT(schema_fault(schema(), schema(), json::parse(text)) == "");
    });
    EXPECT_TRUE(holds);
}

TEST(Preset, RecordsAreValidAgainstTheSchemaToo) {
    const Document document = test_support::sample_document();
    const json& of_materials = schema()["$defs"]["material-record"];
    for (const MaterialPtr& material : document.materials) {
        MaterialRecord record = material_record(document, *material);
        record.baked["base-color"] = hash_text("baked");
        record.owned_images = {hash_text("baked")};
        EXPECT_EQ(schema_fault(schema(), of_materials, json::parse(to_json(record))), "");
    }
    MaterialRecord copy;
    copy.stands_for = MaterialId{1};
    EXPECT_EQ(schema_fault(schema(), of_materials, json::parse(to_json(copy))), "");
    const SceneRecord scene{.environment = document.environment, .lights = document.lights};
    EXPECT_EQ(
        schema_fault(schema(), schema()["$defs"]["scene-record"], json::parse(to_json(scene))), "");
}

TEST(Preset, BrokenOnesAreRefusedByTheSchemaAndByTheReader) {
    struct Break {
        std::string pointer;
        json value;
    };
    const std::vector<Break> breaks = {
        {"/id", "Rusted Iron"},
        {"/id", "-iron"},
        {"/version", 0},
        {"/patina-preset", "1"},
        {"/licence", ""},
        {"/author", 7},
        {"/tags", "rust"},
        {"/colour", "brown"},
        {"/images", json::array({{{"file", "../x.png"}, {"hash", std::string(32, '0')}}})},
        {"/images", json::array({{{"file", "x.png"}, {"hash", "0"}}})},
        {"/layers", json::array()},
        {"/layers", json::object()},
        {"/layers/0/name", ""},
        {"/layers/0/name", "bell\a"},
        {"/layers/0/kind", "paint"},
        {"/layers/0/opacity", 1.5},
        {"/layers/0/visible", 1},
        {"/layers/0/mode", "nrm-rnm"},
        {"/layers/0/layers", json::array()},
        {"/layers/0/blend-space", "gamma"},
        {"/layers/0/channels/colour", json::object()},
        {"/layers/0/channels/base-color/source", json::array({0.5, 0.5})},
        {"/layers/0/channels/base-color/source", json::array({0.5, 0.5, 1.5})},
        {"/layers/0/channels/metalness/source", json::array({1, 1, 1})},
        {"/layers/0/channels/metalness/source", -0.1},
        {"/layers/0/channels/metalness/mode", "h-max"},
        {"/layers/0/channels/normal", {{"source", 1}}},
        {"/layers/0/channels/roughness/source/kind", "nacre"},
        {"/layers/0/channels/roughness/source/octaves", 3.5},
        {"/layers/0/channels/roughness/source/octaves", 0},
        {"/layers/0/channels/roughness/source/scale", 1000},
        {"/layers/0/channels/roughness/source/size", 1},
        {"/layers/0/channels/roughness/source/ramp", json::array()},
        {"/layers/0/channels/roughness/source/ramp/0/value", 2},
        {"/layers/0/channels/roughness/source/transform", {{"rotation", 720}}},
        {"/layers/2/mask/entries/0/combine", "normal"},
        {"/layers/2/mask/entries/0/combine", "hue-w3c"},
        {"/layers/2/mask/entries/0/adjustment", {{"kind", "invert"}}},
        {"/layers/2/mask/entries/0", {{"name", "M"}}},
        {"/layers/2/mask/entries/0", {{"name", "M"}, {"adjustment", {{"kind", "gradient-map"}}}}},
        {"/layers/2/mask/entries/0",
         {{"name", "M"}, {"adjustment", {{"kind", "clamp"}}}, {"levels", {{"gamma", 2}}}}},
        {"/layers/2/mask/entries/0/levels", {{"gamma", 0}}},
        {"/layers/2/mask/base", 2},
    };
    for (const auto& [pointer, value] : breaks) {
        json preset = json::parse(rusted_iron());
        preset[json::json_pointer(pointer)] = value;
        const Verdict found = verdict(preset);
        EXPECT_NE(found.reader, "") << pointer << " = " << value;
        EXPECT_NE(found.schema, "") << pointer << " = " << value;
        EXPECT_EQ(found.reader.find('\n'), std::string::npos);
    }
    for (const char* key : {"id", "name", "category", "author", "licence", "description", "layers",
                            "patina-preset"}) {
        json preset = json::parse(rusted_iron());
        preset.erase(key);
        EXPECT_NE(verdict(preset).reader, "") << key;
        EXPECT_NE(verdict(preset).schema, "") << key;
    }
}

TEST(Preset, AFaultNamesTheFileAndTheJsonPointer) {
    json preset = json::parse(rusted_iron());
    preset["layers"][0]["opacity"] = 7;
    EXPECT_EQ(preset_from_json(preset.dump(), "my.json").error().message,
              "my.json: /layers/0/opacity is out of range: Opacity must be 0 to 1, got 7");
    preset["patina-preset"] = 2;
    EXPECT_NE(preset_from_json(preset.dump(), "my.json").error().message.find("newer"),
              std::string::npos);
}

TEST(Preset, ThoseThatShipAreAcceptedByAMaterial) {
    const Document document = test_support::sample_document();
    for (const auto& path : shipped_presets()) {
        const Preset preset = preset_from_json(read_text_file(path).value(), "").value();
        const auto after =
            add_layers(*document.materials.front(), preset.layers, top_of_stack(), "Preset")
                .apply(document);
        EXPECT_TRUE(after) << after.error().message;
    }
}

}  // namespace
}  // namespace patina
