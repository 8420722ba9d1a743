// SPDX-License-Identifier: MIT
#include "document/history.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <set>

#include "document/record.h"
#include "unit/document/sample_document.h"

namespace patina {
namespace {

using test_support::Choices;
using test_support::random_edit;
using test_support::sample_document;

DocumentPtr opened() {
    return std::make_shared<const Document>(sample_document());
}

const Material& first_material(const History& history) {
    return *history.document()->materials.front();
}
LayerPtr top_layer(const History& history) {
    return first_material(history).stack.back();
}

Edit opacity_of_top(const History& history, float opacity) {
    return set_layer_opacity(first_material(history), *top_layer(history), opacity);
}

/// The whole of a snapshot, what serialise leaves out of it included.
std::string whole_text(const Document& document) {
    return serialise(document) + std::to_string(document.next_id);
}

TEST(History, AnyEditsUndoneAndRedoneGiveTheSameBytes) {
    const bool holds = rc::check([](const std::vector<std::uint32_t>& numbers) {
        History history(opened());
        Choices choices(numbers);
        std::vector<std::string> texts = {whole_text(*history.document())};
        while (!choices.used_up()) {
            if (choices.below(4) == 0) history.seal();
            const std::size_t steps = history.labels().size();
            const Status status = history.apply(random_edit(*history.document(), choices));
            if (!status) RC_ASSERT(whole_text(*history.document()) == texts.back());
            if (history.labels().size() == steps) texts.pop_back();
            texts.push_back(whole_text(*history.document()));
        }
        RC_ASSERT(history.labels().size() == texts.size());
        for (std::size_t i = texts.size(); i-- > 0;) {
            RC_ASSERT(whole_text(*history.document()) == texts[i]);
            history.undo();
        }
        RC_ASSERT(!history.can_undo());
        RC_ASSERT(!history.is_edited());
        for (const std::string& text : texts) {
            RC_ASSERT(whole_text(*history.document()) == text);
            history.redo();
        }
        RC_ASSERT(!history.can_redo());
    });
    EXPECT_TRUE(holds);
}

TEST(History, ADragIsOneStepUntilItIsSealed) {
    History history(opened());
    for (const float opacity : {0.9f, 0.8f, 0.7f})
        ASSERT_TRUE(history.apply(opacity_of_top(history, opacity)));
    EXPECT_EQ(history.labels(), (std::vector<std::string>{"Open", "Opacity of Edge polish"}));
    EXPECT_EQ(top_layer(history)->opacity, 0.7f);

    history.seal();
    ASSERT_TRUE(history.apply(opacity_of_top(history, 0.6f)));
    EXPECT_EQ(history.labels().size(), 3u);

    history.undo();
    EXPECT_EQ(top_layer(history)->opacity, 0.7f);
    history.undo();
    EXPECT_EQ(top_layer(history)->opacity, 1.0f);
}

TEST(History, EditsOfDifferentThingsDoNotMerge) {
    History history(opened());
    const Material& material = first_material(history);
    const Layer& layer = *top_layer(history);
    ASSERT_TRUE(history.apply(set_layer_opacity(material, layer, 0.5f)));
    ASSERT_TRUE(history.apply(set_channel_opacity(material, layer, Channel::Height, 0.5f)));
    ASSERT_TRUE(history.apply(set_channel_opacity(material, layer, Channel::Normal, 0.5f)));
    ASSERT_TRUE(history.apply(set_layer_opacity(material, *material.stack.front(), 0.5f)));
    EXPECT_EQ(history.labels().size(), 5u);
}

TEST(History, AnEditAfterUndoDoesNotMergeAndDropsWhatCouldBeRedone) {
    History history(opened());
    ASSERT_TRUE(history.apply(opacity_of_top(history, 0.5f)));
    history.seal();
    ASSERT_TRUE(history.apply(opacity_of_top(history, 0.4f)));
    history.undo();
    ASSERT_TRUE(history.apply(opacity_of_top(history, 0.3f)));
    EXPECT_EQ(history.labels().size(), 3u);
    EXPECT_FALSE(history.can_redo());
    history.undo();
    EXPECT_EQ(top_layer(history)->opacity, 0.5f);
}

TEST(History, AnEditThatChangesNothingMakesNoStep) {
    History history(opened());
    const DocumentPtr before = history.document();
    const Material& material = first_material(history);
    ASSERT_TRUE(history.apply(opacity_of_top(history, 1.0f)));
    ASSERT_TRUE(
        history.apply(move_layer(material, *material.stack[0], below(material.stack[1]->id))));
    ASSERT_TRUE(history.apply(add_image(test_support::sample_image())));
    EXPECT_EQ(history.document(), before);
    EXPECT_EQ(history.labels().size(), 1u);
}

TEST(History, ARefusedEditChangesNothing) {
    History history(opened());
    const DocumentPtr before = history.document();
    EXPECT_FALSE(history.apply(opacity_of_top(history, 2.0f)));
    EXPECT_EQ(history.document(), before);
    EXPECT_FALSE(history.can_undo());
}

TEST(History, JumpingShowsAnyStepAndKeepsTheOthers) {
    History history(opened());
    for (const float opacity : {0.9f, 0.8f, 0.7f}) {
        ASSERT_TRUE(history.apply(opacity_of_top(history, opacity)));
        history.seal();
    }
    EXPECT_TRUE(history.jump_to(1));
    EXPECT_EQ(top_layer(history)->opacity, 0.9f);
    EXPECT_TRUE(history.jump_to(3));
    EXPECT_EQ(top_layer(history)->opacity, 0.7f);
    EXPECT_FALSE(history.jump_to(4));
    EXPECT_FALSE(history.jump_to(-1));
    EXPECT_EQ(history.position(), 3);
}

TEST(History, IsEditedIsRelativeToTheLastSave) {
    History history(opened());
    EXPECT_FALSE(history.is_edited());
    ASSERT_TRUE(history.apply(opacity_of_top(history, 0.5f)));
    EXPECT_TRUE(history.is_edited());
    history.mark_saved(history.document());
    EXPECT_FALSE(history.is_edited());
    // The drag goes on after the save: it must not be taken for what was saved.
    ASSERT_TRUE(history.apply(opacity_of_top(history, 0.4f)));
    EXPECT_TRUE(history.is_edited());
    history.undo();
    EXPECT_FALSE(history.is_edited());
    history.undo();
    EXPECT_TRUE(history.is_edited());
}

TEST(History, TheOldestStepsAreForgottenBeyondTheBudget) {
    constexpr std::size_t budget = 64 << 10;
    History history(opened(), budget);
    for (int i = 0; i < 500; ++i) {
        ASSERT_TRUE(history.apply(opacity_of_top(history, static_cast<float>(i) / 500.0f)));
        history.seal();
        EXPECT_LE(history.bytes(), budget);
    }
    EXPECT_LT(history.labels().size(), 500u);
    EXPECT_GT(history.labels().size(), 2u);
    EXPECT_EQ(history.position(), static_cast<int>(history.labels().size()) - 1);
    while (history.can_undo()) history.undo();
    EXPECT_GT(top_layer(history)->opacity, 0.5f) << "the recent steps have to stay";
}

TEST(History, TheLastEditCanBeUndoneHoweverLargeItIs) {
    History history(opened(), 0);
    ASSERT_TRUE(history.apply(opacity_of_top(history, 0.5f)));
    history.seal();
    ASSERT_TRUE(history.apply(opacity_of_top(history, 0.4f)));
    EXPECT_EQ(history.labels().size(), 2u);
    history.undo();
    EXPECT_EQ(top_layer(history)->opacity, 0.5f);
}

/// What a document with one layer costs by itself.
std::size_t bytes_with(Layer layer) {
    Material material;
    material.stack = {std::make_shared<const Layer>(std::move(layer))};
    Document document;
    document.materials = {std::make_shared<const Material>(std::move(material))};
    return added_bytes(nullptr, &document);
}

TEST(History, AStepCostsTheCurvesGradientsAndPartNamesOfItsLayers) {
    AdjustmentContent content;
    const std::size_t plain = bytes_with({.content = content});
    content.adjustment.curve.resize(1000);
    content.adjustment.gradient.resize(2000);
    EXPECT_GE(bytes_with({.content = content}),
              plain + 900 * sizeof(CurvePoint) + 1900 * sizeof(RampStop));
    Layer masked;
    masked.mask.entries.push_back({.source = GeometrySource{}});
    const std::size_t unnamed = bytes_with(masked);
    masked.mask.entries[0].source = GeometrySource{.meshes = {std::string(5000, 'a')}};
    EXPECT_GE(bytes_with(masked), unnamed + 5000);
}

TEST(History, AStepCostsWhatItChangedAndNotTheWholeDocument) {
    const Document before = sample_document();
    const Material& material = *before.materials.front();
    const Result<Document> after =
        set_layer_opacity(material, *material.stack.back(), 0.5f).apply(before);
    ASSERT_TRUE(after);
    const std::size_t step = added_bytes(&before, &*after);
    EXPECT_GE(step, sizeof(Layer) + sizeof(Material));
    EXPECT_LT(step, 2 * sizeof(Layer) + sizeof(Material) + sizeof(Document) + 500);
    EXPECT_GT(added_bytes(nullptr, &before), step + 5 * sizeof(Layer));
}

}  // namespace
}  // namespace patina
