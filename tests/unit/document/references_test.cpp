// SPDX-License-Identifier: MIT
#include "document/references.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "document/edits.h"
#include "document/layer_json.h"
#include "document/preset.h"
#include "document/record.h"
#include "document/setting.h"
#include "document/small_layers.h"

namespace patina {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

void read(Layer& layer, std::uint64_t other, LayerResult result = LayerResult::Roughness) {
    at(layer.channels, Channel::Roughness).source = ReferenceSource{{other}, result};
}

LayerPtr group(std::uint64_t id, std::string name, std::vector<LayerPtr> children) {
    Layer layer = group_layer();
    layer.id = {id};
    layer.name = std::move(name);
    layer.content = GroupContent{.children = std::move(children)};
    return shared(layer);
}

Document document_of(std::vector<LayerPtr> stack) {
    Material material;
    material.id = {100};
    material.name = "Body";
    material.stack = std::move(stack);
    Document document;
    document.materials = {std::make_shared<const Material>(material)};
    document.next_id = 101;
    return document;
}

const Material& material_of(const Document& document) {
    return *document.materials.front();
}

Edit refer(const Document& document, std::uint64_t from, std::uint64_t to,
           Channel channel = Channel::Roughness) {
    const Material& material = material_of(document);
    return set_source(source_place(material, *find_layer(material, {from}), channel),
                      ReferenceSource{{to}, result_of(channel)});
}

std::vector<std::string> names(const std::vector<LayerPtr>& layers) {
    std::vector<std::string> result;
    for (const LayerPtr& layer : layers) result.push_back(layer->name);
    return result;
}

/// A reads B; G holds A; C and D lie beside it, D clipped to C.
Document referring_document() {
    Layer a = named_layer(1, "A");
    read(a, 2);
    Layer d = named_layer(4, "D");
    d.clipped = true;
    return document_of({group(5, "G", {shared(a)}), shared(named_layer(2, "B")),
                        shared(named_layer(3, "C")), shared(d)});
}

TEST(References, AreRefusedWhereALayerWouldDependOnItself) {
    const Document document = referring_document();
    const auto refusal = [&](std::uint64_t from, std::uint64_t to) {
        const auto after = refer(document, from, to).apply(document);
        return after ? std::string() : after.error().message;
    };
    EXPECT_THAT(refusal(1, 1), HasSubstr("A would depend on itself"));
    EXPECT_THAT(refusal(2, 1), HasSubstr("would depend on itself"));
    EXPECT_THAT(refusal(2, 5), HasSubstr("would depend on itself"));  // by the group around A
    EXPECT_THAT(refusal(1, 5), HasSubstr("would depend on itself"));  // its own group
    EXPECT_THAT(refusal(3, 4), HasSubstr("would depend on itself"));  // what is clipped to it
    EXPECT_EQ(refusal(4, 3), "");
    EXPECT_EQ(refusal(1, 4), "");
    EXPECT_EQ(refusal(3, 5), "");
}

TEST(References, AreRefusedWhereMovingOrClippingWouldCloseACycle) {
    Layer c = named_layer(3, "C");
    read(c, 4);
    const Document document = document_of({shared(c), shared(named_layer(4, "D"))});
    const Material& material = material_of(document);
    const Layer& d = *find_layer(material, {4});
    EXPECT_FALSE(set_layer_clipped(material, d, true).apply(document));
    Layer reader = d;
    read(reader, 5);
    const Document grouped = document_of({group(5, "G", {}), shared(reader)});
    EXPECT_FALSE(move_layer(material_of(grouped), d, top_of_group({5})).apply(grouped));
}

TEST(References, OffersTheLayersThatMakeNoCycle) {
    const Document document = referring_document();
    const auto offered = [&](std::uint64_t reader) {
        return names(referable_layers(material_of(document).stack, {reader}));
    };
    EXPECT_THAT(offered(1), ElementsAre("D", "C", "B"));
    EXPECT_THAT(offered(2), ElementsAre("D", "C"));
    EXPECT_THAT(offered(3), ElementsAre("B", "A", "G"));
    EXPECT_THAT(offered(4), ElementsAre("C", "B", "A", "G"));
    for (const std::uint64_t reader : {1u, 2u, 3u, 4u})
        for (const LayerPtr& layer : referable_layers(material_of(document).stack, {reader}))
            EXPECT_TRUE(refer(document, reader, layer->id.value).apply(document))
                << reader << " " << layer->name;
}

TEST(References, AreNormalsForNormalsAndAllElseForAllElse) {
    const Document document = referring_document();
    const Material& material = material_of(document);
    const auto reads = [&](Channel channel, LayerResult result) {
        return set_source(source_place(material, *find_layer(material, {3}), channel),
                          ReferenceSource{{2}, result})
            .apply(document)
            .has_value();
    };
    EXPECT_TRUE(reads(Channel::Normal, LayerResult::Normal));
    EXPECT_FALSE(reads(Channel::Normal, LayerResult::Mask));
    EXPECT_FALSE(reads(Channel::BaseColor, LayerResult::Normal));
    EXPECT_TRUE(reads(Channel::BaseColor, LayerResult::Mask));
    EXPECT_TRUE(reads(Channel::Height, LayerResult::BaseColor));
}

TEST(References, TooManyOfThemAreRefused) {
    // Each layer reads the one below it eight times.
    std::vector<LayerPtr> stack = {shared(named_layer(1, "1"))};
    for (std::uint64_t id = 2; id <= 8; ++id) {
        Layer layer = named_layer(id, std::to_string(id));
        for (int i = 0; i < 8; ++i)
            layer.mask.entries.push_back({.id = {50 * id + static_cast<std::uint64_t>(i)},
                                          .name = "entry",
                                          .source = ReferenceSource{{id - 1}, LayerResult::Mask}});
        stack.push_back(shared(layer));
    }
    const Status status = check_references(stack);
    ASSERT_FALSE(status);
    EXPECT_THAT(status.error().message, HasSubstr("more than 16384 layers"));
    stack.resize(4);
    EXPECT_TRUE(check_references(stack));
}

TEST(References, StayAmongCopiesOfTheLayersAndLeadOutOfThemAsBefore) {
    Layer a = named_layer(1, "A"), b = named_layer(2, "B"), c = named_layer(3, "C");
    read(b, 1);
    read(c, 9);
    Document document = document_of(
        {shared(named_layer(9, "Out")), group(5, "G", {shared(a), shared(b), shared(c)})});
    const Material& material = material_of(document);
    document = duplicate_layer(material, *find_layer(material, {5})).apply(document).value();
    const LayerPtr copy = material_of(document).stack.back();
    const auto& children = std::get<GroupContent>(copy->content).children;
    const auto of = [](const LayerPtr& layer) {
        return std::get<ReferenceSource>(at(layer->channels, Channel::Roughness).source).layer;
    };
    EXPECT_NE(children[0]->id, LayerId{1});
    EXPECT_EQ(of(children[1]), children[0]->id);
    EXPECT_EQ(of(children[2]), LayerId{9});
}

TEST(References, OfPastedLayersMeanTheLayersOfTheSameNamesOrNothing) {
    Layer c = named_layer(3, "C");
    read(c, 9);
    c.mask.entries.push_back({.id = {20}, .name = "Of nine", .source = ReferenceSource{{9}}});
    const Document from = document_of({shared(named_layer(9, "Out")), shared(c)});
    const std::vector<LayerPtr>& stack = material_of(from).stack;
    const std::string text = copied_layers({stack[1]}, stack);
    const auto pasted_into = [&](const Document& document) {
        const Material& material = material_of(document);
        return material_of(paste_layers(material, text, top_of_stack()).apply(document).value())
            .stack.back();
    };
    const auto roughness = [](const LayerPtr& layer) {
        return at(layer->channels, Channel::Roughness);
    };
    // Where it was, and where the number means another layer.
    EXPECT_EQ(std::get<ReferenceSource>(roughness(pasted_into(from)).source).layer, LayerId{9});
    const LayerPtr there =
        pasted_into(document_of({shared(named_layer(9, "Other")), shared(named_layer(4, "Out"))}));
    EXPECT_EQ(std::get<ReferenceSource>(roughness(there).source).layer, LayerId{4});
    EXPECT_EQ(std::get<ReferenceSource>(there->mask.entries.at(0).source).layer, LayerId{4});
    const LayerPtr nowhere = pasted_into(document_of({shared(named_layer(9, "Other"))}));
    EXPECT_FALSE(roughness(nowhere).enabled);
    EXPECT_TRUE(std::holds_alternative<ConstantSource>(roughness(nowhere).source));
    EXPECT_TRUE(nowhere->mask.entries.empty());
}

TEST(References, SurviveTheRecordAndAPreset) {
    const Document document = referring_document();
    const Material& material = material_of(document);
    const auto record = material_record_from_json(to_json(material_record(document, material)));
    ASSERT_TRUE(record.has_value());
    EXPECT_EQ(layers_to_json(record->stack, JsonIds::Kept),
              layers_to_json(material.stack, JsonIds::Kept));

    Preset preset;
    preset.id = "p";
    preset.name = preset.category = preset.author = preset.licence = preset.description = "P";
    preset.layers = material.stack;
    const auto again = preset_from_json(preset_to_json(preset), "p.json");
    ASSERT_TRUE(again.has_value()) << again.error().message;
    EXPECT_EQ(layers_to_json(again->layers, JsonIds::LeftOut),
              layers_to_json(preset.layers, JsonIds::LeftOut));
}

TEST(References, ACycleInAFileIsNamed) {
    Layer a = named_layer(1, "A"), b = named_layer(2, "B");
    read(a, 2);
    read(b, 1);
    MaterialRecord made;
    made.id = {7};
    made.stack = {shared(a), shared(b)};
    const auto record = material_record_from_json(to_json(made));
    ASSERT_FALSE(record.has_value());
    EXPECT_THAT(record.error().message, HasSubstr("would depend on itself"));
}

TEST(References, TheCommandLineNamesTheLayer) {
    const Document document = referring_document();
    const auto set = [&](std::string_view text) {
        return with_setting(document, setting_from_text(text).value());
    };
    const auto after = set(R"(Body/C/roughness={"kind":"layer","layer":"A","result":"metalness"})");
    ASSERT_TRUE(after.has_value()) << after.error().message;
    const LayerPtr c = find_layer(material_of(*after), {3});
    EXPECT_EQ(at(c->channels, Channel::Roughness).source,
              Source(ReferenceSource{{1}, LayerResult::Metalness}));
    EXPECT_FALSE(set(R"(Body/B/roughness={"kind":"layer","layer":"A"})").has_value());
    const auto unknown = set(R"(Body/C/roughness={"kind":"layer","layer":"Z"})");
    ASSERT_FALSE(unknown.has_value());
    EXPECT_THAT(unknown.error().message, HasSubstr("no layer \"Z\""));
}

}  // namespace
}  // namespace patina
