// SPDX-License-Identifier: MIT
#include "document/setting.h"

#include <algorithm>
#include <charconv>

#include "core/hex_color.h"
#include "core/stored_values.h"
#include "document/change.h"
#include "document/edits.h"
#include "document/layer_json.h"

namespace patina {
namespace {

using Path = std::span<const std::string>;

bool among(std::initializer_list<std::string_view> keys, std::string_view key) {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
}

/// "#8a3b12" as linear light.
std::optional<Json> color_from_hex(std::string_view text) {
    const auto rgb = rgb_from_html(text);
    if (!rgb) return std::nullopt;
    Json color = Json::array();
    for (const std::uint8_t byte : *rgb) color.push_back(json_of(linear_of_bytes()[byte]));
    return color;
}

/// JSON where the text is some, else the text itself.
Json value_of(const std::string& text) {
    if (auto color = color_from_hex(text)) return *color;
    if (text == "on" || text == "off") return text == "on";
    Json json = Json::parse(text, nullptr, false);
    return json.is_discarded() ? Json(text) : json;
}

/// The element of a list with that name or number.
Json* element_of(Json& list, const std::string& name) {
    for (Json& element : list)
        if (element.is_object() && element.contains("name") && element["name"] == name)
            return &element;
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), index);
    const bool is_number = error == std::errc() && end == name.data() + name.size();
    return is_number && index < list.size() ? &list[index] : nullptr;
}

/// Walks down the JSON of a layer, by the keys that are there and the short cuts.
class LayerPlaceFinder {
  public:
    explicit LayerPlaceFinder(Json& layer) : layer_(layer) {}

    Result<Json*> find(Path path) {
        // "opacity" alone is the layer's; more below it is of the channel of that name.
        if (channel_from_id(path[0]) && (path[0] != "opacity" || path.size() > 1)) {
            Json* const channel = &member(member(layer_, "channels"), path[0]);
            if (path.size() == 1) return &member(*channel, "source");
            return below_owner(*channel, path.subspan(1), {"enabled", "source", "mode", "opacity"});
        }
        if (path[0] == "mask" && path.size() > 2)
            if (Json* const entry = entry_of(path[1])) return below_entry(*entry, path.subspan(2));
        return below(layer_, path);
    }

  private:
    static Json& member(Json& object, const std::string& key) {
        Json& value = object[key];
        if (value.is_null()) value = Json::object();
        return value;
    }

    /// Below a channel or an entry: its own key, or one of its source.
    static Result<Json*> below_owner(Json& owner, Path path,
                                     std::initializer_list<std::string_view> own) {
        if (among(own, path[0])) return below(owner, path);
        // One that says nothing of its source has a constant.
        if (!owner.contains("source")) return no_setting_of_a_constant(path[0]);
        return below(owner["source"], path);
    }

    static Result<Json*> below_entry(Json& entry, Path path) {
        if (!entry.contains("adjustment"))
            return below_owner(
                entry, path,
                {"name", "visible", "combine", "opacity", "invert", "source", "levels"});
        if (among({"name", "visible", "combine", "opacity", "invert", "adjustment"}, path[0]))
            return below(entry, path);
        return below(entry["adjustment"], path);
    }

    static tl::unexpected<Error> no_setting_of_a_constant(const std::string& key) {
        return failure("\"{}\" is a setting of an image or a procedural, and this is one value",
                       quoted_for_message(key));
    }

    Json* entry_of(const std::string& name) {
        const auto mask = layer_.find("mask");
        if (mask == layer_.end() || !mask->contains("entries")) return nullptr;
        return element_of((*mask)["entries"], name);
    }

    static Result<Json*> below(Json& start, Path path) {
        Json* at = &start;
        for (const std::string& key : path) {
            if (at->is_array()) {
                at = element_of(*at, key);
                if (!at) return failure("there is no \"{}\" in the list", quoted_for_message(key));
                continue;
            }
            if (at->is_null()) *at = Json::object();
            if (!at->is_object()) return no_setting_of_a_constant(key);
            at = &(*at)[key];
        }
        return at;
    }

    Json& layer_;
};

/// Names the place as it was typed and not as the JSON has it.
std::string readable(std::string fault) {
    if (fault.rfind("/0/", 0) == 0) fault.erase(0, 3);
    const std::string channels = "channels/";
    if (fault.rfind(channels, 0) == 0) fault.erase(0, channels.size());
    return fault;
}

