// SPDX-License-Identifier: MIT
// The half of layer_json.h that reads, and the ids of what was read.
#include <algorithm>

#include "document/check.h"
#include "document/layer_json.h"
#include "document/mask_edits.h"
#include "document/references.h"

namespace patina {
namespace {

/// Ids are whole numbers that every JSON reader keeps exactly.

void note(const Status& status, const std::string& pointer, JsonFaults& faults) {
    if (!status) faults.add(pointer, "is not valid: " + status.error().message);
}

std::optional<BlendMode> read_mode(JsonObject& object) {
    const Json* value = object.find("mode");
    if (!value) return std::nullopt;
    const auto mode = value->is_string() ? blend_mode_from_id(value->get_ref<const std::string&>())
                                         : std::nullopt;
    if (!mode) object.fault("mode", "is not a blend mode");
    return mode;
}

glm::vec3 read_value(SourceUse use, const Json& json, const std::string& pointer,
                     JsonFaults& faults) {
    const Parameter parameter = value_parameter(use);
    if (feeds_number(use)) return {json_number(json, parameter, pointer, faults), 0.0f, 0.0f};
    if (json.is_number() && feeds_color(use))
        return glm::vec3(json_number(json, parameter, pointer, faults));
    if (!json.is_array() || json.size() != 3) {
        faults.add(pointer, feeds_color(use) ? "is neither a number nor 3 of them"
                                             : "is not an array of 3 numbers");
        return glm::vec3(0.0f);
    }
    glm::vec3 value;
    for (int i = 0; i < 3; ++i)
        value[i] = json_number(json[static_cast<std::size_t>(i)], parameter, pointer, faults);
    note(check_value(use, value), pointer, faults);
    return value;
}

UvTransform read_transform(JsonObject& parent) {
    UvTransform transform;
    const Json* json = parent.find("transform");
    if (!json) return transform;
    JsonObject object(*json, parent.pointer_to("transform"), parent.faults());
    transform.offset = object.vector2("offset", Parameter::UvOffset, transform.offset);
    transform.scale = object.vector2("scale", Parameter::UvScale, transform.scale);
    transform.rotation_degrees =
        object.number("rotation", Parameter::UvRotation, transform.rotation_degrees);
    object.finish();
    note(check_transform(transform), object.pointer(), object.faults());
    return transform;
}

Projection read_projection(JsonObject& parent) {
    Projection projection;
    const Json* json = parent.find("projection");
    if (!json) return projection;
    JsonObject object(*json, parent.pointer_to("projection"), parent.faults());
    object.require("kind");
    projection.kind = object.choice("kind", projection.kind);
    projection.axis = object.choice("axis", projection.axis);
    projection.blend = object.number("blend", Parameter::ProjectionBlend, projection.blend);
    object.finish();
    return projection;
}

ImageSource read_image(JsonObject& object) {
    ImageSource source;
    source.image = object.required_hash("image");
    source.color_space = object.choice("color-space", source.color_space);
    source.pick = object.choice("pick", source.pick);
    source.invert = object.boolean("invert", source.invert);
    source.directx_normal = object.boolean("directx-normal", source.directx_normal);
    source.alpha_is_coverage = object.boolean("alpha-is-coverage", source.alpha_is_coverage);
    source.uv_set = static_cast<int>(object.integer("uv-set", 0, 1, source.uv_set));
    source.projection = read_projection(object);
    source.transform = read_transform(object);
    source.wrap_u = object.choice("wrap-u", source.wrap_u);
    source.wrap_v = object.choice("wrap-v", source.wrap_v);
    source.filter = object.choice("filter", source.filter);
    source.multiply = object.vector3("multiply", Parameter::ImageMultiply, source.multiply);
    source.add = object.vector3("add", Parameter::ImageAdd, source.add);
    return source;
}

std::vector<RampStop> read_ramp(SourceUse use, JsonObject& parent, std::string_view key,
                                const std::vector<RampStop>& standard) {
    const Json* json = parent.find(key);
    if (!json) return standard;
    std::vector<RampStop> stops;
    const std::string pointer = parent.pointer_to(key);
    if (!json->is_array() || json->empty() || json->size() > std::size_t{kMaxRampStops}) {
        parent.fault(key, fmt::format("is not a list of 1 to {} stops", kMaxRampStops));
        return stops;
    }
    for (std::size_t i = 0; i < json->size(); ++i) {
        JsonObject object((*json)[i], fmt::format("{}/{}", pointer, i), parent.faults());
        RampStop stop;
        object.require("position");
        stop.position = object.number("position", Parameter::RampPosition, 0.0f);
        if (const Json* value = object.require("value"))
            stop.value = read_value(use, *value, object.pointer_to("value"), object.faults());
        object.finish();
        stops.push_back(stop);
    }
    note(check_ramp(use, stops), pointer, parent.faults());
    return stops;
}

ProceduralSource read_procedural(SourceUse use, ProceduralKind kind, JsonObject& object) {
    ProceduralSource source;
    source.kind = kind;
    source.seed = static_cast<std::uint32_t>(object.integer("seed", 0, UINT32_MAX, source.seed));
    source.scale = object.number("scale", Parameter::ProceduralScale, source.scale);
    const ParameterInfo& octaves = info(Parameter::ProceduralOctaves);
    source.octaves = static_cast<int>(
        object.integer("octaves", static_cast<std::int64_t>(octaves.minimum),
                       static_cast<std::int64_t>(octaves.maximum), source.octaves));
    source.contrast = object.number("contrast", Parameter::ProceduralContrast, source.contrast);
    source.balance = object.number("balance", Parameter::ProceduralBalance, source.balance);
    source.width = object.number("width", Parameter::ProceduralWidth, source.width);
    source.softness = object.number("softness", Parameter::ProceduralSoftness, source.softness);
    source.variation = object.number("variation", Parameter::ProceduralVariation, source.variation);
    source.aspect = object.number("aspect", Parameter::ProceduralAspect, source.aspect);
    source.warp = object.number("warp", Parameter::ProceduralWarp, source.warp);
    source.projection = read_projection(object);
    source.transform = read_transform(object);
    source.ramp = read_ramp(use, object, "ramp", source.ramp);
    return source;
}

ReliefSource read_relief(SourceUse use, ReliefKind kind, JsonObject& object) {
    ReliefSource source;
    source.kind = kind;
    source.radius_permille =
        object.number("radius", Parameter::ReliefRadius, source.radius_permille);
    source.strength = object.number("strength", Parameter::ReliefStrength, source.strength);
    note(check_source(use, source), object.pointer(), object.faults());
    return source;
}

ReferenceSource read_reference(SourceUse use, JsonObject& object) {
    ReferenceSource source;
    object.require("layer");
    source.layer.value = static_cast<std::uint64_t>(object.integer("layer", 1, kLargestId, 1));
    source.result = object.choice("result", source.result);
    note(check_source(use, source), object.pointer(), object.faults());
    return source;
}

GeometrySource read_geometry(SourceUse use, JsonObject& object) {
    GeometrySource source;
    source.meshes = object.texts("meshes");
    source.materials = object.texts("materials");
    note(check_source(use, source), object.pointer(), object.faults());
    return source;
}

Source read_source(SourceUse use, const Json& json, const std::string& pointer,
                   JsonFaults& faults) {
    if (!json.is_object()) return ConstantSource{read_value(use, json, pointer, faults)};
    JsonObject object(json, pointer, faults);
    const std::string kind = object.required_text("kind");
    Source source;
    if (kind == "image")
        source = read_image(object);
    else if (const auto noise = choice_from_id<ProceduralKind>(kind))
        source = read_procedural(use, *noise, object);
    else if (const auto relief = choice_from_id<ReliefKind>(kind))
        source = read_relief(use, *relief, object);
    else if (kind == "layer")
        source = read_reference(use, object);
    else if (kind == "geometry")
        source = read_geometry(use, object);
    else
        object.fault("kind", "is no kind of source");
    object.finish();
    return source;
}

std::string read_name(JsonObject& object) {
    std::string name = object.required_text("name");
    note(check_name(name), object.pointer_to("name"), object.faults());
    return name;
}

Levels read_levels(JsonObject& parent) {
    Levels levels;
    const Json* json = parent.find("levels");
    if (!json) return levels;
    JsonObject object(*json, parent.pointer_to("levels"), parent.faults());
    levels.in_low = object.number("in-low", Parameter::LevelsInLow, levels.in_low);
    levels.in_high = object.number("in-high", Parameter::LevelsInHigh, levels.in_high);
    levels.gamma = object.number("gamma", Parameter::LevelsGamma, levels.gamma);
    levels.out_low = object.number("out-low", Parameter::LevelsOutLow, levels.out_low);
    levels.out_high = object.number("out-high", Parameter::LevelsOutHigh, levels.out_high);
    object.finish();
    note(check_levels(levels), object.pointer(), object.faults());
    return levels;
}

HeightBlend read_height_blend(JsonObject& parent) {
    HeightBlend blend;
    const Json* json = parent.find("height-blend");
    if (!json) return blend;
    JsonObject object(*json, parent.pointer_to("height-blend"), parent.faults());
    blend.enabled = object.boolean("enabled", true);
    blend.offset = object.number("offset", Parameter::HeightBlendOffset, blend.offset);
    blend.radius = object.number("radius", Parameter::HeightBlendRadius, blend.radius);
    blend.contrast = object.number("contrast", Parameter::HeightBlendContrast, blend.contrast);
    object.finish();
    return blend;
}

std::vector<CurvePoint> read_curve(JsonObject& parent) {
    const Json* json = parent.find("curve");
    if (!json) return AdjustmentSettings{}.curve;
    std::vector<CurvePoint> points;
    const std::string pointer = parent.pointer_to("curve");
    if (!json->is_array() || json->size() < 2 || json->size() > std::size_t{kMaxCurvePoints}) {
        parent.fault("curve", fmt::format("is not a list of 2 to {} points", kMaxCurvePoints));
        return points;
    }
    for (std::size_t i = 0; i < json->size(); ++i) {
        JsonObject object((*json)[i], fmt::format("{}/{}", pointer, i), parent.faults());
        object.require("x");
        object.require("y");
        const float x = object.number("x", Parameter::CurveX, 0.0f);
        points.push_back({x, object.number("y", Parameter::CurveY, 0.0f)});
        object.finish();
    }
    return points;
}

AdjustmentSettings read_adjustment(JsonObject& parent) {
    AdjustmentSettings read;
    const Json* json = parent.require("adjustment");
    if (!json) return read;
    JsonObject object(*json, parent.pointer_to("adjustment"), parent.faults());
    object.require("kind");
    read.kind = object.choice("kind", read.kind);
    read.levels = read_levels(object);
    read.curve = read_curve(object);
    read.hue_degrees = object.number("hue", Parameter::AdjustmentHue, read.hue_degrees);
    read.saturation = object.number("saturation", Parameter::AdjustmentSaturation, read.saturation);
    read.lightness = object.number("lightness", Parameter::AdjustmentLightness, read.lightness);
    read.brightness = object.number("brightness", Parameter::AdjustmentBrightness, read.brightness);
    read.contrast = object.number("contrast", Parameter::AdjustmentContrast, read.contrast);
    read.steps = static_cast<int>(object.integer("steps", 2, 64, read.steps));
    read.gradient = read_ramp(Channel::BaseColor, object, "gradient", read.gradient);
    read.low = object.number("low", Parameter::AdjustmentLow, read.low);
    read.high = object.number("high", Parameter::AdjustmentHigh, read.high);
    read.radius_permille =
        object.number("radius", Parameter::AdjustmentRadius, read.radius_permille);
    read.amount = object.number("amount", Parameter::AdjustmentAmount, read.amount);
    read.distance_permille =
        object.number("distance", Parameter::AdjustmentDistance, read.distance_permille);
    read.scale = object.number("scale", Parameter::AdjustmentScale, read.scale);
    read.octaves = static_cast<int>(object.integer("octaves", 1, 10, read.octaves));
    read.seed = static_cast<std::uint32_t>(object.integer("seed", 0, UINT32_MAX, read.seed));
    object.finish();
    note(check_adjustment(read), object.pointer(), object.faults());
    return read;
}

/// An adjustment takes the place of what is there, unless it says otherwise.
BlendMode read_combine(JsonObject& object, bool adjusts) {
    const Json* value = object.find("combine");
    if (!value) return adjusts ? BlendMode::Replace : MaskEntry{}.combine;
    const auto mode = value->is_string() ? blend_mode_from_id(value->get_ref<const std::string&>())
                                         : std::nullopt;
    if (mode && combines_masks(*mode)) return *mode;
    object.fault("combine", mode ? "does not apply to masks" : "is not a blend mode");
    return MaskEntry{}.combine;
}

/// What the entry is: a source, or an adjustment of what lies before it.
void read_entry_content(JsonObject& object, MaskEntry& entry) {
    if (!object.find("adjustment")) {
        if (const Json* source = object.require("source"))
            entry.source =
                read_source(std::nullopt, *source, object.pointer_to("source"), object.faults());
        return;
    }
    entry.adjustment = read_adjustment(object);
    if (object.find("source")) object.fault("source", "stands beside an adjustment");
    note(check_mask_adjustment(entry), object.pointer_to("adjustment"), object.faults());
}

MaskEntry read_entry(const Json& json, const std::string& pointer, JsonFaults& faults) {
    JsonObject object(json, pointer, faults);
    MaskEntry entry;
    entry.id.value = static_cast<std::uint64_t>(object.integer("id", 1, kLargestId, 0));
    entry.visible = object.boolean("visible", entry.visible);
    entry.opacity = object.number("opacity", Parameter::MaskEntryOpacity, entry.opacity);
    entry.invert = object.boolean("invert", entry.invert);
    entry.levels = read_levels(object);
    read_entry_content(object, entry);
    entry.name = object.has("name") ? read_name(object) : kind_name(entry);
    entry.combine = read_combine(object, entry.adjustment.has_value());
    object.finish();
    return entry;
}

Mask read_mask(JsonObject& parent) {
    Mask mask;
    const Json* json = parent.find("mask");
    if (!json) return mask;
    JsonObject object(*json, parent.pointer_to("mask"), parent.faults());
    mask.enabled = object.boolean("enabled", mask.enabled);
    mask.invert = object.boolean("invert", mask.invert);
    mask.base = object.number("base", Parameter::MaskBase, mask.base);
    mask.entries = object.list("entries", kMaxMaskEntries, read_entry);
    object.finish();
    return mask;
}

void read_channel(const ChannelInfo& row, const Json& json, const std::string& pointer,
                  ChannelSettings& settings, JsonFaults& faults) {
    JsonObject object(json, pointer, faults);
    settings.enabled = object.boolean("enabled", true);
    if (const Json* source = object.find("source"))
        settings.source = read_source(row.channel, *source, object.pointer_to("source"), faults);
    settings.mode = read_mode(object);
    if (settings.mode && !applies_to(*settings.mode, row.channel))
        object.fault("mode", fmt::format("does not apply to the {} channel", row.id));
    settings.opacity = object.number("opacity", Parameter::ChannelOpacity, settings.opacity);
    object.finish();
}

PerChannel<ChannelSettings> read_channels(JsonObject& parent, bool of_group) {
    PerChannel<ChannelSettings> channels = default_channels();
    for (ChannelSettings& settings : channels) settings.enabled = of_group;
    const Json* json = parent.find("channels");
    if (!json) return channels;
    JsonObject object(*json, parent.pointer_to("channels"), parent.faults());
    for (const ChannelInfo& row : kChannels)
        if (const Json* part = object.find(row.id))
            read_channel(row, *part, object.pointer_to(row.id), at(channels, row.channel),
                         object.faults());
    object.finish();
    return channels;
}

/// Reads layers and keeps count of them over all groups.
class LayerReader {
  public:
    explicit LayerReader(JsonFaults& faults) : faults_(faults) {}

