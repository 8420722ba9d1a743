// SPDX-License-Identifier: MIT
#include "document/material_warnings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "document/edits.h"

namespace patina {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A material with one layer of that opacity channel, in a group.
Material material_with_opacity(float value) {
    Layer fill = value_layer();
    at(fill.channels, Channel::Opacity) = {.enabled = true,
                                           .source = ConstantSource{glm::vec3(value)}};
    Layer group = group_layer();
    group.content = GroupContent{.children = {std::make_shared<const Layer>(fill)}};
    Material material;
    material.name = "Leaf";
    material.stack = {std::make_shared<const Layer>(group)};
    return material;
}

TEST(MaterialWarnings, NameOpacityThatTheAlphaModeDoesNotShow) {
    Material leaf = material_with_opacity(0.5f);
    EXPECT_THAT(warnings_of({}, leaf),
                ElementsAre(testing::AllOf(HasSubstr("\"Leaf\""), HasSubstr("alpha-mode"))));
    leaf.alpha_mode = AlphaMode::Mask;
    EXPECT_THAT(warnings_of({}, leaf), IsEmpty());
}

TEST(MaterialWarnings, SayNothingOfOpacityThatIsOneOrHidden) {
    EXPECT_THAT(warnings_of({}, material_with_opacity(1.0f)), IsEmpty());
    Material leaf = material_with_opacity(0.5f);
    Layer hidden = *leaf.stack[0];
    hidden.visible = false;
    leaf.stack = {std::make_shared<const Layer>(hidden)};
    EXPECT_THAT(warnings_of({}, leaf), IsEmpty());
}

}  // namespace
}  // namespace patina