Status set_in_layer(Layer& layer, Path path, const Json& value) {
    if (path[0] == "id" || path[0] == "layers" || path[0] == "kind")
        return failure("\"{}\" of a layer cannot be set", path[0]);
    Json json = layers_to_json({std::make_shared<const Layer>(layer)}, JsonIds::Kept);
    const auto place = LayerPlaceFinder(json[0]).find(path);
    if (!place) return passed_on(place);
    **place = value;
    JsonFaults faults;
    const LayerList read = layers_from_json(json, "", faults);
    if (faults.any()) return failure("{}", readable(faults.status().error().message));
    Layer changed = *read.front();
    // The children are as they were: keep their nodes.
    auto* const group = std::get_if<GroupContent>(&changed.content);
    const auto* const old = std::get_if<GroupContent>(&layer.content);
    if (group && old) group->children = old->children;
    layer = std::move(changed);
    return {};
}

struct MaterialSetting {
    Parameter parameter;
    Edit (*edit)(const Material& material, const Json& value);
};
/// A row for each parameter of a material; value.get throws for the wrong kind of JSON.
constexpr auto kMaterialSettings = std::to_array<MaterialSetting>({
    {Parameter::MaterialName,
     [](const Material& m, const Json& v) { return rename_material(m, v.get<std::string>()); }},
    {Parameter::MaterialResolution,
     [](const Material& m, const Json& v) { return set_material_resolution(m, v.get<int>()); }},
    {Parameter::MaterialUvSet,
     [](const Material& m, const Json& v) { return set_material_uv_set(m, v.get<int>()); }},
    {Parameter::MaterialHeightScale,
     [](const Material& m, const Json& v) { return set_material_height_scale(m, v.get<float>()); }},
    {Parameter::MaterialPadding,
     [](const Material& m, const Json& v) {
         const auto padding = choice_from_id<Padding>(v.get<std::string>());
         if (!padding) throw std::invalid_argument("is none of auto, layers, dilate");
         return set_material_padding(m, *padding);
     }},
    {Parameter::MaterialAlphaMode,
     [](const Material& m, const Json& v) {
         const auto mode = choice_from_id<AlphaMode>(v.get<std::string>());
         if (!mode) throw std::invalid_argument("is none of opaque, mask, blend");
         return set_material_alpha_mode(m, *mode);
     }},
    {Parameter::MaterialAlphaCutoff,
     [](const Material& m, const Json& v) { return set_material_alpha_cutoff(m, v.get<float>()); }},
    {Parameter::MaterialDoubleSided,
     [](const Material& m, const Json& v) { return set_material_double_sided(m, v.get<bool>()); }},
    {Parameter::MaterialUnlit,
     [](const Material& m, const Json& v) { return set_material_unlit(m, v.get<bool>()); }},
    {Parameter::MaterialIor,
     [](const Material& m, const Json& v) { return set_material_ior(m, v.get<float>()); }},
    {Parameter::MaterialSpecularFactor,
     [](const Material& m, const Json& v) {
         return set_material_specular_factor(m, v.get<float>());
     }},
    {Parameter::MaterialSpecularColor,
     [](const Material& m, const Json& v) {
         return set_material_specular_color(
             m, {v.at(0).get<float>(), v.at(1).get<float>(), v.at(2).get<float>()});
     }},
    {Parameter::MaterialEmissiveStrength,
     [](const Material& m, const Json& v) {
         return set_material_emissive_strength(m, v.get<float>());
     }},
});

std::string material_parameter_ids() {
    std::string ids;
    for (const MaterialSetting& row : kMaterialSettings)
        ids += (ids.empty() ? "" : ", ") + std::string(info(row.parameter).id);
    return ids;
}

Result<Document> with_material_setting(const Document& before, const Material& material,
                                       const std::string& id, const Json& value) {
    const auto row =
        std::find_if(kMaterialSettings.begin(), kMaterialSettings.end(),
                     [&](const MaterialSetting& entry) { return info(entry.parameter).id == id; });
    if (row == kMaterialSettings.end())
        return failure("\"{}\" is no parameter of a material; there are: {}",
                       quoted_for_message(id, 60), material_parameter_ids());
    try {
        return row->edit(material, value).apply(before);
    } catch (const nlohmann::json::exception&) {
        return failure("\"{}\" is not the kind of value that {} has",
                       quoted_for_message(value.dump(), 60), id);
    } catch (const std::invalid_argument& fault) {
        return failure("\"{}\" {}", quoted_for_message(value.dump(), 60), fault.what());
    }
}

