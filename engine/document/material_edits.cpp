// SPDX-License-Identifier: MIT
#include "document/material_edits.h"

#include <fmt/format.h>

#include <bit>

#include "core/log.h"
#include "document/change.h"
#include "document/check.h"
#include "document/layer_json.h"
#include "document/preset.h"
#include "document/record.h"
#include "document/references.h"
#include "document/scene_edits.h"

namespace patina {
namespace {

/// What tells text that `copied_layers` made from any other.
constexpr std::string_view kClipboardKey = "patina-layers";

/// Sets one member after `check` has found the value good.
template <typename Value>
Edit member_edit(const Material& material, Parameter parameter, Value Material::*member,
                 Value value, std::function<Status()> check) {
    const ParameterInfo& row = info(parameter);
    const bool merges = row.kind == ParameterKind::Number || row.kind == ParameterKind::Color;
    return {.label = fmt::format("{} of {}", row.label, material.name),
            .merge_key = merges ? MergeKey{fmt::format("material.{}", row.id), material.id.value}
                                : MergeKey{},
            .apply = [id = material.id, member, value, check](const Document& before) {
                return with_material(before, id, [&](Material& copy) -> Status {
                    copy.*member = value;
                    return check();
                });
            }};
}

Edit number_edit(const Material& material, Parameter parameter, float Material::*member,
                 float value) {
    return member_edit(material, parameter, member, value,
                       [parameter, value] { return check_range(parameter, value); });
}

/// Switches and choices, whose every value is good.
template <typename Value>
Edit choice_edit(const Material& material, Parameter parameter, Value Material::*member,
                 Value value) {
    return member_edit(material, parameter, member, value, [] { return Status{}; });
}

/// The preset's layers as they go onto a stack: one as it is, several as a group.
std::vector<LayerPtr> laid_on(const Preset& preset) {
    if (preset.layers.size() == 1) return preset.layers;
    Layer group = group_layer();
    group.name = preset.name;
    group.content = GroupContent{.children = preset.layers, .open = false};
    return {std::make_shared<const Layer>(std::move(group))};
}

Edit with_images(std::vector<ImageAssetPtr> images, Edit edit) {
    Edits edits;
    for (ImageAssetPtr& image : images) edits.push_back(add_image(std::move(image)));
    std::string label = edit.label;
    edits.push_back(std::move(edit));
    return in_one_step(std::move(label), std::move(edits));
}

struct Clipboard {
    LayerList layers;
    LayerNames names;  ///< of other layers that they read
};

LayerNames names_from_json(JsonObject& object) {
    LayerNames names;
    const Json* json = object.find("reads");
    if (!json || !json->is_array()) return names;
    for (std::size_t i = 0; i < json->size(); ++i) {
        JsonObject each((*json)[i], fmt::format("/reads/{}", i), object.faults());
        each.require("layer");
        const auto id = each.integer("layer", 1, std::int64_t{1} << 53, 1);
        names.emplace(LayerId{static_cast<std::uint64_t>(id)}, each.required_text("name"));
    }
    return names;
}

Result<Clipboard> layers_from_clipboard(std::string_view text) {
    const Result<Json> json = json_from_text(text);
    if (!json || !json->is_object() || !json->contains(std::string(kClipboardKey)))
        return failure("the clipboard holds no layers");
    JsonFaults faults;
    JsonObject object(*json, "", faults);
    object.integer(kClipboardKey, kRecordVersion, kRecordVersion, kRecordVersion);
    LayerList layers;
    if (const Json* list = object.require("layers"))
        layers = layers_from_json(*list, "/layers", faults);
    LayerNames names = names_from_json(object);
    object.finish();
    if (faults.any())
        return failure("the layers in the clipboard cannot be read: {}",
                       faults.status().error().message);
    if (layers.empty()) return failure("the clipboard holds no layers");
    return Clipboard{std::move(layers), std::move(names)};
}

}  // namespace

Edit rename_material(const Material& material, std::string name) {
    Edit edit = member_edit(material, Parameter::MaterialName, &Material::name, name,
                            [name] { return check_name(name); });
    edit.label = "Rename material to " + name;
    return edit;
}

Edit set_material_resolution(const Material& material, int resolution) {
    return member_edit(
        material, Parameter::MaterialResolution, &Material::resolution, resolution,
        [resolution]() -> Status {
            if (Status status = check_range(Parameter::MaterialResolution, resolution); !status)
                return status;
            if (std::has_single_bit(static_cast<unsigned>(resolution))) return {};
            return failure("Size must be a power of two, got {}", resolution);
        });
}

Edit set_material_uv_set(const Material& material, int uv_set) {
    return member_edit(material, Parameter::MaterialUvSet, &Material::uv_set, uv_set,
                       [uv_set] { return check_range(Parameter::MaterialUvSet, uv_set); });
}

Edit set_material_height_scale(const Material& material, float height_scale) {
    return number_edit(material, Parameter::MaterialHeightScale, &Material::height_scale,
                       height_scale);
}

Edit set_material_padding(const Material& material, Padding padding) {
    return choice_edit(material, Parameter::MaterialPadding, &Material::padding, padding);
}

Edit set_material_alpha_mode(const Material& material, AlphaMode mode) {
    return choice_edit(material, Parameter::MaterialAlphaMode, &Material::alpha_mode, mode);
}

Edit set_material_alpha_cutoff(const Material& material, float cutoff) {
    return number_edit(material, Parameter::MaterialAlphaCutoff, &Material::alpha_cutoff, cutoff);
}

Edit set_material_double_sided(const Material& material, bool double_sided) {
    return choice_edit(material, Parameter::MaterialDoubleSided, &Material::double_sided,
                       double_sided);
}

Edit set_material_unlit(const Material& material, bool unlit) {
    return choice_edit(material, Parameter::MaterialUnlit, &Material::unlit, unlit);
}

Edit set_material_ior(const Material& material, float ior) {
    return number_edit(material, Parameter::MaterialIor, &Material::ior, ior);
}

Edit set_material_specular_factor(const Material& material, float factor) {
    return number_edit(material, Parameter::MaterialSpecularFactor, &Material::specular_factor,
                       factor);
}

Edit set_material_specular_color(const Material& material, const glm::vec3& color_linear) {
    return member_edit(
        material, Parameter::MaterialSpecularColor, &Material::specular_color_linear, color_linear,
        [color_linear] { return check_color(Parameter::MaterialSpecularColor, color_linear); });
}

Edit set_material_emissive_strength(const Material& material, float strength) {
    return number_edit(material, Parameter::MaterialEmissiveStrength, &Material::emissive_strength,
                       strength);
}

Edit apply_preset(const Material& material, const Preset& preset, LayerPlace place,
                  std::vector<ImageAssetPtr> images) {
    return with_images(std::move(images), add_layers(material, laid_on(preset), place,
                                                     "Apply preset to " + material.name));
}

Edit replace_stack_by_preset(const Material& material, const Preset& preset,
                             std::vector<ImageAssetPtr> images) {
    return with_images(std::move(images), replace_stack(material, laid_on(preset),
                                                        "Replace layers of " + material.name));
}

std::string copied_layers(const std::vector<LayerPtr>& layers, const std::vector<LayerPtr>& stack) {
    Json json = {{kClipboardKey, kRecordVersion},
                 {"layers", layers_to_json(layers, JsonIds::LeftOut)}};
    for (const auto& [id, name] : names_read(layers, stack))
        json["reads"].push_back({{"layer", id.value}, {"name", name}});
    return indented_text(json);
}

Edit paste_layers(const Material& material, std::string_view text, LayerPlace place) {
    Result<Clipboard> clipboard = layers_from_clipboard(text);
    if (!clipboard)
        return {.label = "Paste layers",
                .merge_key = {},
                .apply = [error = clipboard.error()](const Document&) -> Result<Document> {
                    return tl::unexpected<Error>(error);
                }};
    BroughtLayers brought = brought_to(material.stack, clipboard->layers, clipboard->names);
    std::string label = brought.layers.size() == 1
                            ? "Paste " + brought.layers.front()->name
                            : fmt::format("Paste {} layers", brought.layers.size());
    if (brought.dropped > 0)
        log_warning(
            "{}: {} of what it reads of other layers is left out: this material has none of "
            "these names",
            quoted_for_message(label, 100), brought.dropped);
    return add_layers(material, std::move(brought.layers), place, std::move(label));
}

}  // namespace patina