    LayerList read_list(const Json& json, const std::string& pointer, int depth) {
        LayerList layers;
        if (!json.is_array()) {
            faults_.add(pointer, "is not a list of layers");
            return layers;
        }
        if (depth > kMaxLayerDepth && !json.empty()) {
            faults_.add(pointer, fmt::format("nests groups deeper than {}", kMaxLayerDepth));
            return layers;
        }
        for (std::size_t i = 0; i < json.size() && !faults_.any(); ++i) {
            if (++count_ > kMaxLayers) {
                faults_.add(pointer, fmt::format("makes more than {} layers", kMaxLayers));
                break;
            }
            layers.push_back(std::make_shared<const Layer>(
                read_layer(json[i], fmt::format("{}/{}", pointer, i), depth)));
        }
        return layers;
    }

  private:
    Layer read_layer(const Json& json, const std::string& pointer, int depth) {
        JsonObject object(json, pointer, faults_);
        Layer layer;
        layer.id.value = static_cast<std::uint64_t>(object.integer("id", 1, kLargestId, 0));
        layer.name = read_name(object);
        const std::string kind = object.text("kind", "fill");
        if (kind != "fill" && kind != "group" && kind != "adjustment")
            object.fault("kind", "is neither fill, group nor adjustment");
        layer.visible = object.boolean("visible", layer.visible);
        layer.locked = object.boolean("locked", layer.locked);
        layer.clipped = object.boolean("clipped", layer.clipped);
        layer.opacity = object.number("opacity", Parameter::LayerOpacity, layer.opacity);
        layer.mode = read_mode(object).value_or(layer.mode);
        if (!blends_layer(layer.mode, kind == "group"))
            object.fault("mode", "does not apply to colours");
        layer.blend_space = object.choice("blend-space", layer.blend_space);
        layer.height_blend = read_height_blend(object);
        layer.channels = read_channels(object, kind == "group");
        layer.mask = read_mask(object);
        if (kind == "group") layer.content = read_group(object, depth);
        if (kind == "adjustment") {
            const AdjustmentSettings adjustment = read_adjustment(object);
            if (at(layer.channels, Channel::Normal).enabled &&
                !adjusts(adjustment.kind, Channel::Normal))
                object.fault("channels", "adjusts normals, which cannot be adjusted so");
            layer.content = AdjustmentContent{adjustment};
        }
        object.finish();
        return layer;
    }

