// SPDX-License-Identifier: MIT
#include "document/difference.h"

#include <algorithm>
#include <optional>

#include "document/layer_json.h"
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

std::string text_of(const Json* value) {
    if (!value) return "the default";
    std::string text = value->is_string() ? value->get<std::string>() : compact_text(*value);
    return quoted_for_message(text, 80);
}

std::string path_with(const std::string& path, const std::string& key) {
    // Channels need no word before their names, but for the one that layers have too.
    if (path == "channels" && key == "opacity") return "opacity channel";
    if (path.empty() || path == "channels") return key;
    return path + " " + key;
}

/// Calls `found(path, before, after)` for each value that differs; null where it is absent.
template <typename Found>
void compare_json(const std::string& path, const Json* before, const Json* after,
                  const Found& found) {
    if (before && after && *before == *after) return;
    const auto is_settings = [](const Json* value) {
        return !value || (value->is_object() && !value->contains("kind"));
    };
    const bool both_objects = before && after && before->is_object() && after->is_object();
    const bool objects = both_objects || (is_settings(before) && is_settings(after));
    const bool lists = before && after && before->is_array() && after->is_array() &&
                       before->size() == after->size() && !before->empty() &&
                       before->front().is_object();
    const auto member = [](const Json& object, const std::string& key) -> const Json* {
        const auto it = object.find(key);
        return it == object.end() ? nullptr : &*it;
    };
    if (objects) {
        static const Json none = Json::object();
        const Json& old_object = before ? *before : none;
        const Json& new_object = after ? *after : none;
        for (const auto& [key, value] : new_object.items())
            compare_json(path_with(path, key), member(old_object, key), &value, found);
        for (const auto& [key, value] : old_object.items())
            if (!new_object.contains(key))
                compare_json(path_with(path, key), &value, nullptr, found);
    } else if (lists) {
        for (std::size_t i = 0; i < after->size(); ++i) {
            const Json& element = (*after)[i];
            const std::string name = element.contains("name")
                                         ? fmt::format("\"{}\"", element["name"].get<std::string>())
                                         : fmt::format("{}", i + 1);
            compare_json(path_with(path, name), &(*before)[i], &element, found);
        }
    } else {
        found(path, before, after);
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
        compare_json("", &old_scene, &new_scene,
                     [&](const std::string& path, const Json* was, const Json* is) {
                         add("", "", path, was, is);
                     });
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
        compare_json("", &old_settings, &new_settings,
                     [&](const std::string& path, const Json* was, const Json* is) {
                         add(after.name, "", path, was, is);
                     });
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
        compare_json("", &old_layer, &new_layer,
                     [&](const std::string& place, const Json* was, const Json* is) {
                         add(material, path, place, was, is);
                     });
        const auto* old_group = std::get_if<GroupContent>(&before->content);
        const auto* new_group = std::get_if<GroupContent>(&after->content);
        if (old_group && new_group)
            compare_lists(material, path, old_group->children, new_group->children);
    }

    static Json layer_json(const LayerPtr& layer) {
        Json json = layers_to_json({layer}, JsonIds::LeftOut)[0];
        json.erase("layers");
        json.erase("open");  // of the list, not of the picture
        return json;
    }

    void add(const std::string& material, const std::string& layer, const std::string& path,
             const Json* was, const Json* is) {
        found_.push_back(
            {material, layer, fmt::format("{} is {}, was {}", path, text_of(is), text_of(was))});
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
