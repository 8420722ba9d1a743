// SPDX-License-Identifier: MIT
// The half of layer_json.h that writes.
#include "document/check.h"
#include "document/layer_json.h"

namespace patina {
namespace {

Json value_to_json(SourceUse use, const glm::vec3& value) {
    if (feeds_number(use)) return json_of(value.x);
    if (feeds_color(use)) return json_of(value);
    return Json::array({json_of(value.x), json_of(value.y), json_of(value.z)});
}

template <typename Value>
void add_unless(Json& json, std::string_view key, const Value& value, const Value& standard) {
    if (value != standard) json[std::string(key)] = value;
}
void add_unless(Json& json, std::string_view key, float value, float standard) {
    if (value != standard) json[std::string(key)] = json_of(value);
}
void add_unless(Json& json, std::string_view key, const glm::vec2& value,
                const glm::vec2& standard) {
    if (value != standard) json[std::string(key)] = json_of(value);
}
void add_unless(Json& json, std::string_view key, const glm::vec3& value,
                const glm::vec3& standard) {
    if (value != standard) json[std::string(key)] = json_of(value);
}
template <typename Enumeration>
void add_choice_unless(Json& json, std::string_view key, Enumeration value, Enumeration standard) {
    if (value != standard) json[std::string(key)] = choice(value).id;
}

void add_transform(Json& json, const UvTransform& transform) {
    const UvTransform standard;
    if (transform == standard) return;
    Json part = Json::object();
    add_unless(part, "offset", transform.offset, standard.offset);
    add_unless(part, "scale", transform.scale, standard.scale);
    add_unless(part, "rotation", transform.rotation_degrees, standard.rotation_degrees);
    json["transform"] = std::move(part);
}

void add_projection(Json& json, const Projection& projection) {
    const Projection standard;
    if (projection == standard) return;
    Json part = Json::object();
    part["kind"] = choice(projection.kind).id;
    add_choice_unless(part, "axis", projection.axis, standard.axis);
    add_unless(part, "blend", projection.blend, standard.blend);
    json["projection"] = std::move(part);
}

Json part_to_json(SourceUse use, const ConstantSource& source) {
    return value_to_json(use, source.value);
}

Json part_to_json(SourceUse, const ImageSource& source) {
    const ImageSource standard;
    Json json = {{"kind", "image"}, {"image", to_hex(source.image)}};
    add_choice_unless(json, "color-space", source.color_space, standard.color_space);
    add_choice_unless(json, "pick", source.pick, standard.pick);
    add_unless(json, "invert", source.invert, standard.invert);
    add_unless(json, "directx-normal", source.directx_normal, standard.directx_normal);
    add_unless(json, "alpha-is-coverage", source.alpha_is_coverage, standard.alpha_is_coverage);
    add_unless(json, "uv-set", source.uv_set, standard.uv_set);
    add_projection(json, source.projection);
    add_transform(json, source.transform);
    add_choice_unless(json, "wrap-u", source.wrap_u, standard.wrap_u);
    add_choice_unless(json, "wrap-v", source.wrap_v, standard.wrap_v);
    add_choice_unless(json, "filter", source.filter, standard.filter);
    add_unless(json, "multiply", source.multiply, standard.multiply);
    add_unless(json, "add", source.add, standard.add);
    return json;
}

Json ramp_to_json(SourceUse use, const std::vector<RampStop>& stops) {
    Json ramp = Json::array();
    for (const RampStop& stop : stops)
        ramp.push_back(
            {{"position", json_of(stop.position)}, {"value", value_to_json(use, stop.value)}});
    return ramp;
}

Json part_to_json(SourceUse use, const ProceduralSource& source) {
    const ProceduralSource standard;
    Json json = {{"kind", choice(source.kind).id}};
    add_unless(json, "seed", source.seed, standard.seed);
    add_unless(json, "scale", source.scale, standard.scale);
    add_unless(json, "octaves", source.octaves, standard.octaves);
    add_unless(json, "contrast", source.contrast, standard.contrast);
    add_unless(json, "balance", source.balance, standard.balance);
    add_unless(json, "width", source.width, standard.width);
    add_unless(json, "softness", source.softness, standard.softness);
    add_unless(json, "variation", source.variation, standard.variation);
    add_unless(json, "aspect", source.aspect, standard.aspect);
    add_unless(json, "warp", source.warp, standard.warp);
    add_projection(json, source.projection);
    add_transform(json, source.transform);
    if (Json ramp = ramp_to_json(use, source.ramp); ramp != ramp_to_json(use, standard.ramp))
        json["ramp"] = std::move(ramp);
    return json;
}

Json part_to_json(SourceUse, const ReliefSource& source) {
    const ReliefSource standard;
    Json json = {{"kind", choice(source.kind).id}};
    add_unless(json, "radius", source.radius_permille, standard.radius_permille);
    add_unless(json, "strength", source.strength, standard.strength);
    return json;
}

Json part_to_json(SourceUse, const ReferenceSource& source) {
    Json json = {{"kind", "layer"}, {"layer", source.layer.value}};
    add_choice_unless(json, "result", source.result, ReferenceSource{}.result);
    return json;
}

Json part_to_json(SourceUse, const GeometrySource& source) {
    Json json = {{"kind", "geometry"}};
    if (!source.meshes.empty()) json["meshes"] = source.meshes;
    if (!source.materials.empty()) json["materials"] = source.materials;
    return json;
}

Json source_to_json(SourceUse use, const Source& source) {
    return std::visit([&](const auto& part) { return part_to_json(use, part); }, source);
}

Json levels_to_json(const Levels& levels) {
    const Levels standard;
    Json json = Json::object();
    add_unless(json, "in-low", levels.in_low, standard.in_low);
    add_unless(json, "in-high", levels.in_high, standard.in_high);
    add_unless(json, "gamma", levels.gamma, standard.gamma);
    add_unless(json, "out-low", levels.out_low, standard.out_low);
    add_unless(json, "out-high", levels.out_high, standard.out_high);
    return json;
}

/// One that is there is on, unless it says otherwise.
Json height_blend_to_json(const HeightBlend& blend) {
    const HeightBlend standard;
    Json json = Json::object();
    if (!blend.enabled) json["enabled"] = false;
    add_unless(json, "offset", blend.offset, standard.offset);
    add_unless(json, "radius", blend.radius, standard.radius);
    add_unless(json, "contrast", blend.contrast, standard.contrast);
    return json;
}

Json adjustment_to_json(const AdjustmentSettings& adjustment) {
    const AdjustmentSettings standard;
    Json json = {{"kind", choice(adjustment.kind).id}};
    if (adjustment.levels != standard.levels) json["levels"] = levels_to_json(adjustment.levels);
    if (adjustment.curve != standard.curve) {
        Json points = Json::array();
        for (const CurvePoint& point : adjustment.curve)
            points.push_back({{"x", json_of(point.x)}, {"y", json_of(point.y)}});
        json["curve"] = std::move(points);
    }
    add_unless(json, "hue", adjustment.hue_degrees, standard.hue_degrees);
    add_unless(json, "saturation", adjustment.saturation, standard.saturation);
    add_unless(json, "lightness", adjustment.lightness, standard.lightness);
    add_unless(json, "brightness", adjustment.brightness, standard.brightness);
    add_unless(json, "contrast", adjustment.contrast, standard.contrast);
    add_unless(json, "steps", adjustment.steps, standard.steps);
    if (adjustment.gradient != standard.gradient)
        json["gradient"] = ramp_to_json(Channel::BaseColor, adjustment.gradient);
    add_unless(json, "low", adjustment.low, standard.low);
    add_unless(json, "high", adjustment.high, standard.high);
    add_unless(json, "radius", adjustment.radius_permille, standard.radius_permille);
    add_unless(json, "amount", adjustment.amount, standard.amount);
    add_unless(json, "distance", adjustment.distance_permille, standard.distance_permille);
    add_unless(json, "scale", adjustment.scale, standard.scale);
    add_unless(json, "octaves", adjustment.octaves, standard.octaves);
    add_unless(json, "seed", adjustment.seed, standard.seed);
    return json;
}

std::string_view kind_of(const Layer& layer) {
    if (layer.is_adjustment()) return "adjustment";
    return layer.is_group() ? "group" : "fill";
}

Json entry_to_json(const MaskEntry& entry, JsonIds ids) {
    const MaskEntry standard;
    const BlendMode combine = entry.adjustment ? BlendMode::Replace : standard.combine;
    Json json = Json::object();
    if (ids == JsonIds::Kept) json["id"] = entry.id.value;
    json["name"] = entry.name;
    add_unless(json, "visible", entry.visible, standard.visible);
    if (entry.combine != combine) json["combine"] = info(entry.combine).id;
    add_unless(json, "opacity", entry.opacity, standard.opacity);
    add_unless(json, "invert", entry.invert, standard.invert);
    if (entry.adjustment)
        json["adjustment"] = adjustment_to_json(*entry.adjustment);
    else
        json["source"] = source_to_json(std::nullopt, entry.source);
    if (entry.levels != standard.levels) json["levels"] = levels_to_json(entry.levels);
    return json;
}

Json mask_to_json(const Mask& mask, JsonIds ids) {
    const Mask standard;
    Json json = Json::object();
    add_unless(json, "enabled", mask.enabled, standard.enabled);
    add_unless(json, "invert", mask.invert, standard.invert);
    add_unless(json, "base", mask.base, standard.base);
    if (mask.entries.empty()) return json;
    Json entries = Json::array();
    for (const MaskEntry& entry : mask.entries) entries.push_back(entry_to_json(entry, ids));
    json["entries"] = std::move(entries);
    return json;
}

Json channels_to_json(const Layer& layer) {
    const PerChannel<ChannelSettings>& channels = layer.channels;
    const bool of_group = layer.is_group();
    const bool of_fill = !of_group && !layer.is_adjustment();
    const PerChannel<ChannelSettings> standards = default_channels();
    Json json = Json::object();
    for (const ChannelInfo& row : kChannels) {
        const ChannelSettings& settings = at(channels, row.channel);
        ChannelSettings standard = at(standards, row.channel);
        standard.enabled = of_group;
        if (settings == standard) continue;
        Json part = Json::object();
        if (!settings.enabled) part["enabled"] = false;
        const bool has_source = settings.source != standard.source;
        // A fill's channel that is on says its value, be it the standard one, for whoever reads it.
        if (has_source || (settings.enabled && of_fill))
            part["source"] = source_to_json(row.channel, settings.source);
        if (settings.mode) part["mode"] = info(*settings.mode).id;
        add_unless(part, "opacity", settings.opacity, standard.opacity);
        json[std::string(row.id)] = std::move(part);
    }
    return json;
}

/// `referred`: the layers whose ids are written whether or not others are.
Json list_to_json(const LayerList& layers, JsonIds ids, const std::set<LayerId>& referred);

Json layer_to_json(const Layer& layer, JsonIds ids, const std::set<LayerId>& referred) {
    const Layer standard;
    Json json = Json::object();
    if (ids == JsonIds::Kept || referred.contains(layer.id)) json["id"] = layer.id.value;
    json["name"] = layer.name;
    json["kind"] = kind_of(layer);
    add_unless(json, "visible", layer.visible, standard.visible);
    add_unless(json, "locked", layer.locked, standard.locked);
    add_unless(json, "clipped", layer.clipped, standard.clipped);
    add_unless(json, "opacity", layer.opacity, standard.opacity);
    if (layer.mode != standard.mode) json["mode"] = info(layer.mode).id;
    add_choice_unless(json, "blend-space", layer.blend_space, standard.blend_space);
    if (layer.height_blend != standard.height_blend)
        json["height-blend"] = height_blend_to_json(layer.height_blend);
    if (Json channels = channels_to_json(layer); !channels.empty())
        json["channels"] = std::move(channels);
    if (Json mask = mask_to_json(layer.mask, ids); !mask.empty()) json["mask"] = std::move(mask);
    if (const auto* group = std::get_if<GroupContent>(&layer.content)) {
        add_unless(json, "open", group->open, GroupContent{}.open);
        json["layers"] = list_to_json(group->children, ids, referred);
    }
    if (const auto* content = std::get_if<AdjustmentContent>(&layer.content))
        json["adjustment"] = adjustment_to_json(content->adjustment);
    return json;
}

Json list_to_json(const LayerList& layers, JsonIds ids, const std::set<LayerId>& referred) {
    Json json = Json::array();
    for (const LayerPtr& layer : layers) json.push_back(layer_to_json(*layer, ids, referred));
    return json;
}

}  // namespace

Json layers_to_json(const LayerList& layers, JsonIds ids) {
    std::set<LayerId> referred;
    for_each_source(layers, [&](const Source& source) {
        if (const auto* reference = std::get_if<ReferenceSource>(&source))
            referred.insert(reference->layer);
    });
    return list_to_json(layers, ids, referred);
}

}  // namespace patina
