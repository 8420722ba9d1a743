// SPDX-License-Identifier: MIT
#include "document/parameters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "core/files.h"

namespace patina {
namespace {

using nlohmann::json;

bool has_range(ParameterKind kind) {
    return kind == ParameterKind::Integer || kind == ParameterKind::Number ||
           kind == ParameterKind::Color || kind == ParameterKind::Vector;
}

TEST(Parameters, EveryRowIsCompleteAndStandsAtItsEnumerator) {
    for (std::size_t i = 0; i < parameters().size(); ++i) {
        const ParameterInfo& row = parameters()[i];
        EXPECT_EQ(static_cast<std::size_t>(row.parameter), i) << row.id;
        EXPECT_FALSE(row.id.empty());
        EXPECT_FALSE(row.label.empty()) << row.id;
        EXPECT_TRUE(row.tooltip.ends_with('.')) << row.id;
        EXPECT_LT(row.tooltip.size(), 110u) << row.id << ": two lines of a tooltip at most";
        EXPECT_EQ(parameter_from_id(row.subject, row.id), row.parameter)
            << row.id << " is there twice";
    }
}

TEST(Parameters, RangesHoldTheirStandardAndAreStatedWhereTheyMatter) {
    for (const ParameterInfo& row : parameters()) {
        if (!has_range(row.kind)) continue;
        EXPECT_LT(row.minimum, row.maximum) << row.id;
        EXPECT_TRUE(check_range(row.parameter, row.standard)) << row.id;
        EXPECT_GT(row.step, 0.0) << row.id;
        EXPECT_FALSE(check_range(row.parameter, row.minimum - 1.0)) << row.id;
        EXPECT_FALSE(check_range(row.parameter, row.maximum + row.maximum * 1e-3 + 1.0)) << row.id;
        EXPECT_FALSE(check_range(row.parameter, std::numeric_limits<double>::quiet_NaN()));
        if (row.curve == SliderCurve::Logarithmic) {
            EXPECT_GT(row.minimum, 0.0) << row.id;
        }
    }
}

TEST(Parameters, WholeOnesRefuseDecimals) {
    EXPECT_TRUE(check_range(Parameter::ProceduralScale, 8.0));
    EXPECT_FALSE(check_range(Parameter::ProceduralScale, 8.4));
    EXPECT_FALSE(check_range(Parameter::AdjustmentScale, 8.4));
}

TEST(Parameters, PercentAndPixelsAndSeedsHaveNoDecimalsAndDegreesHaveOne) {
    for (const ParameterInfo& row : parameters()) {
        if (row.unit == "%" || row.unit == "px") {
            EXPECT_EQ(row.decimals, 0) << row.id;
        }
        if (row.unit == "°") {
            EXPECT_EQ(row.decimals, 1) << row.id;
        }
        if (row.kind == ParameterKind::Integer) {
            EXPECT_EQ(row.decimals, 0) << row.id;
        }
        if (row.unit == "%") {
            EXPECT_EQ(row.display_scale, 100.0) << row.id;
        }
    }
}

TEST(Parameters, StandardsAreThoseOfNewValues) {
    const auto standard = [](Parameter parameter) { return info(parameter).standard; };
    const ProceduralSource noise;
    EXPECT_EQ(standard(Parameter::ProceduralScale), noise.scale);
    EXPECT_EQ(standard(Parameter::ProceduralOctaves), noise.octaves);
    EXPECT_EQ(standard(Parameter::ProceduralContrast), noise.contrast);
    EXPECT_EQ(standard(Parameter::ProceduralBalance), noise.balance);
    EXPECT_EQ(standard(Parameter::ProceduralWidth), noise.width);
    EXPECT_FLOAT_EQ(static_cast<float>(standard(Parameter::ProceduralSoftness)), noise.softness);
    EXPECT_EQ(standard(Parameter::ProceduralVariation), noise.variation);
    EXPECT_EQ(standard(Parameter::ProceduralAspect), noise.aspect);
    EXPECT_EQ(standard(Parameter::ProceduralWarp), noise.warp);
    EXPECT_EQ(standard(Parameter::ProceduralKindChoice), static_cast<double>(noise.kind));
    const ImageSource image;
    EXPECT_EQ(standard(Parameter::ImageMultiply), image.multiply.x);
    EXPECT_EQ(standard(Parameter::ImageAdd), image.add.x);
    EXPECT_EQ(standard(Parameter::ImageColorSpace), static_cast<double>(image.color_space));
    const HeightBlend height_blend;
    EXPECT_EQ(standard(Parameter::HeightBlendOffset), height_blend.offset);
    EXPECT_FLOAT_EQ(static_cast<float>(standard(Parameter::HeightBlendRadius)),
                    height_blend.radius);
    EXPECT_EQ(standard(Parameter::HeightBlendContrast), height_blend.contrast);
    const ReliefSource relief;
    EXPECT_EQ(standard(Parameter::ReliefKindChoice), static_cast<double>(relief.kind));
    EXPECT_EQ(standard(Parameter::ReliefRadius), relief.radius_permille);
    EXPECT_EQ(standard(Parameter::ReliefStrength), relief.strength);
    const Projection projection;
    EXPECT_EQ(standard(Parameter::ProjectionAxisChoice), static_cast<double>(projection.axis));
    EXPECT_FLOAT_EQ(static_cast<float>(standard(Parameter::ProjectionBlend)), projection.blend);
    const AdjustmentSettings adjustment;
    EXPECT_EQ(standard(Parameter::AdjustmentRadius), adjustment.radius_permille);
    EXPECT_EQ(standard(Parameter::AdjustmentAmount), adjustment.amount);
    EXPECT_EQ(standard(Parameter::AdjustmentDistance), adjustment.distance_permille);
    EXPECT_EQ(standard(Parameter::AdjustmentScale), adjustment.scale);
    EXPECT_EQ(standard(Parameter::AdjustmentOctaves), adjustment.octaves);
    const Levels levels;
    EXPECT_EQ(standard(Parameter::LevelsInHigh), levels.in_high);
    EXPECT_EQ(standard(Parameter::LevelsGamma), levels.gamma);
    EXPECT_EQ(standard(Parameter::LevelsOutHigh), levels.out_high);
    const MaskEntry entry;
    EXPECT_EQ(standard(Parameter::MaskEntryOpacity), entry.opacity);
    const Material material;
    EXPECT_EQ(standard(Parameter::MaterialResolution), material.resolution);
    EXPECT_FLOAT_EQ(static_cast<float>(standard(Parameter::MaterialHeightScale)),
                    material.height_scale);
    EXPECT_EQ(standard(Parameter::MaterialIor), material.ior);
    EXPECT_EQ(standard(Parameter::MaterialAlphaCutoff), material.alpha_cutoff);
    EXPECT_EQ(standard(Parameter::MaterialEmissiveStrength), material.emissive_strength);
    EXPECT_EQ(standard(Parameter::LayerOpacity), Layer{}.opacity);
    const Light light;
    EXPECT_FLOAT_EQ(static_cast<float>(standard(Parameter::LightRadius)), light.radius_m);
    EXPECT_EQ(standard(Parameter::LightWidth), light.width_m);
    EXPECT_EQ(standard(Parameter::LightHeight), light.height_m);
    EXPECT_EQ(standard(Parameter::LightTurn), light.turn_radians);
}

TEST(Parameters, ChoicesHaveUniqueIdsThatReadBack) {
    for (const ParameterInfo& row : parameters()) {
        std::set<std::string_view> ids;
        for (const Choice& each : row.choices) {
            EXPECT_TRUE(ids.insert(each.id).second) << row.id << " " << each.id;
            EXPECT_FALSE(each.label.empty());
        }
    }
    EXPECT_EQ(choice_from_id<LayerResult>("mask"), LayerResult::Mask);
    EXPECT_EQ(choice(AlphaMode::Blend).label, "Blend");
    EXPECT_EQ(choice(ProceduralKind::WorleyNoise).id, "worley-noise");
    EXPECT_FALSE(choice_from_id<Wrap>("tile"));
}

/// The schema's rule for a number, which may be one of the alternatives of a number or several.
const json& number_rule(const json& rule) {
    return rule.contains("anyOf") ? rule["anyOf"][0] : rule;
}

TEST(Parameters, TheSchemaStatesTheSameRangesStandardsAndChoices) {
    const json schema = json::parse(
        read_text_file(std::filesystem::path(PATINA_SOURCE_DIR) / "presets/schema.json").value());
    const json& defs = schema["$defs"];
    const std::map<Subject, std::string> places = {
        {Subject::Layer, "/fill"},
        {Subject::Channel, "/color-channel"},
        {Subject::Image, "/image"},
        {Subject::UvTransform, "/transform"},
        {Subject::Mask, "/mask"},
        {Subject::Procedural, "/procedural-scalar"},
        {Subject::Levels, "/levels"},
        {Subject::MaskEntry, "/mask-entry"},
        {Subject::Light, "/light"},
        {Subject::HeightBlend, "/height-blend"},
        {Subject::Relief, "/relief"},
        {Subject::Adjustment, "/adjustment"},
        {Subject::Reference, "/reference"},
        {Subject::Geometry, "/geometry"},
        {Subject::Projection, "/projection"},
    };
    int compared = 0;
    for (const ParameterInfo& row : parameters()) {
        const auto place = places.find(row.subject);
        if (place == places.end()) continue;
        json properties = defs.at(json::json_pointer(place->second))["properties"];
        if (row.parameter == Parameter::RampPosition)
            properties = properties["ramp"]["items"]["properties"];
        if (row.parameter == Parameter::CurveX || row.parameter == Parameter::CurveY)
            properties = properties["curve"]["items"]["properties"];
        ASSERT_TRUE(properties.contains(row.id)) << row.id;
        json rule = properties[std::string(row.id)];
        if (rule.contains("$ref"))
            rule = schema.at(json::json_pointer(rule["$ref"].get<std::string>().substr(1)));
        if (has_range(row.kind)) {
            EXPECT_EQ(number_rule(rule)["minimum"].get<double>(), row.minimum) << row.id;
            EXPECT_EQ(number_rule(rule)["maximum"].get<double>(), row.maximum) << row.id;
            ++compared;
        }
        if (rule.contains("default") && rule["default"].is_number()) {
            EXPECT_EQ(rule["default"].get<double>(), row.standard) << row.id;
        }
        if (!row.choices.empty()) {
            json ids = json::array();
            for (const Choice& each : row.choices) ids.push_back(each.id);
            EXPECT_EQ(rule["enum"], ids) << row.id;
            ++compared;
        }
    }
    EXPECT_GT(compared, 30);
}

TEST(Parameters, ModesOfTheSchemaAreThoseOfTheTable) {
    const json schema = json::parse(
        read_text_file(std::filesystem::path(PATINA_SOURCE_DIR) / "presets/schema.json").value());
    const std::map<std::string, Channel> examples = {{"color-mode", Channel::BaseColor},
                                                     {"scalar-mode", Channel::Roughness},
                                                     {"normal-mode", Channel::Normal},
                                                     {"height-mode", Channel::Height}};
    for (const auto& [name, channel] : examples) {
        json expected = json::array();
        for (const BlendModeInfo& row : kBlendModes)
            if (applies_to(row.mode, channel)) expected.push_back(row.id);
        EXPECT_EQ(schema["$defs"][name]["enum"], expected) << name;
    }
}

TEST(Parameters, ModesAndAdjustmentsOfMasksInTheSchemaAreThoseThatMasksTake) {
    const json schema = json::parse(
        read_text_file(std::filesystem::path(PATINA_SOURCE_DIR) / "presets/schema.json").value());
    json modes = json::array(), kinds = json::array();
    for (const BlendModeInfo& row : kBlendModes)
        if (combines_masks(row.mode)) modes.push_back(row.id);
    for (std::size_t i = 0; i < kAdjustmentKinds.size(); ++i)
        if (adjusts_masks(static_cast<AdjustmentKind>(i))) kinds.push_back(kAdjustmentKinds[i].id);
    EXPECT_EQ(schema["$defs"]["mask-mode"]["enum"], modes);
    EXPECT_EQ(schema["$defs"]["mask-adjustment"]["properties"]["kind"]["enum"], kinds);
}

}  // namespace
}  // namespace patina
