// SPDX-License-Identifier: MIT

/// Which materials there are, and which parts of the model they are drawn on.

#include <gtest/gtest.h>

#include "document/history.h"
#include "document/record.h"
#include "unit/document/sample_document.h"

namespace patina::test_support {
namespace {

Document with(const Document& before, const Edit& edit) {
    Result<Document> after = edit.apply(before);
    if (!after) throw std::runtime_error(edit.label + ": " + after.error().message);
    return std::move(*after);
}

const Material& last_material(const Document& document) {
    return *document.materials.back();
}

std::string material_of_part(const Document& document, std::size_t part) {
    return parts_of(document).at(part).material->name;
}

TEST(MaterialList, AnAddedMaterialIsNamedEmptyAndDrawnOnNothing) {
    const Document before = sample_document();
    const Document after = with(before, add_material("Brass"));
    ASSERT_EQ(after.materials.size(), 3u);
    EXPECT_EQ(last_material(after).name, "Brass");
    EXPECT_EQ(last_material(after).id.value, before.next_id);
    EXPECT_TRUE(last_material(after).stack.empty());
    EXPECT_TRUE(is_added(last_material(after)));
    EXPECT_EQ(material_of_part(after, 0), "Bonnet");
    EXPECT_EQ(material_of_part(after, 1), "Glass");
}

TEST(MaterialList, TheDefaultMaterialStaysLast) {
    Document document = sample_document();
    Material standing_in;
    standing_in.id = MaterialId{40};
    document.materials.push_back(std::make_shared<const Material>(standing_in));
    document = with(document, add_material("Brass"));
    EXPECT_EQ(document.materials[2]->name, "Brass");
    EXPECT_EQ(document.materials[3]->id.value, 40u);
}

TEST(MaterialList, ACopyHasTheSameLayersUnderFreshIds) {
    const Document before = sample_document();
    const Document after = with(before, duplicate_material(*before.materials[0]));
    const Material& copy = last_material(after);
    EXPECT_EQ(copy.name, "Bonnet copy");
    EXPECT_EQ(copy.copied_from, 0);
    EXPECT_EQ(copied_layers(copy.stack), copied_layers(before.materials[0]->stack));
    for (const LayerPtr& layer : all_layers(copy.stack)) EXPECT_GE(layer->id.value, before.next_id);
    const Document twice = with(after, duplicate_material(*before.materials[0]));
    EXPECT_EQ(last_material(twice).name, "Bonnet copy 2");
    EXPECT_NE(last_material(twice).source_material, copy.source_material);
    EXPECT_EQ(last_material(with(twice, duplicate_material(copy))).copied_from, 0);
}

TEST(MaterialList, APartIsDrawnWithWhatItIsAssignedAndGivenBack) {
    Document document = with(sample_document(), add_material("Brass"));
    const Material brass = last_material(document);
    const Part part = parts_of(document)[0];
    EXPECT_EQ(part.name, "Helmet, 1");
    document = with(document, assign_material(brass, part));
    EXPECT_EQ(material_of_part(document, 0), "Brass");
    EXPECT_EQ(material_of_part(document, 1), "Glass");
    EXPECT_EQ(assigned_numbers(document),
              (std::map<PartRef, int>{{part.ref, *brass.source_material}}));
    document = with(document, assign_material(*document.materials[0], part));
    EXPECT_TRUE(document.assigned.empty()) << "what the file says is not said again";
    Part gone = part;
    gone.ref.primitive = 7;
    EXPECT_FALSE(assign_material(brass, gone).apply(document));
}

TEST(MaterialList, OnlyAddedMaterialsCanBeDeletedAndTheirPartsGoBack) {
    Document document = with(sample_document(), add_material("Brass"));
    const Material brass = last_material(document);
    document = with(document, assign_material(brass, parts_of(document)[1]));
    EXPECT_FALSE(remove_material(*document.materials[0]).apply(document));
    document = with(document, remove_material(brass));
    EXPECT_EQ(document.materials.size(), 2u);
    EXPECT_EQ(material_of_part(document, 1), "Glass");
}

TEST(MaterialList, AnAssignmentIsAStepOfTheHistoryAndOfTheComparedText) {
    const auto opened = std::make_shared<const Document>(sample_document());
    History history(opened);
    ASSERT_TRUE(history.apply(assign_material(*opened->materials[1], parts_of(*opened)[0])));
    EXPECT_TRUE(history.can_undo());
    EXPECT_NE(serialise(*history.document()), serialise(*opened));
    history.undo();
    EXPECT_EQ(serialise(*history.document()), serialise(*opened));
}

}  // namespace
}  // namespace patina::test_support
