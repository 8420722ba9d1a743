// SPDX-License-Identifier: MIT
#include "document/difference.h"

#include <algorithm>
#include <array>
#include <optional>

#include "document/layer_json.h"
#include "document/parameters.h"
#include "document/record.h"

namespace patina {
namespace {

struct Pair {
    std::size_t before;
    std::size_t after;
};

/// Pairs of equal names; what is not in a pair is new or gone.
template <typename List>
std::vector<Pair> paired(const List& before, const List& after) {
    std::vector<Pair> pairs;
    std::vector<bool> taken(before.size(), false);
    for (std::size_t a = 0; a < after.size(); ++a)
        for (std::size_t b = 0; b < before.size(); ++b) {
            if (taken[b] || before[b]->name != after[a]->name) continue;
            taken[b] = true;
            pairs.push_back({b, a});
            break;
        }
    return pairs;
}

/// Whose parameters the members of an object are, by the key that it stands behind; unset where
/// they are none of the table's.
std::optional<Subject> subject_behind(std::string_view key, std::optional<Subject> outer,
                                      const Json& value) {
    struct Row {
        std::string_view key;
        Subject subject;
    };
    constexpr auto kRows = std::to_array<Row>({
        {"channels", Subject::Channel},
        {"height-blend", Subject::HeightBlend},
        {"mask", Subject::Mask},
        {"entries", Subject::MaskEntry},
        {"levels", Subject::Levels},
        {"adjustment", Subject::Adjustment},
        {"transform", Subject::UvTransform},
        {"projection", Subject::Projection},
        {"environment", Subject::Environment},
        {"lights", Subject::Light},
    });
    for (const Row& row : kRows)
        if (row.key == key) return row.subject;
    if (outer == Subject::Channel && channel_from_id(key)) return Subject::Channel;
    if (key != "source" || !value.is_object() || !value.contains("kind")) return std::nullopt;
    const auto kind = value["kind"].get<std::string>();
    if (kind == "image") return Subject::Image;
    if (choice_from_id<ProceduralKind>(kind)) return Subject::Procedural;
    if (choice_from_id<ReliefKind>(kind)) return Subject::Relief;
    return std::nullopt;
}

/// What a parameter is where nothing is written.
std::string standard_text(const ParameterInfo& row) {
    switch (row.kind) {
        case ParameterKind::Switch:
            return row.standard != 0.0 ? "true" : "false";
        case ParameterKind::Choice:
            if (row.parameter == Parameter::LayerMode) return std::string(info(Layer{}.mode).id);
            if (row.choices.empty()) break;  // a channel's mode: the habit of its layer
            return std::string(row.choices[static_cast<std::size_t>(row.standard)].id);
        case ParameterKind::Integer:
        case ParameterKind::Number:
        case ParameterKind::Color:
        case ParameterKind::Vector:
            return compact_text(json_of(static_cast<float>(row.standard)));
        case ParameterKind::Text:
            break;
    }
    return "the default";
}

/// @param key  of the value within the object that it is in
std::string text_of(const Json* value, std::optional<Subject> subject, std::string_view key) {
    if (!value) {
        const auto parameter = subject ? parameter_from_id(*subject, key) : std::nullopt;
        return parameter ? standard_text(info(*parameter)) : "the default";
    }
    std::string text = value->is_string() ? value->get<std::string>() : compact_text(*value);
    return quoted_for_message(text, 80);
}

std::string path_with(const std::string& path, const std::string& key) {
    // Channels need no word before their names, but for the one that layers have too.
    if (path == "channels" && key == "opacity") return "opacity channel";
    if (path.empty() || path == "channels") return key;
    return path + " " + key;
}

/// A value of a document's text, absent (null) on one side or there on both.
struct Compared {
    std::string path = {};                          ///< as people read it
    std::string key = {};                           ///< its last part
    std::optional<Subject> subject = std::nullopt;  ///< whose parameter the key is
    const Json* before = nullptr;
    const Json* after = nullptr;
};

/// Whether the members are compared one by one even if one side has none of them.
bool is_settings(const Json* value, std::optional<Subject> subject) {
    return !value ||
           (value->is_object() && (!value->contains("kind") || subject == Subject::Projection));
}

/// Calls `found` for each value that differs.
/// @param within  whose parameters the members of these two are
template <typename Found>
void compare_json(const Compared& pair, std::optional<Subject> within, const Found& found) {
    const Json* const before = pair.before;
    const Json* const after = pair.after;
    if (before && after && *before == *after) return;
    const bool both_objects = before && after && before->is_object() && after->is_object();
    const bool objects =
        both_objects || (is_settings(before, within) && is_settings(after, within));
    const bool lists = before && after && before->is_array() && after->is_array() &&
                       before->size() == after->size() && !before->empty() &&
                       before->front().is_object();
    const auto member = [](const Json* object, const std::string& key) -> const Json* {
        if (!object) return nullptr;
        const auto it = object->find(key);
        return it == object->end() ? nullptr : &*it;
    };
    const auto compare_member = [&](const std::string& key) {
        const Compared inner{path_with(pair.path, key), key, within, member(before, key),
                             member(after, key)};
        compare_json(inner, subject_behind(key, within, inner.after ? *inner.after : *inner.before),
                     found);
    };
    if (objects) {
        static const Json none = Json::object();
        for (const auto& [key, value] : (after ? *after : none).items()) compare_member(key);
        for (const auto& [key, value] : (before ? *before : none).items())
            if (!member(after, key)) compare_member(key);
    } else if (lists) {
        for (std::size_t i = 0; i < after->size(); ++i) {
            const Json& element = (*after)[i];
            const std::string name = element.contains("name")
                                         ? fmt::format("\"{}\"", element["name"].get<std::string>())
                                         : fmt::format("{}", i + 1);
            compare_json({path_with(pair.path, name), name, within, &(*before)[i], &element},
                         within, found);
        }
    } else {
        found(pair);
    }
}

class Comparison {
  public:
    std::vector<Difference> take() { return std::move(found_); }

