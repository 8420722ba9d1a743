// SPDX-License-Identifier: MIT
#include "document/check.h"

#include <cmath>

#include "document/layer_edits.h"
#include "document/mask_edits.h"

namespace patina {
namespace {

/// The first failure among statuses that have all been worked out.
Status first_failure(std::initializer_list<Status> statuses) {
    for (const Status& status : statuses)
        if (!status) return status;
    return {};
}

Status check_uv_set(int uv_set) {
    return check_range(Parameter::ImageUvSet, uv_set);
}

Status check_part(SourceUse use, const ConstantSource& source) {
    return check_value(use, source.value);
}

Status check_part(SourceUse, const ImageSource& source) {
    return first_failure({check_uv_set(source.uv_set), check_projection(source.projection),
                          check_transform(source.transform),
                          check_color(Parameter::ImageMultiply, source.multiply),
                          check_color(Parameter::ImageAdd, source.add)});
}

Status check_part(SourceUse use, const ProceduralSource& source) {
    return first_failure({check_range(Parameter::ProceduralScale, source.scale),
                          check_range(Parameter::ProceduralOctaves, source.octaves),
                          check_range(Parameter::ProceduralContrast, source.contrast),
                          check_range(Parameter::ProceduralBalance, source.balance),
                          check_range(Parameter::ProceduralWidth, source.width),
                          check_range(Parameter::ProceduralSoftness, source.softness),
                          check_range(Parameter::ProceduralVariation, source.variation),
                          check_range(Parameter::ProceduralAspect, source.aspect),
                          check_range(Parameter::ProceduralWarp, source.warp),
                          check_projection(source.projection), check_transform(source.transform),
                          check_ramp(use, source.ramp)});
}

Status check_part(SourceUse use, const ReliefSource& source) {
    if (use && info(*use).kind != ChannelKind::Scalar)
        return failure("relief feeds masks and single numbers only");
    return first_failure({check_range(Parameter::ReliefRadius, source.radius_permille),
                          check_range(Parameter::ReliefStrength, source.strength)});
}

Status check_part(SourceUse use, const ReferenceSource& source) {
    if (source.layer == LayerId{}) return failure("a reference has to say to which layer");
    if (reads_result(use, source.result)) return {};
    return failure("normals are read from normals only, and by normals only");
}

Status check_names(const std::vector<std::string>& names) {
    if (names.size() > kMaxGeometryNames)
        return failure("{} names are more than {}", names.size(), kMaxGeometryNames);
    for (const std::string& name : names)
        if (Status status = check_name(name); !status) return status;
    return {};
}

Status check_part(SourceUse use, const GeometrySource& source) {
    if (use && info(*use).kind != ChannelKind::Scalar)
        return failure("parts of the model feed masks and single numbers only");
    return first_failure({check_names(source.meshes), check_names(source.materials)});
}

Status check_entry(const MaskEntry& entry) {
    if (!combines_masks(entry.combine))
        return failure("blend mode {} does not apply to masks", info(entry.combine).id);
    return first_failure({check_name(entry.name),
                          check_range(Parameter::MaskEntryOpacity, entry.opacity),
                          check_levels(entry.levels), check_source(std::nullopt, entry.source),
                          entry.adjustment ? check_adjustment(*entry.adjustment) : Status{},
                          check_mask_adjustment(entry)});
}

Status check_channels(const PerChannel<ChannelSettings>& channels) {
    for (const ChannelInfo& row : kChannels) {
        const ChannelSettings& settings = at(channels, row.channel);
        if (settings.mode && !applies_to(*settings.mode, row.channel))
            return failure("blend mode {} does not apply to the {} channel",
                           info(*settings.mode).id, row.id);
        const Status status =
            first_failure({check_range(Parameter::ChannelOpacity, settings.opacity),
                           check_source(row.channel, settings.source)});
        if (!status) return failure("{} channel: {}", row.id, status.error().message);
    }
    return {};
}

Status check_own_values(const Layer& layer) {
    if (!blends_layer(layer.mode, layer.is_group()))
        return failure(
            "blend mode {} does not apply to {}", info(layer.mode).id,
            layer.mode == BlendMode::PassThrough ? "layers that are no group" : "colours");
    if (const auto* content = std::get_if<AdjustmentContent>(&layer.content)) {
        if (Status status = check_adjustment(content->adjustment); !status) return status;
        if (at(layer.channels, Channel::Normal).enabled &&
            !adjusts(content->adjustment.kind, Channel::Normal))
            return failure("normals can only be blurred, sharpened and warped");
    }
    return first_failure({check_range(Parameter::LayerOpacity, layer.opacity),
                          check_height_blend(layer.height_blend), check_mask(layer.mask),
                          check_channels(layer.channels)});
}

}  // namespace

bool reads_result(SourceUse use, LayerResult result) {
    const bool of_normals = result == LayerResult::Normal;
    const bool for_normals = use && info(*use).kind == ChannelKind::Normal;
    return of_normals == for_normals;
}

bool feeds_number(SourceUse use) {
    return info(value_parameter(use)).kind == ParameterKind::Number;
}
bool feeds_color(SourceUse use) {
    return info(value_parameter(use)).kind == ParameterKind::Color;
}

Status check_name(std::string_view name) {
    if (name.empty()) return failure("a name cannot be empty");
    if (name.size() > kMaxNameBytes)
        return failure("a name can have at most {} bytes, got {}", kMaxNameBytes, name.size());
    if (quoted_for_message(name, name.size()) != name)
        return failure("a name cannot have control characters or broken UTF-8: \"{}\"",
                       quoted_for_message(name, 80));
    return {};
}

Status check_color(Parameter parameter, const glm::vec3& value) {
    return first_failure({check_range(parameter, value.x), check_range(parameter, value.y),
                          check_range(parameter, value.z)});
}

Status check_value(SourceUse use, const glm::vec3& value) {
    const Parameter parameter = value_parameter(use);
    if (feeds_number(use)) return check_range(parameter, value.x);
    if (Status status = check_color(parameter, value); !status) return status;
    if (parameter == Parameter::NormalValue && glm::length(value) < 1e-6f)
        return failure("a normal cannot have length 0");
    return {};
}

glm::vec3 canonical_value(SourceUse use, const glm::vec3& value) {
    if (feeds_number(use)) return {value.x, 0.0f, 0.0f};
    if (feeds_color(use)) return value;
    const float length = glm::length(value);
    // Left as it is when it is a unit vector already, so that doing this twice changes nothing.
    return std::abs(length - 1.0f) < 1e-5f ? value : value / length;
}

Status check_ramp(SourceUse use, const std::vector<RampStop>& stops) {
    if (stops.empty() || stops.size() > std::size_t{kMaxRampStops})
        return failure("a ramp has 1 to {} stops, got {}", kMaxRampStops, stops.size());
    float previous = 0.0f;
    for (const RampStop& stop : stops) {
        if (Status status = check_range(Parameter::RampPosition, stop.position); !status)
            return status;
        if (stop.position < previous)
            return failure("the stops of a ramp must ascend: {} comes after {}", stop.position,
                           previous);
        if (Status status = check_value(use, stop.value); !status) return status;
        previous = stop.position;
    }
    return {};
}

Status check_projection(const Projection& projection) {
    return check_range(Parameter::ProjectionBlend, projection.blend);
}

Status check_transform(const UvTransform& transform) {
    if (transform.scale.x == 0.0f || transform.scale.y == 0.0f) return failure("Scale cannot be 0");
    return first_failure({check_range(Parameter::UvOffset, transform.offset.x),
                          check_range(Parameter::UvOffset, transform.offset.y),
                          check_range(Parameter::UvScale, transform.scale.x),
                          check_range(Parameter::UvScale, transform.scale.y),
                          check_range(Parameter::UvRotation, transform.rotation_degrees)});
}

Status check_source(SourceUse use, const Source& source) {
    return std::visit([&](const auto& part) { return check_part(use, part); }, source);
}

Status check_levels(const Levels& levels) {
    const Status ranges = first_failure({check_range(Parameter::LevelsInLow, levels.in_low),
                                         check_range(Parameter::LevelsInHigh, levels.in_high),
                                         check_range(Parameter::LevelsGamma, levels.gamma),
                                         check_range(Parameter::LevelsOutLow, levels.out_low),
                                         check_range(Parameter::LevelsOutHigh, levels.out_high)});
    if (!ranges) return ranges;
    if (levels.in_low <= levels.in_high) return {};
    return failure("levels need black no higher than white, got {} and {}", levels.in_low,
                   levels.in_high);
}

namespace {

Status check_curve(const std::vector<CurvePoint>& points) {
    if (points.size() < 2 || points.size() > std::size_t{kMaxCurvePoints})
        return failure("a curve has 2 to {} points, got {}", kMaxCurvePoints, points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (Status status = first_failure({check_range(Parameter::CurveX, points[i].x),
                                           check_range(Parameter::CurveY, points[i].y)});
            !status)
            return status;
        if (i > 0 && !(points[i].x > points[i - 1].x))
            return failure("the points of a curve must ascend: {} comes after {}", points[i].x,
                           points[i - 1].x);
    }
    return {};
}

}  // namespace

Status check_adjustment(const AdjustmentSettings& adjustment) {
    const Status status =
        first_failure({check_levels(adjustment.levels), check_curve(adjustment.curve),
                       check_range(Parameter::AdjustmentHue, adjustment.hue_degrees),
                       check_range(Parameter::AdjustmentSaturation, adjustment.saturation),
                       check_range(Parameter::AdjustmentLightness, adjustment.lightness),
                       check_range(Parameter::AdjustmentBrightness, adjustment.brightness),
                       check_range(Parameter::AdjustmentContrast, adjustment.contrast),
                       check_range(Parameter::AdjustmentSteps, adjustment.steps),
                       check_ramp(Channel::BaseColor, adjustment.gradient),
                       check_range(Parameter::AdjustmentLow, adjustment.low),
                       check_range(Parameter::AdjustmentHigh, adjustment.high),
                       check_range(Parameter::AdjustmentRadius, adjustment.radius_permille),
                       check_range(Parameter::AdjustmentAmount, adjustment.amount),
                       check_range(Parameter::AdjustmentDistance, adjustment.distance_permille),
                       check_range(Parameter::AdjustmentScale, adjustment.scale),
                       check_range(Parameter::AdjustmentOctaves, adjustment.octaves)});
    if (!status) return status;
    if (adjustment.low <= adjustment.high) return {};
    return failure("the least value must not exceed the greatest, got {} and {}", adjustment.low,
                   adjustment.high);
}

Status check_height_blend(const HeightBlend& blend) {
    return first_failure({check_range(Parameter::HeightBlendOffset, blend.offset),
                          check_range(Parameter::HeightBlendRadius, blend.radius),
                          check_range(Parameter::HeightBlendContrast, blend.contrast)});
}

Status check_mask_adjustment(const MaskEntry& entry) {
    if (!entry.adjustment) return {};
    const AdjustmentKind kind = entry.adjustment->kind;
    if (!adjusts_masks(kind))
        return failure("a mask has no colours to adjust by {}: use levels or curves",
                       choice(kind).id);
    if (entry.source == MaskEntry{}.source && entry.levels == Levels{}) return {};
    return failure("an adjustment of a mask has neither a source nor levels beside it");
}

Status check_mask(const Mask& mask) {
    if (mask.entries.size() > std::size_t{kMaxMaskEntries})
        return failure("a mask has at most {} entries, got {}", kMaxMaskEntries,
                       mask.entries.size());
    if (Status status = check_range(Parameter::MaskBase, mask.base); !status) return status;
    for (const MaskEntry& entry : mask.entries)
        if (Status status = check_entry(entry); !status)
            return failure("mask entry {}: {}", quoted_for_message(entry.name, 80),
                           status.error().message);
    return {};
}

Status check_layer(const Layer& layer) {
    if (Status status = check_name(layer.name); !status) return status;
    if (Status status = check_own_values(layer); !status)
        return failure("layer {}: {}", quoted_for_message(layer.name, 80), status.error().message);
    if (const auto* group = std::get_if<GroupContent>(&layer.content))
        for (const LayerPtr& child : group->children)
            if (Status status = check_layer(*child); !status) return status;
    return {};
}

Status check_light(const Light& light) {
    const Status ranges =
        first_failure({check_color(Parameter::LightColor, light.color_linear),
                       check_range(Parameter::LightIntensity, light.intensity),
                       check_color(Parameter::LightPosition, light.position_world),
                       check_color(Parameter::LightDirection, light.direction_world),
                       check_range(Parameter::LightRange, light.range),
                       check_range(Parameter::LightInnerCone, light.inner_cone_radians),
                       check_range(Parameter::LightOuterCone, light.outer_cone_radians),
                       check_range(Parameter::LightRadius, light.radius_m),
                       check_range(Parameter::LightWidth, light.width_m),
                       check_range(Parameter::LightHeight, light.height_m),
                       check_range(Parameter::LightTurn, light.turn_radians)});
    if (!ranges) return ranges;
    if (glm::length(light.direction_world) < 1e-6f)
        return failure("the direction of a light cannot have length 0");
    if (light.kind == Light::Kind::Spot && light.inner_cone_radians >= light.outer_cone_radians)
        return failure("the inner cone of a light must be narrower than the outer one");
    return {};
}

}  // namespace patina
