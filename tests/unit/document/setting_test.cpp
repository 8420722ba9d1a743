// SPDX-License-Identifier: MIT
#include "document/setting.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "document/edits.h"
#include "document/parameters.h"
#include "document/set_by_text.h"

namespace patina {
namespace {

using testing::HasSubstr;

/// A material "Body" with a layer "Rust" (roughness a noise, a mask entry "Edges") in a group.
Document rusty_document() {
    Layer rust = procedural_layer(ProceduralKind::PerlinNoise);
    rust.id = {3};
    rust.name = "Rust";
    ChannelSettings& roughness = at(rust.channels, Channel::Roughness);
    roughness.enabled = true;
    roughness.source = ProceduralSource{};
    rust.mask.entries.push_back({.id = {4}, .name = "Edges", .source = ProceduralSource{}});
    Layer group = group_layer();
    group.id = {2};
    group.content = GroupContent{.children = {std::make_shared<const Layer>(rust)}};
    Material body;
    body.id = {1};
    body.name = "Body";
    body.stack = {std::make_shared<const Layer>(group)};
    Document document;
    document.materials = {std::make_shared<const Material>(body)};
    document.next_id = 5;
    return document;
}

const Layer& rust_of(const Document& document) {
    return *std::get<GroupContent>(document.materials[0]->stack[0]->content).children[0];
}

Document rusty_after(std::string_view text) {
    return set_by_text(rusty_document(), text);
}

std::string refusal(std::string_view text) {
    const auto setting = setting_from_text(text);
    if (!setting) return setting.error().message;
    const auto document = with_setting(rusty_document(), *setting);
    EXPECT_FALSE(document.has_value()) << text;
    return document ? "" : document.error().message;
}

TEST(Setting, ReachesTheLayerItsChannelsItsSourcesAndItsMask) {
    EXPECT_EQ(rust_of(rusty_after("Body/Rust/opacity=0.5")).opacity, 0.5f);
    EXPECT_EQ(rust_of(rusty_after("Body/Rust/mode=multiply")).mode, BlendMode::Multiply);
    EXPECT_FALSE(rust_of(rusty_after("Body/Rust/visible=off")).visible);
    const auto channel = [](const Document& document, Channel which) {
        return at(rust_of(document).channels, which);
    };
    EXPECT_EQ(channel(rusty_after("Body/Rust/roughness/opacity=0.25"), Channel::Roughness).opacity,
              0.25f);
    const auto scaled = channel(rusty_after("*/Rust/roughness/scale=24"), Channel::Roughness);
    EXPECT_EQ(std::get<ProceduralSource>(scaled.source).scale, 24.0f);
    const auto turned =
        channel(rusty_after("Body/Rust/roughness/transform/rotation=90"), Channel::Roughness);
    EXPECT_EQ(std::get<ProceduralSource>(turned.source).transform.rotation_degrees, 90.0f);
    const auto metal = channel(rusty_after("Body/Rust/metalness=1"), Channel::Metalness);
    EXPECT_TRUE(metal.enabled);
    EXPECT_EQ(std::get<ConstantSource>(metal.source).value.x, 1.0f);
    const auto clear = channel(rusty_after("Body/Rust/opacity/source=0.5"), Channel::Opacity);
    EXPECT_EQ(std::get<ConstantSource>(clear.source).value.x, 0.5f);
    const Document masked = rusty_after("Body/Rust/mask/base=0");
    EXPECT_EQ(rust_of(masked).mask.base, 0.0f);
    const Document gamma = rusty_after("Body/Rust/mask/Edges/levels/gamma=2");
    EXPECT_EQ(rust_of(gamma).mask.entries[0].levels.gamma, 2.0f);
    const Document entry = rusty_after("Body/Rust/mask/Edges/seed=7");
    EXPECT_EQ(std::get<ProceduralSource>(rust_of(entry).mask.entries[0].source).seed, 7u);
}

TEST(Setting, ReachesTheNumbersOfAnAdjustmentOfAMask) {
    Document document = rusty_document();
    Layer rust = rust_of(document);
    rust.mask.entries.push_back(adjustment_mask_entry(AdjustmentKind::BrightnessContrast));
    rust.mask.entries.back().id = {5};
    rust.mask.entries.back().name = "Harder";
    Material body = *document.materials[0];
    body.stack = {std::make_shared<const Layer>(rust)};
    document.materials = {std::make_shared<const Material>(body)};
    const auto entry_after = [&](std::string_view text) {
        const auto after = with_setting(document, *setting_from_text(text));
        EXPECT_TRUE(after.has_value()) << text;
        return after ? after->materials[0]->stack[0]->mask.entries[1] : MaskEntry{};
    };
    EXPECT_EQ(entry_after("Body/Rust/mask/Harder/contrast=0.5").adjustment->contrast, 0.5f);
    EXPECT_EQ(entry_after("Body/Rust/mask/Harder/adjustment/contrast=0.5").adjustment->contrast,
              0.5f);
    EXPECT_EQ(entry_after("Body/Rust/mask/Harder/levels/gamma=2").adjustment->levels.gamma, 2.0f);
    EXPECT_EQ(entry_after("Body/Rust/mask/Harder/combine=screen").combine, BlendMode::Screen);
    EXPECT_EQ(entry_after("Body/Rust/mask/Harder/opacity=0.5").opacity, 0.5f);
    EXPECT_FALSE(with_setting(document, *setting_from_text("Body/Rust/mask/Harder/scale=0")));
}

TEST(Setting, TakesColoursAsArtistsWriteThem) {
    const auto color = [](std::string_view text) {
        const Document document = rusty_after(text);
        return std::get<ConstantSource>(at(rust_of(document).channels, Channel::BaseColor).source)
            .value;
    };
    EXPECT_EQ(color("Body/Rust/base-color=[0.1, 0.2, 0.3]"), glm::vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(color("Body/Rust/base-color=#ffffff"), glm::vec3(1.0f));
    // sRGB 0x80 is 0.2158605 in linear light (IEC 61966-2-1).
    EXPECT_NEAR(color("Body/Rust/base-color=#800000").x, 0.2158605f, 1e-6f);
}

TEST(Setting, ReachesTheMaterial) {
    EXPECT_EQ(rusty_after("Body/resolution=1024").materials[0]->resolution, 1024);
    EXPECT_EQ(rusty_after("Body/alpha-mode=blend").materials[0]->alpha_mode, AlphaMode::Blend);
    EXPECT_EQ(rusty_after("Body/ior=1.33").materials[0]->ior, 1.33f);
    for (const ParameterInfo& parameter : parameters()) {
        if (parameter.subject != Subject::Material) continue;
        EXPECT_THAT(refusal(fmt::format("Body/{}={{}}", parameter.id)), HasSubstr("kind of value"))
            << "every parameter has a row";
    }
}

TEST(Setting, ChangesNothingElse) {
    const Document before = rusty_document();
    const auto after = with_setting(before, *setting_from_text("Body/Rust/opacity=0.5"));
    ASSERT_TRUE(after.has_value());
    Layer back = rust_of(*after);
    back.opacity = 1.0f;
    EXPECT_EQ(back, rust_of(before));
}

TEST(Setting, RefusesWhatIsNotThereOrOutOfRangeAndSaysWhatThereIs) {
    EXPECT_THAT(refusal("Wheel/Rust/opacity=1"), HasSubstr("there are: Body"));
    EXPECT_THAT(refusal("Body/Dust/opacity=1"), HasSubstr("there are: Group, Rust"));
    EXPECT_THAT(refusal("Body/colour=1"), HasSubstr("resolution"));
    EXPECT_THAT(refusal("Body/Rust/opacity=3"), HasSubstr("opacity"));
    EXPECT_THAT(refusal("Body/Rust/opacity=much"), HasSubstr("opacity"));
    EXPECT_THAT(refusal("Body/Rust/mode=plaid"), HasSubstr("mode"));
    EXPECT_THAT(refusal("Body/Rust/smell=1"), HasSubstr("smell"));
    EXPECT_THAT(refusal("Body/Rust/metalness/scale=8"), HasSubstr("one value"));
    EXPECT_THAT(refusal("Body/Rust/id=9"), HasSubstr("cannot be set"));
    for (const char* text : {"", "Body", "Body=1", "/x=1", "Body//x=1", "Body/Rust/opacity"})
        EXPECT_THAT(refusal(text), HasSubstr("is no setting such as")) << text;
}

TEST(Setting, TakesSlashesOfNamesEscaped) {
    const auto setting = setting_from_text("A\\/B/C=D=E");
    ASSERT_TRUE(setting.has_value());
    EXPECT_EQ(setting->material, "A/B");
    EXPECT_THAT(setting->path, testing::ElementsAre("C"));
    EXPECT_EQ(setting->value, "D=E");
}

}  // namespace
}  // namespace patina
