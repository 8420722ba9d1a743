// SPDX-License-Identifier: MIT
#include "document/record.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <bit>

#include "document/history.h"
#include "unit/document/sample_document.h"

namespace patina {
namespace {

using test_support::Choices;
using test_support::random_edit;
using test_support::sample_document;

/// The sample after random edits, refused ones left out.
Document edited_document(const std::vector<std::uint32_t>& numbers) {
    Document document = sample_document();
    Choices choices(numbers);
    while (!choices.used_up())
        if (Result<Document> after = random_edit(document, choices).apply(document))
            document = *after;
    return document;
}

std::string fault_of(const std::string& stack) {
    const auto record = material_record_from_json(R"({"version":1,"id":1,"stack":)" + stack + "}");
    return record ? "" : record.error().message;
}

/// One fill whose base colour has that source.
std::string fault_of_source(const std::string& source) {
    return fault_of(R"([{"name":"A","channels":{"base-color":{"source":)" + source + "}}}]");
}

TEST(Record, WrittenReadAndWrittenAgainIsTheSameText) {
    const bool holds = rc::check([](const std::vector<std::uint32_t>& numbers) {
        const Document document = edited_document(numbers);
        for (const MaterialPtr& material : document.materials) {
            const std::string text = to_json(material_record(document, *material));
            const Result<MaterialRecord> read = material_record_from_json(text);
            if (!read) RC_FAIL(read.error().message);
            RC_ASSERT(to_json(*read) == text);
            RC_ASSERT(read->id == material->id);
            RC_ASSERT(read->resolution == material->resolution);
        }
        const SceneRecord scene{.environment = document.environment, .lights = document.lights};
        const Result<SceneRecord> read = scene_record_from_json(to_json(scene));
        if (!read) RC_FAIL(read.error().message);
        RC_ASSERT(*read == scene);
    });
    EXPECT_TRUE(holds);
}

TEST(Record, AStackReadBackIntoItsMaterialGivesTheSameDocument) {
    const bool holds = rc::check([](const std::vector<std::uint32_t>& numbers) {
        Document document = edited_document(numbers);
        const std::string before = serialise(document);
        for (MaterialPtr& material : document.materials) {
            Material copy = *material;
            const auto read =
                material_record_from_json(to_json(material_record(document, *material)));
            if (!read) RC_FAIL(read.error().message);
            copy.stack = read->stack;
            copy.height_scale = read->height_scale;
            copy.uv_set = read->uv_set;
            copy.padding = read->padding;
            material = std::make_shared<const Material>(copy);
        }
        RC_ASSERT(serialise(document) == before);
    });
    EXPECT_TRUE(holds);
}

TEST(Record, FloatsReadBackToTheSameBits) {
    const bool holds = rc::check([](std::uint32_t drawn) {
        // The bits of the floats from 0 to 1 are the integers from 0 to those of 1.
        const auto value = std::bit_cast<float>(drawn % (std::bit_cast<std::uint32_t>(1.0f) + 1));
        MaterialRecord record;
        record.id = MaterialId{1};
        record.height_scale = value;
        const auto read = material_record_from_json(to_json(record));
        RC_ASSERT(read.has_value());
        RC_ASSERT(read->height_scale == value);
    });
    EXPECT_TRUE(holds);
    MaterialRecord record;
    record.height_scale = 0.1f;
    EXPECT_NE(to_json(record).find("\"height-scale\":0.1,"), std::string::npos) << to_json(record);
}

TEST(Record, WhatIsAsInANewLayerIsLeftOut) {
    MaterialRecord record;
    record.id = MaterialId{7};
    Layer layer;
    layer.id = LayerId{1};
    layer.name = "Bare";
    record.stack = {std::make_shared<const Layer>(layer)};
    EXPECT_EQ(to_json(record), R"({"version":1,"id":7,"resolution":2048,"stack":)"
                               R"([{"id":1,"name":"Bare","kind":"fill"}]})");
}

TEST(Record, BakedAndOwnedImagesAndStandInsSurvive) {
    MaterialRecord record;
    record.id = MaterialId{3};
    record.baked["base-color"] = hash_text("baked");
    record.owned_images = {hash_text("one"), hash_text("two")};
    record.images = {record_image(*test_support::sample_image())};
    const auto read = material_record_from_json(to_json(record));
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->baked, record.baked);
    EXPECT_EQ(read->owned_images, record.owned_images);
    EXPECT_EQ(read->images, record.images);

