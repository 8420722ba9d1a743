// SPDX-License-Identifier: MIT
#include "document/edits.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <limits>
#include <set>

#include "document/history.h"
#include "document/preset.h"
#include "document/record.h"
#include "unit/document/sample_document.h"

namespace patina {
namespace {

using test_support::all_ids;
using test_support::all_layers;
using test_support::Choices;
using test_support::random_edit;
using test_support::sample_document;
using test_support::sample_image;

/// The document, its first material and the layers of the sample by name.
struct Sample {
    Document document = sample_document();

    const Material& material() const { return *document.materials.front(); }
    const Layer& layer(std::string_view name) const {
        for (const LayerPtr& each : all_layers(material().stack))
            if (each->name == name) return *each;
        throw std::out_of_range("no such layer");
    }
    /// Applies an edit that has to work.
    void apply(const Edit& edit) {
        Result<Document> after = edit.apply(document);
        ASSERT_TRUE(after) << edit.label << ": " << after.error().message;
        document = std::move(*after);
    }
    std::string refusal(const Edit& edit) const {
        const Result<Document> after = edit.apply(document);
        return after ? "" : after.error().message;
    }
    std::vector<std::string> names() const {
        std::vector<std::string> result;
        for (const LayerPtr& each : all_layers(material().stack)) result.push_back(each->name);
        return result;
    }
};

using Names = std::vector<std::string>;

TEST(Edits, IdsStayUniqueOverAnyEdits) {
    const bool holds = rc::check([](const std::vector<std::uint32_t>& numbers) {
        Document document = sample_document();
        Choices choices(numbers);
        while (!choices.used_up()) {
            const std::uint64_t next_before = document.next_id;
            if (Result<Document> after = random_edit(document, choices).apply(document))
                document = *after;
            RC_ASSERT(document.next_id >= next_before);
            std::vector<std::uint64_t> ids = all_ids(document);
            std::sort(ids.begin(), ids.end());
            RC_ASSERT(std::adjacent_find(ids.begin(), ids.end()) == ids.end());
            RC_ASSERT(ids.empty() || (ids.front() > 0 && ids.back() < document.next_id));
        }
    });
    EXPECT_TRUE(holds);
}

TEST(Edits, NoEditChangesTheDocumentThatItIsAppliedTo) {
    const bool holds = rc::check([](const std::vector<std::uint32_t>& numbers) {
        const Document document = sample_document();
        const std::string before = serialise(document);
        Choices choices(numbers);
        const Edit edit = random_edit(document, choices);
        const Result<Document> first = edit.apply(document);
        const Result<Document> second = edit.apply(document);
        RC_ASSERT(serialise(document) == before);
        RC_ASSERT(first.has_value() == second.has_value());
        if (first) RC_ASSERT(serialise(*first) == serialise(*second));
    });
    EXPECT_TRUE(holds);
}

TEST(Edits, EveryRefusalIsOneLineAndEveryEditHasALabel) {
    const bool holds = rc::check([](const std::vector<std::uint32_t>& numbers) {
        Document document = sample_document();
        Choices choices(numbers);
        while (!choices.used_up()) {
            const Edit edit = random_edit(document, choices);
            RC_ASSERT(!edit.label.empty());
            const Result<Document> after = edit.apply(document);
            if (after) {
                document = *after;
                continue;
            }
            const std::string& message = after.error().message;
            RC_ASSERT(!message.empty());
            RC_ASSERT(message.back() != '.');
            RC_ASSERT(std::none_of(message.begin(), message.end(),
                                   [](char c) { return c >= 0 && c < 0x20; }));
        }
    });
    EXPECT_TRUE(holds);
}

TEST(Edits, RandomEditsAreOftenAcceptedSoThatTheTestsAboveMeanSomething) {
    std::vector<std::uint32_t> numbers;
    std::uint32_t state = 1;
    for (int i = 0; i < 40'000; ++i)
        numbers.push_back((state = state * 1664525u + 1013904223u) >> 4);
    Choices choices(numbers);
    Document document = sample_document();
    std::map<std::string, int> accepted;  // by the first word or two of the label
    int tried = 0;
    while (!choices.used_up()) {
        const Edit edit = random_edit(document, choices);
        ++tried;
        Result<Document> after = edit.apply(document);
        if (!after) continue;
        ++accepted[edit.label.substr(0, edit.label.find(' '))];
        // Kept small, so that nothing is refused for being too much.
        document =
            all_layers(after->materials.front()->stack).size() > 40 ? sample_document() : *after;
    }
    int total = 0;
    for (const auto& [word, count] : accepted) total += count;
    EXPECT_GT(total, tried / 3);
    EXPECT_GT(accepted.size(), 35u) << "whole families of edits were never accepted";
}

TEST(Edits, UntouchedLayersKeepTheirNodes) {
    const Sample sample;
    const Result<Document> after =
        set_layer_opacity(sample.material(), sample.layer("Verdigris"), 0.5f)
            .apply(sample.document);
    ASSERT_TRUE(after);
    const auto& before_stack = sample.material().stack;
    const auto& after_stack = after->materials.front()->stack;
    EXPECT_EQ(after_stack[0], before_stack[0]);
    EXPECT_NE(after_stack[1], before_stack[1]) << "the group around the change is made anew";
    EXPECT_EQ(after_stack[2], before_stack[2]);
    const auto& children = std::get<GroupContent>(after_stack[1]->content).children;
    EXPECT_EQ(children[1], std::get<GroupContent>(before_stack[1]->content).children[1]);
    EXPECT_EQ(after->materials[1], sample.document.materials[1]);
    EXPECT_EQ(after->images, sample.document.images);
}

TEST(Edits, LayersAreAddedWhereThePlaceSays) {
    Sample sample;
    const auto add = [&](std::string name, LayerPlace place) {
        Layer layer = value_layer();
        layer.name = std::move(name);
        const LayerId expected = next_layer_id(sample.document);
        sample.apply(add_layer(sample.material(), layer, place));
        EXPECT_NE(find_layer(sample.material(), expected), nullptr);
    };
    add("Top", top_of_stack());
    add("Over", above(sample.layer("Imported textures").id));
    add("Under", below(sample.layer("Imported textures").id));
    add("Crown", top_of_group(sample.layer("Weathering").id));
    add("Root", below(sample.layer("Salt").id));
    EXPECT_EQ(sample.names(),
              (Names{"Under", "Imported textures", "Over", "Weathering", "Verdigris", "Inner",
                     "Root", "Salt", "Crown", "Edge polish", "Top"}));
    EXPECT_EQ(sample.refusal(add_layer(sample.material(), value_layer(),
                                       top_of_group(sample.layer("Top").id))),
              "Top is not a group: layers cannot go into it");
}

TEST(Edits, LayersMoveIntoAndOutOfGroupsWithTheirIds) {
    Sample sample;
    const LayerId salt = sample.layer("Salt").id;
    sample.apply(move_layer(sample.material(), sample.layer("Inner"), top_of_stack()));
    EXPECT_EQ(sample.names(), (Names{"Imported textures", "Weathering", "Verdigris", "Edge polish",
                                     "Inner", "Salt"}));
    EXPECT_EQ(sample.layer("Salt").id, salt);
    sample.apply(move_layer(sample.material(), sample.layer("Imported textures"),
                            top_of_group(sample.layer("Inner").id)));
    EXPECT_EQ(sample.names(), (Names{"Weathering", "Verdigris", "Edge polish", "Inner", "Salt",
                                     "Imported textures"}));
}

TEST(Edits, AGroupCannotGoIntoItself) {
    const Sample sample;
    const Layer& group = sample.layer("Weathering");
    const std::string message = "Weathering cannot go into itself";
    EXPECT_EQ(sample.refusal(move_layer(sample.material(), group, top_of_group(group.id))),
              message);
    EXPECT_EQ(sample.refusal(move_layer(sample.material(), group, above(sample.layer("Salt").id))),
              message);
    EXPECT_EQ(sample.refusal(
                  move_layer(sample.material(), group, top_of_group(sample.layer("Inner").id))),
              message);
}

TEST(Edits, ADuplicateHasFreshIdsThroughoutAndIsUnlocked) {
    Sample sample;
    sample.apply(set_layer_locked(sample.material(), sample.layer("Weathering"), true));
    const std::size_t before = all_ids(sample.document).size();
    sample.apply(duplicate_layer(sample.material(), sample.layer("Weathering")));
    const std::vector<std::uint64_t> ids = all_ids(sample.document);
    EXPECT_EQ(ids.size(), before + 6);  // the group, three layers in it, two mask entries
    EXPECT_EQ(std::set<std::uint64_t>(ids.begin(), ids.end()).size(), ids.size());
    EXPECT_FALSE(sample.layer("Weathering copy").locked);
    EXPECT_EQ(sample.material().stack[2]->name, "Weathering copy");
}

TEST(Edits, CopiedLayersArePastedWithFreshIdsAndTheSameContent) {
    Sample sample;
    const std::string text = copied_layers({sample.material().stack[1]});
    sample.apply(paste_layers(sample.material(), text, top_of_stack()));
    const std::vector<std::uint64_t> ids = all_ids(sample.document);
    EXPECT_EQ(std::set<std::uint64_t>(ids.begin(), ids.end()).size(), ids.size());
    EXPECT_EQ(copied_layers({sample.material().stack.back()}), text);

    EXPECT_EQ(sample.refusal(paste_layers(sample.material(), "hello", top_of_stack())),
              "the clipboard holds no layers");
    sample.document.images.clear();
    EXPECT_NE(sample.refusal(paste_layers(sample.material(), text, top_of_stack())), "");
}

TEST(Edits, LockedLayersRefuseAllButUnlockingAndVisibility) {
    Sample sample;
    sample.apply(set_layer_locked(sample.material(), sample.layer("Weathering"), true));
    const Material& material = sample.material();
    const Layer& group = sample.layer("Weathering");
    const Layer& inside = sample.layer("Verdigris");
    const std::string own = "Weathering is locked: unlock it first";
    const std::string around = "Verdigris is in Weathering, which is locked: unlock it first";
    EXPECT_EQ(sample.refusal(set_layer_opacity(material, group, 0.5f)), own);
    EXPECT_EQ(sample.refusal(rename_layer(material, group, "New")), own);
    EXPECT_EQ(sample.refusal(remove_layer(material, group)), own);
    EXPECT_EQ(sample.refusal(move_layer(material, group, top_of_stack())), own);
    EXPECT_EQ(sample.refusal(add_layer(material, value_layer(), top_of_group(group.id))), own);
    EXPECT_EQ(sample.refusal(set_mask_base(material, group, 0.5f)), own);
    EXPECT_EQ(sample.refusal(replace_stack(material, {}, "Clear")), own);
    EXPECT_EQ(sample.refusal(set_layer_opacity(material, inside, 0.5f)), around);
    EXPECT_EQ(sample.refusal(move_layer(material, inside, top_of_stack())), around);
    EXPECT_EQ(
        sample.refusal(set_uv_rotation(source_place(material, inside, Channel::BaseColor), 5.0f)),
        around);
    sample.apply(set_layer_visible(sample.material(), sample.layer("Weathering"), false));
    sample.apply(set_group_open(sample.material(), sample.layer("Weathering"), false));
    sample.apply(set_layer_locked(sample.material(), sample.layer("Weathering"), false));
    sample.apply(remove_layer(sample.material(), sample.layer("Weathering")));
}

TEST(Edits, GroupingTakesSiblingsAndUngroupingGivesThemBack) {
    Sample sample;
    const Names before = sample.names();
    const auto& stack = sample.material().stack;
    sample.apply(group_layers(sample.material(), {stack[2], stack[0]}));
    EXPECT_EQ(sample.names(), (Names{"Weathering", "Verdigris", "Inner", "Salt", "Group",
                                     "Imported textures", "Edge polish"}));
    sample.apply(ungroup_layer(sample.material(), sample.layer("Group")));
    EXPECT_EQ(sample.names().size(), before.size());
    const auto salt = find_layer(sample.material(), sample.layer("Salt").id);
    EXPECT_EQ(sample.refusal(group_layers(sample.material(), {sample.material().stack[0], salt})),
              "only layers of one list can be grouped: choose them side by side");
}

TEST(Edits, NumbersOutsideTheirRangeAreRefusedAndNotClamped) {
    const Sample sample;
    const Material& material = sample.material();
    const Layer& layer = sample.layer("Verdigris");
    const SourcePlace noise = source_place(material, layer, Channel::BaseColor);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(sample.refusal(set_layer_opacity(material, layer, 3.0f)),
              "Opacity must be 0 to 1, got 3");
    for (const float bad : {-0.01f, 1.01f, nan, std::numeric_limits<float>::infinity()}) {
        EXPECT_NE(sample.refusal(set_layer_opacity(material, layer, bad)), "");
        EXPECT_NE(sample.refusal(set_channel_opacity(material, layer, Channel::Height, bad)), "");
        EXPECT_NE(sample.refusal(set_mask_base(material, layer, bad)), "");
        EXPECT_NE(sample.refusal(set_material_alpha_cutoff(material, bad)), "");
        EXPECT_NE(sample.refusal(set_procedural_balance(noise, bad)), "");
    }
    EXPECT_NE(sample.refusal(set_procedural_octaves(noise, 11)), "");
    EXPECT_NE(sample.refusal(set_uv_scale(noise, {0.0f, 1.0f})), "");
    EXPECT_NE(sample.refusal(set_material_resolution(material, 1000)), "");
    EXPECT_NE(sample.refusal(set_material_resolution(material, 128)), "");
    EXPECT_NE(sample.refusal(set_environment_intensity(101.0f)), "");
    EXPECT_NE(sample.refusal(set_ramp(noise, {})), "");
    EXPECT_NE(sample.refusal(set_ramp(noise, {{1.0f, {}}, {0.0f, {}}})), "");
}

TEST(Edits, WhatIsUnknownIsRefused) {
    Sample sample;
    const Layer gone = sample.layer("Salt");
    sample.apply(remove_layer(sample.material(), gone));
    const Material& material = sample.material();
    EXPECT_NE(sample.refusal(set_layer_opacity(material, gone, 0.5f)), "");
    EXPECT_NE(sample.refusal(add_layer(material, value_layer(), above(gone.id))), "");
    EXPECT_NE(sample.refusal(remove_layer(material, gone)), "");
    EXPECT_NE(sample.refusal(remove_light(1)), "");
    Material other = material;
    other.id = MaterialId{77};
    EXPECT_EQ(sample.refusal(rename_material(other, "X")), "there is no material 77");
    ImageAsset image = *sample_image();
    image.hash = hash_text("another");
    EXPECT_NE(sample.refusal(add_layer(material, image_layer(image), top_of_stack())), "");
}

TEST(Edits, BlendModesHaveToSuitTheChannel) {
    Sample sample;
    const Material& material = sample.material();
    const Layer& layer = sample.layer("Verdigris");
    EXPECT_NE(sample.refusal(set_layer_mode(material, layer, BlendMode::HeightMax)), "");
    EXPECT_NE(sample.refusal(set_channel_mode(material, layer, Channel::Normal, BlendMode::Screen)),
              "");
    sample.apply(set_channel_mode(material, layer, Channel::Height, BlendMode::HeightMax));
    const Layer& after = sample.layer("Verdigris");
    EXPECT_EQ(effective_blend_mode(after, Channel::Height), BlendMode::HeightMax);
    EXPECT_EQ(effective_blend_mode(after, Channel::BaseColor), BlendMode::Multiply);
    EXPECT_EQ(effective_blend_mode(after, Channel::Roughness), BlendMode::Normal);
    EXPECT_EQ(effective_blend_mode(after, Channel::Occlusion), BlendMode::Multiply);
    EXPECT_EQ(effective_blend_mode(after, Channel::Normal), BlendMode::NormalRnm);
}

TEST(Edits, ConstantsAreKeptInOneForm) {
    Sample sample;
    const auto constant = [&](Channel channel, const glm::vec3& value) {
        const Layer& layer = sample.layer("Edge polish");
        const SourcePlace place = source_place(sample.material(), layer, channel);
        sample.apply(set_constant(place, value));
        return std::get<ConstantSource>(*find_source(sample.material(), place)).value;
    };
    EXPECT_EQ(constant(Channel::Roughness, {0.25f, 9.0f, 9.0f}), glm::vec3(0.25f, 0.0f, 0.0f));
    EXPECT_EQ(constant(Channel::BaseColor, {0.1f, 0.2f, 0.3f}), glm::vec3(0.1f, 0.2f, 0.3f));
    EXPECT_NEAR(glm::length(constant(Channel::Normal, {0.5f, 0.0f, 0.5f})), 1.0f, 1e-6f);
    const SourcePlace normal =
        source_place(sample.material(), sample.layer("Edge polish"), Channel::Normal);
    EXPECT_EQ(sample.refusal(set_constant(normal, glm::vec3(0.0f))),
              "a normal cannot have length 0");
}

TEST(Edits, SourcesOfTheWrongKindAreRefused) {
    const Sample sample;
    const Material& material = sample.material();
    const SourcePlace value = source_place(material, sample.layer("Salt"), Channel::BaseColor);
    EXPECT_EQ(sample.refusal(set_procedural_scale(value, 4.0f)),
              "the source of Salt is not a procedural");
    EXPECT_EQ(sample.refusal(set_image_invert(value, true)), "the source of Salt is not an image");
    EXPECT_EQ(sample.refusal(set_uv_rotation(value, 4.0f)),
              "the source of Salt has no UV transform");
}

TEST(Edits, SeveralSourcesAreMovedInOneStepThatADragGoesOnWith) {
    Sample sample;
    const auto places = [&] {
        std::vector<SourcePlace> result;
        for (const Channel channel : {Channel::BaseColor, Channel::Roughness})
            result.push_back(source_place(sample.material(), sample.layer("Salt"), channel));
        return result;
    };
    for (const SourcePlace& place : places()) sample.apply(set_source(place, ProceduralSource{}));
    History history(std::make_shared<const Document>(sample.document));
    const auto turn = [&](float degrees) {
        return at_all(places(),
                      [&](const SourcePlace& place) { return set_uv_rotation(place, degrees); });
    };
    const auto turned = [&](std::size_t which) {
        const Material& material = *history.document()->materials.front();
        return std::get<ProceduralSource>(*find_source(material, places()[which]))
            .transform.rotation_degrees;
    };
    for (const float degrees : {10.0f, 20.0f, 30.0f}) ASSERT_TRUE(history.apply(turn(degrees)));
    EXPECT_EQ(turned(0), 30.0f);
    EXPECT_EQ(turned(1), 30.0f);
    history.undo();
    EXPECT_EQ(turned(0), 0.0f);
    EXPECT_EQ(turned(1), 0.0f);
    EXPECT_FALSE(history.can_undo());
}

TEST(Edits, MaskEntriesAreAddedMovedAndRemoved) {
    Sample sample;
    const auto layer = [&]() -> const Layer& { return sample.layer("Verdigris"); };
    const auto names = [&] {
        Names result;
        for (const MaskEntry& entry : layer().mask.entries) result.push_back(entry.name);
        return result;
    };
    const MaskEntryId expected = next_mask_entry_id(sample.document);
    sample.apply(add_mask_entry(sample.material(), layer(),
                                procedural_mask_entry(ProceduralKind::WorleyNoise)));
    EXPECT_EQ(layer().mask.entries.back().id, expected);
    EXPECT_EQ(names(), (Names{"Drips", "crust.png", "Worley noise (F1)"}));
    sample.apply(move_mask_entry(sample.material(), layer(), layer().mask.entries[2], 0));
    EXPECT_EQ(names(), (Names{"Worley noise (F1)", "Drips", "crust.png"}));
    sample.apply(duplicate_mask_entry(sample.material(), layer(), layer().mask.entries[1]));
    EXPECT_EQ(names(), (Names{"Worley noise (F1)", "Drips", "Drips", "crust.png"}));
    sample.apply(remove_mask_entry(sample.material(), layer(), layer().mask.entries[0]));
    EXPECT_EQ(names(), (Names{"Drips", "Drips", "crust.png"}));
    const MaskEntry entry = layer().mask.entries[0];
    EXPECT_NE(sample.refusal(move_mask_entry(sample.material(), layer(), entry, 3)), "");
    EXPECT_NE(sample.refusal(set_mask_entry_levels(sample.material(), layer(), entry,
                                                   {.in_low = 0.9f, .in_high = 0.1f})),
              "");
    sample.apply(clear_mask(sample.material(), layer()));
    EXPECT_EQ(layer().mask, Mask{});
}

TEST(Edits, AnAdjustmentOfAMaskIsChangedByItsOwnEditAndHasNoSource) {
    Sample sample;
    const auto layer = [&]() -> const Layer& { return sample.layer("Verdigris"); };
    sample.apply(
        add_mask_entry(sample.material(), layer(), adjustment_mask_entry(AdjustmentKind::Curves)));
    const MaskEntry entry = layer().mask.entries.back();
    EXPECT_EQ(entry.combine, BlendMode::Replace);
    AdjustmentSettings changed = *entry.adjustment;
    changed.curve[0].y = 0.25f;
    const Edit edit =
        set_mask_entry_adjustment(sample.material(), layer(), entry, changed, Parameter::CurveY);
    EXPECT_EQ(edit.label, "Output of mask entry Curves");
    EXPECT_NE(edit.merge_key, MergeKey{});
    sample.apply(edit);
    EXPECT_EQ(layer().mask.entries.back().adjustment, changed);

    changed.kind = AdjustmentKind::HueSaturation;
    EXPECT_NE(sample.refusal(set_mask_entry_adjustment(sample.material(), layer(), entry, changed,
                                                       Parameter::AdjustmentKindChoice)),
              "");
    EXPECT_NE(sample.refusal(set_mask_entry_adjustment(sample.material(), layer(),
                                                       layer().mask.entries[0], {},
                                                       Parameter::AdjustmentKindChoice)),
              "");
    EXPECT_NE(sample.refusal(set_constant(source_place(sample.material(), layer(), entry), {})),
              "");
    EXPECT_NE(
        sample.refusal(set_mask_entry_levels(sample.material(), layer(), entry, {.gamma = 2.0f})),
        "");
    EXPECT_NE(sample.refusal(
                  set_mask_entry_combine(sample.material(), layer(), entry, BlendMode::HueW3c)),
              "");
}

TEST(Edits, APresetOfSeveralLayersBecomesAGroupAndOfOneALayer) {
    Sample sample;
    Preset preset;
    preset.name = "Chipped enamel";
    preset.layers = {std::make_shared<const Layer>(value_layer())};
    sample.apply(apply_preset(sample.material(), preset, top_of_stack()));
    EXPECT_FALSE(sample.material().stack.back()->is_group());
    preset.layers.push_back(std::make_shared<const Layer>(procedural_layer({})));
    const Edit edit = apply_preset(sample.material(), preset, top_of_stack());
    EXPECT_EQ(edit.label, "Apply preset to Bonnet");
    sample.apply(edit);
    EXPECT_EQ(sample.material().stack.back()->name, "Chipped enamel");
    EXPECT_TRUE(sample.material().stack.back()->is_group());
    sample.apply(replace_stack_by_preset(sample.material(), preset));
    EXPECT_EQ(sample.names(), (Names{"Chipped enamel", "Fill", "Value noise"}));
}

TEST(Edits, AStepOfSeveralEditsIsAllOrNothing) {
    const Sample sample;
    const Material& material = sample.material();
    const Layer& layer = sample.layer("Salt");
    EXPECT_NE(sample.refusal(in_one_step("Both", {set_layer_opacity(material, layer, 0.5f),
                                                  set_layer_opacity(material, layer, 5.0f)})),
              "");
}

TEST(Edits, LayersBeyondTheLimitsAreRefused) {
    Sample sample;
    Layer layer = value_layer();
    for (int depth = 1; depth < kMaxLayerDepth; ++depth) {
        Layer group = group_layer();
        group.content = GroupContent{.children = {std::make_shared<const Layer>(layer)}};
        layer = group;
    }
    sample.apply(add_layer(sample.material(), layer, top_of_stack()));
    EXPECT_NE(
        sample.refusal(add_layer(sample.material(), layer, top_of_group(sample.layer("Inner").id))),
        "");
    const std::vector<LayerPtr> many(kMaxLayers, std::make_shared<const Layer>(value_layer()));
    EXPECT_NE(sample.refusal(add_layers(sample.material(), many, top_of_stack(), "Many")), "");
}

}  // namespace
}  // namespace patina