    GroupContent read_group(JsonObject& object, int depth) {
        GroupContent group;
        group.open = object.boolean("open", group.open);
        if (const Json* children = object.require("layers"))
            group.children = read_list(*children, object.pointer_to("layers"), depth + 1);
        return group;
    }

    JsonFaults& faults_;
    int count_ = 0;
};

std::uint64_t issue_if_needed(std::uint64_t id, IssuedIds& issued) {
    if (id != 0 && issued.taken.insert(id).second) return id;
    while (!issued.taken.insert(issued.next).second) ++issued.next;
    return issued.next++;
}

/// `given`: the new ids of layers that had one, but one that was taken.
LayerList with_issued_ids(const LayerList& layers, IssuedIds& issued, LayerIdMap& given) {
    LayerList result;
    for (const LayerPtr& layer : layers) {
        Layer copy = *layer;
        copy.id.value = issue_if_needed(copy.id.value, issued);
        if (copy.id != layer->id && layer->id != LayerId{}) given.emplace(layer->id, copy.id);
        for (MaskEntry& entry : copy.mask.entries)
            entry.id.value = issue_if_needed(entry.id.value, issued);
        if (auto* group = std::get_if<GroupContent>(&copy.content))
            group->children = with_issued_ids(group->children, issued, given);
        result.push_back(copy == *layer ? layer : std::make_shared<const Layer>(std::move(copy)));
    }
    return result;
}

}  // namespace

LayerList layers_from_json(const Json& array, const std::string& pointer, JsonFaults& faults) {
    LayerList layers = LayerReader(faults).read_list(array, pointer, 1);
    if (faults.any()) return {};
    return layers;
}

std::uint64_t largest_id(const LayerList& layers) {
    std::uint64_t largest = 0;
    for (const LayerPtr& layer : layers) {
        largest = std::max(largest, layer->id.value);
        for (const MaskEntry& entry : layer->mask.entries)
            largest = std::max(largest, entry.id.value);
        if (const auto* group = std::get_if<GroupContent>(&layer->content))
            largest = std::max(largest, largest_id(group->children));
    }
    return largest;
}

LayerList with_unique_ids(const LayerList& layers, IssuedIds& issued) {
    LayerIdMap given;
    LayerList result = with_issued_ids(layers, issued, given);
    return given.empty() ? result : with_references_moved(result, given);
}

}  // namespace patina