void collect_layers(const LayerList& layers, const std::string& name, std::vector<LayerPtr>& found,
                    std::string& known) {
    for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer) {
        if ((*layer)->name == name) found.push_back(*layer);
        known += (known.empty() ? "" : ", ") + quoted_for_message((*layer)->name, 60);
        if (const auto* group = std::get_if<GroupContent>(&(*layer)->content))
            collect_layers(group->children, name, found, known);
    }
}

/// The layers of that name, the highest first; there is at least one.
Result<std::vector<LayerPtr>> layers_named(const Material& material, const std::string& name) {
    std::vector<LayerPtr> layers;
    std::string known;
    collect_layers(material.stack, name, layers, known);
    if (layers.empty())
        return failure("material \"{}\" has no layer \"{}\"; there are: {}",
                       quoted_for_message(material.name, 60), quoted_for_message(name, 60),
                       quoted_for_message(known, 300));
    return layers;
}

/// A reference may name its layer; the document has the id.
Status resolve_reference(const Material& material, Path path, Json& value) {
    Json* const layer = value.is_object() && value.contains("kind") && value["kind"] == "layer"
                            ? &value["layer"]
                        : path.back() == "layer" ? &value
                                                 : nullptr;
    if (layer == nullptr || !layer->is_string()) return {};
    const auto named = layers_named(material, layer->get<std::string>());
    if (!named) return passed_on(named);
    *layer = named->front()->id.value;
    return {};
}

Result<Document> with_layer_setting(const Document& before, const Material& material, Path path,
                                    Json value) {
    const auto named = layers_named(material, path[0]);
    if (!named) return passed_on(named);
    const std::vector<LayerPtr>& layers = *named;
    if (Status status = resolve_reference(material, path, value); !status) return passed_on(status);
    Document document = before;
    for (const LayerPtr& layer : layers) {
        auto changed =
            with_layer(document, material.id, layer->id, OwnLock::Respected,
                       [&](Layer& copy) { return set_in_layer(copy, path.subspan(1), value); });
        if (!changed) return passed_on(changed);
        document = std::move(*changed);
    }
    return document;
}

}  // namespace

Result<Setting> setting_from_text(std::string_view text) {
    Setting setting;
    setting.text = text;
    const auto fault = [&] {
        return failure("'{}' is no setting such as Body/Rust/opacity=0.5 or Body/resolution=1024",
                       quoted_for_message(text, 100));
    };
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos) return fault();
    setting.value = text.substr(equals + 1);
    std::vector<std::string> parts(1);
    for (std::size_t i = 0; i < equals; ++i) {
        if (text[i] == '\\' && i + 1 < equals)
            parts.back() += text[++i];
        else if (text[i] == '/')
            parts.emplace_back();
        else
            parts.back() += text[i];
    }
    if (parts.size() < 2 || std::any_of(parts.begin(), parts.end(),
                                        [](const std::string& part) { return part.empty(); }))
        return fault();
    setting.material = parts.front();
    setting.path.assign(parts.begin() + 1, parts.end());
    return setting;
}

Result<Document> with_setting(const Document& before, const Setting& setting) {
    const Json value = value_of(setting.value);
    Document document = before;
    std::string known;
    bool found = false;
    for (const MaterialPtr& material : before.materials) {
        known += (known.empty() ? "" : ", ") + quoted_for_message(material->name, 60);
        if (setting.material != "*" && material->name != setting.material) continue;
        found = true;
        auto changed = setting.path.size() == 1
                           ? with_material_setting(document, *material, setting.path[0], value)
                           : with_layer_setting(document, *material, setting.path, value);
        if (!changed)
            return failure("{}: {}", quoted_for_message(setting.text, 100),
                           changed.error().message);
        document = std::move(*changed);
    }
    if (!found)
        return failure("{}: no material is named \"{}\"; there are: {}",
                       quoted_for_message(setting.text, 100),
                       quoted_for_message(setting.material, 60), quoted_for_message(known, 300));
    return document;
}

}  // namespace patina
