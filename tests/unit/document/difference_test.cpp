// SPDX-License-Identifier: MIT
#include "document/difference.h"

#include <gmock/gmock.h>

#include <gtest/gtest.h>
#include <stdexcept>

#include "document/edits.h"
#include "document/setting.h"

namespace patina {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

LayerPtr named_layer(std::uint64_t id, const char* name) {
    Layer layer = value_layer();
    layer.id = {id};
    layer.name = name;
    return std::make_shared<const Layer>(layer);
}

Document sample() {
    Material body;
    body.id = {1};
    body.name = "Body";
    Layer group = group_layer();
    group.id = {3};
    group.content = GroupContent{.children = {named_layer(4, "Rust")}};
    body.stack = {named_layer(2, "Base"), std::make_shared<const Layer>(group),
                  named_layer(5, "Dust")};
    Document document;
    document.materials = {std::make_shared<const Material>(body)};
    document.next_id = 6;
    return document;
}

Document set(const Document& before, std::string_view text) {
    const auto setting = setting_from_text(text);
    if (!setting) throw std::runtime_error(setting.error().message);
    const auto after = with_setting(before, *setting);
    if (!after) throw std::runtime_error(after.error().message);
    return *after;
}

TEST(DocumentDifference, OfADocumentAndItselfIsNothing) {
    EXPECT_THAT(differences(sample(), sample()), IsEmpty());
}

TEST(DocumentDifference, SaysWhichValueOfWhichLayerDiffersAndHow) {
    const Document after =
        set(set(set(sample(), "Body/Rust/opacity=0.5"), "Body/Rust/roughness/opacity=0.25"),
            "Body/resolution=1024");
    EXPECT_THAT(
        differences(sample(), after),
        ElementsAre(Difference{"Body", "", "resolution is 1024, was 2048"},
                    Difference{"Body", "Group / Rust", "opacity is 0.5, was 1"},
                    Difference{"Body", "Group / Rust", "roughness opacity is 0.25, was 1"}));
}

TEST(DocumentDifference, SaysTheTablesValueOfWhatOneSideDoesNotWrite) {
    const Document procedural =
        set(sample(), R"(Body/Base/roughness={"kind": "perlin-noise", "scale": 8})");
    Document after = procedural;
    for (const char* text :
         {"Body/Base/roughness/scale=24", "Body/Base/roughness/transform/rotation=30",
          "Body/Base/roughness/projection={\"kind\": \"planar\"}", "Body/Base/mode=multiply",
          "Body/Base/visible=false", "Body/Base/height-blend={}", "Body/Base/mask/base=0.25",
          "Body/Base/metalness/enabled=false", "Body/alpha-mode=blend"})
        after = set(after, text);
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
    Document after = sample();
    Material body = *after.materials[0];
    body.stack = {body.stack[2], body.stack[0], named_layer(9, "Scratches")};
    after.materials[0] = std::make_shared<const Material>(body);
    EXPECT_THAT(differences(sample(), after),
                ElementsAre(Difference{"Body", "Scratches", "is new"},
                            Difference{"Body", "Base", "has moved in the stack"},
                            Difference{"Body", "Group", "is gone"}));
}

TEST(DocumentDifference, DoesNotLookAtIds) {
    Document after = sample();
    Material body = *after.materials[0];
    body.id = {77};
    for (LayerPtr& layer : body.stack) {
        Layer copy = *layer;
        copy.id.value += 100;
        layer = std::make_shared<const Layer>(copy);
    }
    after.materials[0] = std::make_shared<const Material>(body);
    EXPECT_THAT(differences(sample(), after), IsEmpty());
}

}  // namespace
}  // namespace patina