    MaterialRecord copy;
    copy.stands_for = MaterialId{3};
    const auto read_copy = material_record_from_json(to_json(copy));
    ASSERT_TRUE(read_copy) << read_copy.error().message;
    EXPECT_EQ(read_copy->stands_for, MaterialId{3});
}

TEST(Record, FaultsNameTheirJsonPointer) {
    EXPECT_EQ(fault_of(R"([{"name":"A","opacity":2}])"),
              "/stack/0/opacity is out of range: Opacity must be 0 to 1, got 2");
    EXPECT_EQ(fault_of(R"([{"name":"A","colour":1}])"),
              "/stack/0/colour is not known to this version");
    EXPECT_EQ(fault_of(R"([{"name":"A"},{"opacity":1}])"), "/stack/1/name is missing");
    EXPECT_EQ(fault_of(R"([{"name":"A","kind":"group","layers":[{"name":"B","kind":"x"}]}])"),
              "/stack/0/layers/0/kind is neither fill, group nor adjustment");
    EXPECT_EQ(fault_of(R"([{"name":"A","channels":{"base-color":{"mode":"h-add"}}}])"),
              "/stack/0/channels/base-color/mode does not apply to the base-color channel");
    EXPECT_EQ(fault_of(R"([{"name":"A","mask":{"entries":[{"name":"M","source":"x"}]}}])"),
              "/stack/0/mask/entries/0/source is not a number");
    EXPECT_EQ(fault_of("7"), "/stack is not a list of layers");
}

/// One fill whose mask has that entry, name and all but that left out.
std::string entry_with(const std::string& keys) {
    return R"([{"name":"A","mask":{"entries":[{"name":"M",)" + keys + "}]}}]";
}

TEST(Record, AMaskEntryIsASourceOrAnAdjustmentAndJoinsByTheModesOfNumbers) {
    for (const char* good :
         {R"("source":1,"combine":"difference")", R"("source":1,"combine":"soft-light-w3c")",
          R"("adjustment":{"kind":"curves"},"combine":"multiply")",
          R"("adjustment":{"kind":"blur","radius":9},"invert":true)"})
        EXPECT_EQ(fault_of(entry_with(good)), "") << good;
    const std::string place = "/stack/0/mask/entries/0";
    EXPECT_EQ(fault_of(entry_with(R"("combine":"add")")), place + "/source is missing");
    EXPECT_EQ(fault_of(entry_with(R"("source":1,"combine":"plaid")")),
              place + "/combine is not a blend mode");
    EXPECT_EQ(fault_of(entry_with(R"("source":1,"combine":"hue-w3c")")),
              place + "/combine does not apply to masks");
    EXPECT_EQ(fault_of(entry_with(R"("adjustment":{"kind":"gradient-map"})")),
              place +
                  "/adjustment is not valid: a mask has no colours to adjust by gradient-map: "
                  "use levels or curves");
    EXPECT_EQ(fault_of(entry_with(R"("source":1,"adjustment":{"kind":"clamp"})")),
              place + "/source stands beside an adjustment");
    EXPECT_EQ(fault_of(entry_with(R"("levels":{"gamma":2},"adjustment":{"kind":"clamp"})")),
              place +
                  "/adjustment is not valid: an adjustment of a mask has neither a source nor "
                  "levels beside it");
}

TEST(Record, AnAdjustmentOfAMaskReplacesUnlessItSaysOtherwise) {
    const auto entry_of = [](const std::string& keys) {
        const auto record =
            material_record_from_json(R"({"version":1,"stack":)" + entry_with(keys) + "}");
        return record.value().stack[0]->mask.entries[0];
    };
    const MaskEntry plain = entry_of(R"("adjustment":{"kind":"posterise","steps":9})");
    EXPECT_EQ(plain.combine, BlendMode::Replace);
    ASSERT_TRUE(plain.adjustment);
    EXPECT_EQ(plain.adjustment->steps, 9);
    EXPECT_EQ(entry_of(R"("adjustment":{"kind":"clamp"},"combine":"multiply")").combine,
              BlendMode::Multiply);
    EXPECT_EQ(entry_of(R"("source":1)").combine, BlendMode::Multiply);
}

TEST(Record, SourcesAreCheckedInFull) {
    EXPECT_EQ(fault_of_source("0.5"), "");
    EXPECT_EQ(fault_of_source("[0.1,0.2,0.3]"), "");
    const std::vector<std::string> bad = {
        "1.5",
        "[0.1,0.2]",
        "\"red\"",
        "null",
        R"({"kind":"nacre"})",
        R"({"kind":"image"})",
        R"({"kind":"image","image":"12"})",
        R"({"kind":"perlin-noise","seed":-1})",
        R"({"kind":"perlin-noise","seed":4294967296})",
        R"({"kind":"perlin-noise","octaves":2.5})",
        R"({"kind":"perlin-noise","octaves":11})",
        R"({"kind":"perlin-noise","scale":0})",
        R"({"kind":"perlin-noise","transform":{"scale":0}})",
        R"({"kind":"perlin-noise","transform":{"rotation":1e9}})",
        R"({"kind":"perlin-noise","ramp":[]})",
        R"({"kind":"perlin-noise","ramp":[{"position":1,"value":0},{"position":0,"value":1}]})",
        R"({"kind":"perlin-noise","ramp":[{"position":1}]})",
    };
    for (const std::string& source : bad) {
        const std::string fault = fault_of_source(source);
        EXPECT_TRUE(fault.starts_with("/stack/0/channels/base-color/source")) << source << fault;
    }
}

TEST(Record, TextThatIsNoRecordIsRefused) {
    for (const char* text :
         {"", "{", "[]", "7", "{}", R"({"version":"1"})", R"({"version":0})", R"({"version":1})",
          R"({"version":1,"stack":[]} x)", R"({"version":1,"version":1,"stack":[]})",
          R"({"version":1,"id":1e999,"stack":[]})", R"({"version":1,"resolution":1000,"stack":[]})",
          "{\"version\":1,\"stack\":[],\"a\xff\":1}"}) {
        const auto record = material_record_from_json(text);
        ASSERT_FALSE(record) << text;
        EXPECT_FALSE(record.error().message.empty());
        EXPECT_EQ(record.error().message.find('\n'), std::string::npos) << text;
    }
}

TEST(Record, EveryTruncationIsRefusedAndNoneCrashes) {
    const Document document = sample_document();
    const std::string text = to_json(material_record(document, *document.materials.front()));
    for (std::size_t length = 0; length < text.size(); ++length)
        EXPECT_FALSE(material_record_from_json(text.substr(0, length))) << length;
}

TEST(Record, ANewerVersionIsToldFromAFault) {
    const std::string newer = R"({"version":99,"stack":"in another form"})";
    EXPECT_EQ(record_version(newer), 99);
    const auto record = material_record_from_json(newer);
    ASSERT_FALSE(record);
    EXPECT_NE(record.error().message.find("newer"), std::string::npos);
    EXPECT_FALSE(record_version("{}"));
}

TEST(Record, DepthAndCountAreLimited) {
    const auto nested = [](int depth) {
        std::string text;
        for (int i = 1; i < depth; ++i) text += R"([{"name":"G","kind":"group","layers":)";
        text += R"([{"name":"A"}])";
        for (int i = 1; i < depth; ++i) text += "}]";
        return text;
    };
    EXPECT_EQ(fault_of(nested(kMaxLayerDepth)), "");
    EXPECT_NE(fault_of(nested(kMaxLayerDepth + 1)), "");
    EXPECT_NE(fault_of(nested(100'000)), "");

    const auto many = [](int count) {
        std::string text = R"([{"name":"A"})";
        for (int i = 1; i < count; ++i) text += R"(,{"name":"A"})";
        return text + "]";
    };
    EXPECT_EQ(fault_of(many(kMaxLayers)), "");
    EXPECT_NE(fault_of(many(kMaxLayers + 1)), "");
}

TEST(Record, RepeatedAndMissingIdsAreIssuedAnew) {
    const auto record = material_record_from_json(
        R"({"version":1,"id":1,"stack":[{"id":5,"name":"A"},{"id":5,"name":"B"},{"name":"C",)"
        R"("mask":{"entries":[{"id":5,"name":"M","source":1},{"name":"N","source":0}]}}]})");
    ASSERT_TRUE(record) << record.error().message;
    std::vector<std::uint64_t> ids;
    for (const LayerPtr& layer : record->stack) {
        ids.push_back(layer->id.value);
        for (const MaskEntry& entry : layer->mask.entries) ids.push_back(entry.id.value);
    }
    EXPECT_EQ(ids, (std::vector<std::uint64_t>{5, 6, 7, 8, 9}));
}

TEST(Record, ACopiedMaterialGetsIdsOfItsOwnAndTheFirstKeepsIts) {
    Document document = sample_document();
    document.materials.push_back(document.materials.front());
    const Document unique = with_unique_ids(document);
    EXPECT_EQ(unique.materials[0], document.materials[0]);
    EXPECT_EQ(unique.materials[1], document.materials[1]);
    EXPECT_NE(unique.materials[2]->id, document.materials[0]->id);
    std::vector<std::uint64_t> ids = test_support::all_ids(unique);
    for (const MaterialPtr& material : unique.materials) ids.push_back(material->id.value);
    std::sort(ids.begin(), ids.end());
    EXPECT_EQ(std::adjacent_find(ids.begin(), ids.end()), ids.end());
    EXPECT_GT(unique.next_id, ids.back());
}

TEST(Record, ImagesOfAStackAreListedOnceGroupsAndMasksIncluded) {
    const Document document = sample_document();
    EXPECT_EQ(images_of(document.materials.front()->stack),
              std::vector<Hash128>{test_support::sample_image()->hash});
    EXPECT_TRUE(images_of(document.materials.back()->stack).empty());
}

}  // namespace
}  // namespace patina
