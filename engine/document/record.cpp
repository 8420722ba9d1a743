// SPDX-License-Identifier: MIT
#include "document/record.h"

#include <algorithm>
#include <bit>

#include "document/check.h"
#include "document/layer_json.h"
#include "document/parts.h"
#include "document/references.h"
#include "document/scene_edits.h"

namespace patina {
namespace {

constexpr std::size_t kMaxImages = 4096;
constexpr std::int64_t kLargestSide = 16384;

Json image_to_json(const RecordImage& image) {
    Json json = {{"hash", to_hex(image.hash)}, {"name", image.name}};
    if (!image.mime_type.empty()) json["mime-type"] = image.mime_type;
    json["width"] = image.width;
    json["height"] = image.height;
    json["channels"] = image.channels;
    json["type"] = choice(image.type).id;
    if (!image.file.empty()) json["file"] = image.file;
    return json;
}

Json environment_to_json(const EnvironmentSettings& environment) {
    return {{"name", environment.name},
            {"rotation", json_of(environment.rotation_degrees)},
            {"intensity", json_of(environment.intensity)},
            {"sun-elevation", json_of(environment.sun_elevation_degrees)}};
}

Json light_to_json(const Light& light) {
    Json json = {{"kind", choice(light.kind).id},
                 {"name", light.name},
                 {"color", json_of(light.color_linear)},
                 {"intensity", json_of(light.intensity)},
                 {"position", json_of(light.position_world)},
                 {"direction", json_of(light.direction_world)},
                 {"range", json_of(light.range)}};
    // What the kind goes by, and what another kind that it was goes by.
    const auto add = [&](std::string_view key, float Light::*member, Light::Kind of) {
        if (light.kind == of || light.*member != Light{}.*member)
            json[std::string(key)] = json_of(light.*member);
    };
    add("inner-cone", &Light::inner_cone_radians, Light::Kind::Spot);
    add("outer-cone", &Light::outer_cone_radians, Light::Kind::Spot);
    add("radius", &Light::radius_m, Light::Kind::Sphere);
    add("width", &Light::width_m, Light::Kind::Rectangle);
    add("height", &Light::height_m, Light::Kind::Rectangle);
    add("turn", &Light::turn_radians, Light::Kind::Rectangle);
    return json;
}

Json lights_to_json(const std::vector<Light>& lights) {
    Json json = Json::array();
    for (const Light& light : lights) json.push_back(light_to_json(light));
    return json;
}

/// What each part of the model is drawn with, whether the file says so or an edit.
Json parts_to_json(const Document& document) {
    Json json = Json::array();
    for (const Part& part : parts_of(document))
        json.push_back(
            {part.ref.mesh, part.ref.primitive, part.material ? part.material->id.value : 0});
    return json;
}

Json material_to_json(const Material& material) {
    return {{"id", material.id.value},
            {"name", material.name},
            {"resolution", material.resolution},
            {"uv-set", material.uv_set},
            {"height-scale", json_of(material.height_scale)},
            {"padding", choice(material.padding).id},
            {"alpha-mode", choice(material.alpha_mode).id},
            {"alpha-cutoff", json_of(material.alpha_cutoff)},
            {"double-sided", material.double_sided},
            {"unlit", material.unlit},
            {"ior", json_of(material.ior)},
            {"specular", json_of(material.specular_factor)},
            {"specular-color", json_of(material.specular_color_linear)},
            {"emissive-strength", json_of(material.emissive_strength)},
            {"stack", layers_to_json(material.stack, JsonIds::Kept)}};
}

RecordImage read_record_image(const Json& json, const std::string& pointer, JsonFaults& faults) {
    JsonObject object(json, pointer, faults);
    RecordImage image;
    image.hash = object.required_hash("hash");
    image.name = object.text("name");
    image.mime_type = object.text("mime-type");
    image.width = static_cast<int>(object.integer("width", 0, kLargestSide, 0));
    image.height = static_cast<int>(object.integer("height", 0, kLargestSide, 0));
    image.channels = static_cast<int>(object.integer("channels", 0, 4, 0));
    image.type = object.choice("type", image.type);
    image.file = object.text("file");
    object.finish();
    return image;
}

std::map<std::string, Hash128> read_baked(JsonObject& parent) {
    std::map<std::string, Hash128> baked;
    const Json* json = parent.find("baked");
    if (!json) return baked;
    JsonObject object(*json, parent.pointer_to("baked"), parent.faults());
    if (json->is_object())
        for (const auto& [key, unused] : json->items()) baked[key] = object.required_hash(key);
    return baked;
}

std::vector<Hash128> read_owned_images(JsonObject& object) {
    std::vector<Hash128> hashes;
    for (const std::string& text : object.texts("owned-images")) {
        const std::optional<Hash128> hash = hash_from_hex(text);
        if (!hash) object.fault("owned-images", "holds text that is no hash");
        hashes.push_back(hash.value_or(Hash128{}));
    }
    return hashes;
}

int read_resolution(JsonObject& object) {
    const std::int64_t side =
        object.integer("resolution", kMinResolution, kMaxResolution, MaterialRecord{}.resolution);
    if (!std::has_single_bit(static_cast<std::uint64_t>(side)))
        object.fault("resolution", "is not a power of two");
    return static_cast<int>(side);
}

EnvironmentSettings read_environment(JsonObject& parent) {
    EnvironmentSettings environment;
    const Json* json = parent.find("environment");
    if (!json) return environment;
    JsonObject object(*json, parent.pointer_to("environment"), parent.faults());
    environment.name = object.text("name", environment.name);
    environment.rotation_degrees =
        object.number("rotation", Parameter::EnvironmentRotation, environment.rotation_degrees);
    environment.intensity =
        object.number("intensity", Parameter::EnvironmentIntensity, environment.intensity);
    environment.sun_elevation_degrees = object.number(
        "sun-elevation", Parameter::EnvironmentSunElevation, environment.sun_elevation_degrees);
    object.finish();
    return environment;
}

Light read_light(const Json& json, const std::string& pointer, JsonFaults& faults) {
    JsonObject object(json, pointer, faults);
    Light light;
    light.kind = object.choice("kind", light.kind);
    light.name = object.text("name");
    light.color_linear = object.vector3("color", Parameter::LightColor, light.color_linear);
    light.intensity = object.number("intensity", Parameter::LightIntensity, light.intensity);
    light.position_world =
        object.vector3("position", Parameter::LightPosition, light.position_world);
    light.direction_world =
        object.vector3("direction", Parameter::LightDirection, light.direction_world);
    light.range = object.number("range", Parameter::LightRange, light.range);
    light.inner_cone_radians =
        object.number("inner-cone", Parameter::LightInnerCone, light.inner_cone_radians);
    light.outer_cone_radians =
        object.number("outer-cone", Parameter::LightOuterCone, light.outer_cone_radians);
    light.radius_m = object.number("radius", Parameter::LightRadius, light.radius_m);
    light.width_m = object.number("width", Parameter::LightWidth, light.width_m);
    light.height_m = object.number("height", Parameter::LightHeight, light.height_m);
    light.turn_radians = object.number("turn", Parameter::LightTurn, light.turn_radians);
    object.finish();
    if (Status status = check_light(light); !status)
        faults.add(pointer, "is not valid: " + status.error().message);
    return light;
}

std::optional<std::vector<Light>> read_lights(JsonObject& parent) {
    if (!parent.has("lights")) return std::nullopt;
    return parent.list("lights", kMaxLights, read_light);
}

}  // namespace

Result<Light> light_from_json(std::string_view text) {
    const Result<Json> json = json_from_text(text);
    if (!json) return passed_on(json);
    JsonFaults faults;
    Light light = read_light(*json, "", faults);
    if (faults.any()) return passed_on(faults.status());
    return light;
}

namespace {

/// The parsed text of a record whose version can be read.
Result<Json> known_record(std::string_view text) {
    Result<Json> json = json_from_text(text);
    if (!json) return json;
    JsonFaults faults;
    JsonObject object(*json, "", faults);
    object.require("version");
    const std::int64_t version = object.integer("version", 1, INT32_MAX, 1);
    if (faults.any()) return passed_on(faults.status());
    if (version > kRecordVersion)
        return failure("written by a newer Patina (version {}, this one reads up to {})", version,
                       kRecordVersion);
    return json;
}

}  // namespace

RecordImage record_image(const ImageAsset& asset) {
    return {.hash = asset.hash,
            .name = asset.name,
            .mime_type = asset.mime_type,
            .width = asset.width,
            .height = asset.height,
            .channels = asset.channels,
            .type = asset.type,
            .file = {}};
}

MaterialRecord material_record(const Document& document, const Material& material) {
    MaterialRecord record{.id = material.id,
                          .resolution = material.resolution,
                          .uv_set = material.uv_set,
                          .height_scale = material.height_scale,
                          .padding = material.padding,
                          .stack = material.stack,
                          .images = {},
                          .baked = {},
                          .owned_images = {},
                          .stands_for = {}};
    for (const Hash128& hash : images_of(material.stack))
        if (const auto found = document.images.find(hash); found != document.images.end())
            record.images.push_back(record_image(*found->second));
    return record;
}

std::string to_json(const MaterialRecord& record) {
    const MaterialRecord standard;
    if (record.stands_for != standard.stands_for)
        return compact_text({{"version", kRecordVersion}, {"stands-for", record.stands_for.value}});
    Json json = {
        {"version", kRecordVersion}, {"id", record.id.value}, {"resolution", record.resolution}};
    if (record.uv_set != standard.uv_set) json["uv-set"] = record.uv_set;
    if (record.height_scale != standard.height_scale)
        json["height-scale"] = json_of(record.height_scale);
    if (record.padding != standard.padding) json["padding"] = choice(record.padding).id;
    json["stack"] = layers_to_json(record.stack, JsonIds::Kept);
    for (const RecordImage& image : record.images) json["images"].push_back(image_to_json(image));
    for (const auto& [map, hash] : record.baked) json["baked"][map] = to_hex(hash);
    for (const Hash128& hash : record.owned_images) json["owned-images"].push_back(to_hex(hash));
    return compact_text(json);
}

std::string to_json(const SceneRecord& record) {
    Json json = {{"version", kRecordVersion},
                 {"environment", environment_to_json(record.environment)}};
    if (record.lights) json["lights"] = lights_to_json(*record.lights);
    return compact_text(json);
}

Result<int> record_version(std::string_view text) {
    const Result<Json> json = json_from_text(text);
    if (!json) return passed_on(json);
    JsonFaults faults;
    JsonObject object(*json, "", faults);
    object.require("version");
    const std::int64_t version = object.integer("version", 1, INT32_MAX, 1);
    if (faults.any()) return passed_on(faults.status());
    return static_cast<int>(version);
}

Result<MaterialRecord> material_record_from_json(std::string_view text) {
    const Result<Json> json = known_record(text);
    if (!json) return passed_on(json);
    JsonFaults faults;
    JsonObject object(*json, "", faults);
    object.find("version");
    MaterialRecord record;
    record.id.value = static_cast<std::uint64_t>(object.integer("id", 1, kLargestId, 0));
    record.resolution = read_resolution(object);
    record.uv_set = static_cast<int>(object.integer("uv-set", 0, 1, record.uv_set));
    record.height_scale =
        object.number("height-scale", Parameter::MaterialHeightScale, record.height_scale);
    record.padding = object.choice("padding", record.padding);
    record.stands_for.value =
        static_cast<std::uint64_t>(object.integer("stands-for", 1, kLargestId, 0));
    const bool has_stack = record.stands_for == MaterialId{};
    if (const Json* stack = has_stack ? object.require("stack") : nullptr)
        record.stack = layers_from_json(*stack, "/stack", faults);
    record.images = object.list("images", kMaxImages, read_record_image);
    record.baked = read_baked(object);
    record.owned_images = read_owned_images(object);
    object.finish();
    if (faults.any()) return passed_on(faults.status());
    IssuedIds issued{.taken = {}, .next = largest_id(record.stack) + 1};
    record.stack = with_unique_ids(record.stack, issued);
    if (const Status status = check_references(record.stack); !status)
        return failure("/stack: {}", status.error().message);
    return record;
}

Result<SceneRecord> scene_record_from_json(std::string_view text) {
    const Result<Json> json = known_record(text);
    if (!json) return passed_on(json);
    JsonFaults faults;
    JsonObject object(*json, "", faults);
    object.find("version");
    SceneRecord record;
    record.environment = read_environment(object);
    record.lights = read_lights(object);
    object.finish();
    if (faults.any()) return passed_on(faults.status());
    return record;
}

std::vector<Hash128> images_of(const std::vector<LayerPtr>& layers) {
    std::vector<Hash128> hashes;
    for_each_source(layers, [&](const Source& source) {
        if (const auto* image = std::get_if<ImageSource>(&source)) hashes.push_back(image->image);
    });
    std::sort(hashes.begin(), hashes.end());
    hashes.erase(std::unique(hashes.begin(), hashes.end()), hashes.end());
    return hashes;
}

Document with_unique_ids(const Document& document) {
    IssuedIds issued;
    issued.next = document.next_id;
    for (const MaterialPtr& material : document.materials)
        issued.next =
            std::max({issued.next, material->id.value + 1, largest_id(material->stack) + 1});
    Document result = document;
    for (MaterialPtr& material : result.materials) {
        Material copy = *material;
        if (copy.id.value == 0 || !issued.taken.insert(copy.id.value).second) {
            copy.id.value = issued.next++;
            issued.taken.insert(copy.id.value);
        }
        copy.stack = with_unique_ids(copy.stack, issued);
        if (copy != *material) material = std::make_shared<const Material>(std::move(copy));
    }
    result.next_id = issued.next;
    return result;
}

std::string serialise(const Document& document) {
    Json json = {{"materials", Json::array()}, {"images", Json::array()}};
    for (const MaterialPtr& material : document.materials)
        json["materials"].push_back(material_to_json(*material));
    for (const auto& [hash, image] : document.images)
        json["images"].push_back(image_to_json(record_image(*image)));
    json["environment"] = environment_to_json(document.environment);
    json["lights"] = lights_to_json(document.lights);
    json["parts"] = parts_to_json(document);
    return indented_text(json);
}

}  // namespace patina
