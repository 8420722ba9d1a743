// SPDX-License-Identifier: MIT
#include "document/preset.h"

#include <algorithm>

#include "document/layer_json.h"
#include "document/references.h"

namespace patina {
namespace {

/// The version of the format, not of any preset.
constexpr int kPresetFormat = 1;
constexpr std::size_t kLongestText = 2000;
constexpr std::size_t kMaxPresetImages = 64;

bool is_plain_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
}

bool is_preset_id(std::string_view id) {
    return !id.empty() && id.size() <= 64 && id.front() != '-' && id.back() != '-' &&
           std::all_of(id.begin(), id.end(), is_plain_letter);
}

/// A name in the preset's own folder: files are untrusted and may name nothing beyond it.
bool is_plain_file_name(std::string_view name) {
    const auto allowed = [](char c) {
        return is_plain_letter(c) || (c >= 'A' && c <= 'Z') || c == '.' || c == '_';
    };
    return !name.empty() && name.size() <= 100 && name.front() != '.' &&
           std::all_of(name.begin(), name.end(), allowed);
}

void check_text(const std::string& text, std::string_view key, JsonObject& object) {
    if (text.empty() || text.size() > kLongestText)
        object.fault(key, fmt::format("is not a text of 1 to {} bytes", kLongestText));
    if (quoted_for_message(text, text.size()) != text) object.fault(key, "has control characters");
}

std::string read_text(std::string_view key, JsonObject& object) {
    std::string text = object.required_text(key);
    check_text(text, key, object);
    return text;
}

PresetImage read_preset_image(const Json& json, const std::string& pointer, JsonFaults& faults) {
    JsonObject object(json, pointer, faults);
    PresetImage image;
    image.file = object.required_text("file");
    if (!is_plain_file_name(image.file))
        object.fault("file", "is not a plain file name of letters, digits, '.', '_' and '-'");
    image.hash = object.required_hash("hash");
    object.finish();
    return image;
}

KnobTarget read_target(const Json& json, const std::string& pointer, JsonFaults& faults) {
    JsonObject object(json, pointer, faults);
    KnobTarget target;
    target.path = object.required_text("path");
    if (target.path.empty() || target.path.front() != '/' ||
        target.path.find('~') != std::string::npos)
        object.fault("path", "is no path into the layers, such as /0/opacity");
    object.require("from");
    object.require("to");
    target.from = object.number("from", Parameter::ImageAdd, 0.0f);
    target.to = object.number("to", Parameter::ImageAdd, 1.0f);
    object.finish();
    return target;
}

PresetKnob read_knob(const Json& json, const std::string& pointer, JsonFaults& faults) {
    JsonObject object(json, pointer, faults);
    PresetKnob knob;
    knob.id = object.required_text("id");
    if (!is_preset_id(knob.id))
        object.fault("id", "is not made of lower-case letters, digits and hyphens");
    knob.name = read_text("name", object);
    knob.value = object.number("value", Parameter::ScalarValue, knob.value);
    object.require("targets");
    knob.targets = object.list("targets", kMaxKnobTargets, read_target);
    if (knob.targets.empty()) object.fault("targets", "holds no target");
    object.finish();
    return knob;
}

/// Both ends of every knob have to make layers that can be laid on.
Status check_knobs(const Preset& preset) {
    for (const PresetKnob& knob : preset.knobs)
        for (const float end : {0.0f, 1.0f})
            if (const auto turned = turned_layers(preset, {{knob.id, end}}); !turned)
                return failure("knob {}: {}", knob.id, turned.error().message);
    return {};
}

/// The preset's own description; the layers are read beside it.
Preset read_description(JsonObject& object) {
    Preset preset;
    preset.id = object.required_text("id");
    if (!is_preset_id(preset.id))
        object.fault("id", "is not made of lower-case letters, digits and hyphens");
    preset.version = static_cast<int>(object.integer("version", 1, 1'000'000, 1));
    preset.name = read_text("name", object);
    preset.category = read_text("category", object);
    preset.tags = object.texts("tags");
    for (const std::string& tag : preset.tags) check_text(tag, "tags", object);
    preset.author = read_text("author", object);
    preset.licence = read_text("licence", object);
    preset.description = read_text("description", object);
    return preset;
}

Result<Preset> read_preset(std::string_view text) {
    const Result<Json> json = json_from_text(text);
    if (!json) return passed_on(json);
    JsonFaults faults;
    JsonObject object(*json, "", faults);
    object.find("$schema");
    object.require("patina-preset");
    const std::int64_t format = object.integer("patina-preset", 1, INT32_MAX, 1);
    if (!faults.any() && format > kPresetFormat)
        return failure("made for a newer Patina (format {}, this one reads up to {})", format,
                       kPresetFormat);
    Preset preset = read_description(object);
    preset.knobs = object.list("knobs", kMaxKnobs, read_knob);
    preset.images = object.list("images", kMaxPresetImages, read_preset_image);
    if (const Json* layers = object.require("layers"))
        preset.layers = layers_from_json(*layers, "/layers", faults);
    object.finish();
    if (!faults.any() && preset.layers.empty()) object.fault("layers", "has no layer");
    if (faults.any()) return passed_on(faults.status());
    IssuedIds issued{.taken = {}, .next = largest_id(preset.layers) + 1};
    preset.layers = with_unique_ids(preset.layers, issued);
    if (const Status references = check_references(preset.layers); !references)
        return passed_on(references);
    if (const Status knobs = check_knobs(preset); !knobs) return passed_on(knobs);
    return preset;
}

Json knob_to_json(const PresetKnob& knob) {
    Json json = {{"id", knob.id}, {"name", knob.name}};
    if (knob.value != PresetKnob{}.value) json["value"] = json_of(knob.value);
    for (const KnobTarget& target : knob.targets)
        json["targets"].push_back(
            {{"path", target.path}, {"from", json_of(target.from)}, {"to", json_of(target.to)}});
    return json;
}

}  // namespace

Result<Preset> preset_from_json(std::string_view text, std::string_view origin) {
    Result<Preset> preset = read_preset(text);
    if (!preset) return failure("{}: {}", quoted_for_message(origin), preset.error().message);
    return preset;
}

std::string preset_to_json(const Preset& preset) {
    Json json = {{"$schema", "schema.json"},  {"patina-preset", kPresetFormat},
                 {"id", preset.id},           {"version", preset.version},
                 {"name", preset.name},       {"category", preset.category},
                 {"tags", preset.tags},       {"author", preset.author},
                 {"licence", preset.licence}, {"description", preset.description}};
    for (const PresetKnob& knob : preset.knobs) json["knobs"].push_back(knob_to_json(knob));
    for (const PresetImage& image : preset.images)
        json["images"].push_back({{"file", image.file}, {"hash", to_hex(image.hash)}});
    json["layers"] = layers_to_json(preset.layers, JsonIds::LeftOut);
    return indented_text(json);
}

}  // namespace patina
