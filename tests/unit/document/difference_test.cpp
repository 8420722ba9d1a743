// SPDX-License-Identifier: MIT
#include "document/difference.h"

#include <gmock/gmock.h>

#include <gtest/gtest.h>

#include "document/edits.h"
#include "document/set_by_text.h"
#include "document/small_layers.h"

namespace patina {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Document worn_document() {
    Material body;
    body.id = {1};
    body.name = "Body";
    Layer group = group_layer();
    group.id = {3};
    group.content = GroupContent{.children = {shared(named_layer(4, "Rust"))}};
    body.stack = {shared(named_layer(2, "Base")), shared(group), shared(named_layer(5, "Dust"))};
    Document document;
    document.materials = {std::make_shared<const Material>(body)};
    document.next_id = 6;
    return document;
}

TEST(DocumentDifference, OfADocumentAndItselfIsNothing) {
    EXPECT_THAT(differences(worn_document(), worn_document()), IsEmpty());
}

TEST(DocumentDifference, SaysWhichValueOfWhichLayerDiffersAndHow) {
    const Document after =
        set_by_text(set_by_text(set_by_text(worn_document(), "Body/Rust/opacity=0.5"),
                                "Body/Rust/roughness/opacity=0.25"),
                    "Body/resolution=1024");
    EXPECT_THAT(
        differences(worn_document(), after),
        ElementsAre(Difference{"Body", "", "resolution is 1024, was 2048"},
                    Difference{"Body", "Group / Rust", "opacity is 0.5, was 1"},
                    Difference{"Body", "Group / Rust", "roughness opacity is 0.25, was 1"}));
}

TEST(DocumentDifference, SaysTheTablesValueOfWhatOneSideDoesNotWrite) {
    const Document procedural =
        set_by_text(worn_document(), R"(Body/Base/roughness={"kind": "perlin-noise", "scale": 8})");
    Document after = procedural;
    for (const char* text :
         {"Body/Base/roughness/scale=24", "Body/Base/roughness/transform/rotation=30",
          "Body/Base/roughness/projection={\"kind\": \"planar\"}", "Body/Base/mode=multiply",
          "Body/Base/visible=false", "Body/Base/height-blend={}", "Body/Base/mask/base=0.25",
          "Body/Base/metalness/enabled=false", "Body/alpha-mode=blend"})
        after = set_by_text(after, text);
    EXPECT_THAT(
        differences(procedural, after),
        testing::UnorderedElementsAre(
            Difference{"Body", "", "alpha-mode is blend, was opaque"},
            Difference{"Body", "Base", "roughness source scale is 24, was 8"},
            Difference{"Body", "Base", "roughness source transform rotation is 30, was 0"},
            Difference{"Body", "Base", "roughness source projection kind is planar, was uv"},
            Difference{"Body", "Base", "mode is multiply, was normal"},
            Difference{"Body", "Base", "visible is false, was true"},
            Difference{"Body", "Base", "height-blend enabled is true, was false"},
            Difference{"Body", "Base", "mask base is 0.25, was 1"},
            Difference{"Body", "Base", "metalness enabled is false, was true"}));
}

TEST(DocumentDifference, NamesWhatIsNewWhatIsGoneAndWhatHasMoved) {
    Document after = worn_document();
    Material body = *after.materials[0];
    body.stack = {body.stack[2], body.stack[0], shared(named_layer(9, "Scratches"))};
    after.materials[0] = std::make_shared<const Material>(body);
    EXPECT_THAT(differences(worn_document(), after),
                ElementsAre(Difference{"Body", "Scratches", "is new"},
                            Difference{"Body", "Base", "has moved in the stack"},
                            Difference{"Body", "Group", "is gone"}));
}

TEST(DocumentDifference, DoesNotLookAtIds) {
    Document after = worn_document();
    Material body = *after.materials[0];
    body.id = {77};
    for (LayerPtr& layer : body.stack) {
        Layer copy = *layer;
        copy.id.value += 100;
        layer = shared(copy);
    }
    after.materials[0] = std::make_shared<const Material>(body);
    EXPECT_THAT(differences(worn_document(), after), IsEmpty());
}

}  // namespace
}  // namespace patina