    void compare_materials(const Document& before, const Document& after) {
        const auto pairs = paired(before.materials, after.materials);
        std::vector<bool> is_new(after.materials.size(), true);
        std::vector<bool> is_gone(before.materials.size(), true);
        for (const Pair& pair : pairs) is_new[pair.after] = is_gone[pair.before] = false;
        for (std::size_t i = 0; i < after.materials.size(); ++i)
            if (is_new[i]) found_.push_back({after.materials[i]->name, "", "is new"});
        for (const Pair& pair : pairs)
            compare_material(before, *before.materials[pair.before], after,
                             *after.materials[pair.after]);
        for (std::size_t i = 0; i < before.materials.size(); ++i)
            if (is_gone[i]) found_.push_back({before.materials[i]->name, "", "is gone"});
    }

    void compare_scenes(const Document& before, const Document& after) {
        const Json old_scene = scene_json(before);
        const Json new_scene = scene_json(after);
        compare_json({.before = &old_scene, .after = &new_scene}, std::nullopt,
                     [&](const Compared& pair) { add("", "", pair); });
    }

  private:
    static Json scene_json(const Document& document) {
        Json json = Json::parse(
            to_json(SceneRecord{.environment = document.environment, .lights = document.lights}));
        json.erase("version");
        return json;
    }

    /// The settings that are not layers, by their names in the document's text.
    static Json settings_json(const Document& document, const Material& material) {
        Document alone;
        Material bare = material;
        bare.id = {1};
        bare.stack.clear();
        bare.source_material.reset();
        alone.materials = {std::make_shared<const Material>(bare)};
        alone.images = document.images;
        const Json json = Json::parse(serialise(alone));
        return json.contains("materials") ? json["materials"][0] : Json::object();
    }

    void compare_material(const Document& document_before, const Material& before,
                          const Document& document_after, const Material& after) {
        const Json old_settings = settings_json(document_before, before);
        const Json new_settings = settings_json(document_after, after);
        compare_json({.before = &old_settings, .after = &new_settings}, Subject::Material,
                     [&](const Compared& pair) { add(after.name, "", pair); });
        compare_lists(after.name, "", before.stack, after.stack);
    }

    void compare_lists(const std::string& material, const std::string& parents,
                       const LayerList& before, const LayerList& after) {
        const auto pairs = paired(before, after);
        const auto path = [&](const Layer& layer) {
            return parents.empty() ? layer.name : parents + " / " + layer.name;
        };
        const auto lacks = [&](std::size_t Pair::*side, std::size_t index) {
            return std::none_of(pairs.begin(), pairs.end(),
                                [&](const Pair& pair) { return pair.*side == index; });
        };
        for (std::size_t i = 0; i < after.size(); ++i)
            if (lacks(&Pair::after, i)) found_.push_back({material, path(*after[i]), "is new"});
        std::size_t highest = 0;
        for (const Pair& pair : pairs) {
            if (pair.before < highest)
                found_.push_back({material, path(*after[pair.after]), "has moved in the stack"});
            highest = std::max(highest, pair.before);
            compare_layers(material, path(*after[pair.after]), before[pair.before],
                           after[pair.after]);
        }
        for (std::size_t i = 0; i < before.size(); ++i)
            if (lacks(&Pair::before, i)) found_.push_back({material, path(*before[i]), "is gone"});
    }

    void compare_layers(const std::string& material, const std::string& path,
                        const LayerPtr& before, const LayerPtr& after) {
        if (before == after) return;
        const Json old_layer = layer_json(before);
        const Json new_layer = layer_json(after);
        compare_json({.before = &old_layer, .after = &new_layer}, Subject::Layer,
                     [&](const Compared& pair) { add(material, path, pair); });
        const auto* old_group = std::get_if<GroupContent>(&before->content);
        const auto* new_group = std::get_if<GroupContent>(&after->content);
        if (old_group && new_group)
            compare_lists(material, path, old_group->children, new_group->children);
    }

    /// With what is on and off, and every value of a fill, said in so many words: their defaults
    /// depend on the kind of the layer and on the channel.
    static Json layer_json(const LayerPtr& layer) {
        Layer copy = *layer;
        const bool of_fill = !layer->is_group() && !layer->is_adjustment();
        if (of_fill)
            for (ChannelSettings& settings : copy.channels) settings.enabled = true;
        Json json =
            layers_to_json({std::make_shared<const Layer>(std::move(copy))}, JsonIds::LeftOut)[0];
        for (const ChannelInfo& row : kChannels)
            json["channels"][std::string(row.id)]["enabled"] =
                at(layer->channels, row.channel).enabled;
        json["height-blend"]["enabled"] = layer->height_blend.enabled;
        json.erase("layers");
        json.erase("open");  // of the list, not of the picture
        return json;
    }

    void add(const std::string& material, const std::string& layer, const Compared& pair) {
        const auto text = [&](const Json* value) { return text_of(value, pair.subject, pair.key); };
        found_.push_back(
            {material, layer,
             fmt::format("{} is {}, was {}", pair.path, text(pair.after), text(pair.before))});
    }

    std::vector<Difference> found_;
};

}  // namespace

std::vector<Difference> differences(const Document& before, const Document& after) {
    Comparison comparison;
    comparison.compare_scenes(before, after);
    comparison.compare_materials(before, after);
    return comparison.take();
}

}  // namespace patina
