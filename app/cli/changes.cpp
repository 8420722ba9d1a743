// SPDX-License-Identifier: MIT
#include "cli/changes.h"

#include <fmt/format.h>

#include "core/files.h"
#include "document/edits.h"
#include "document/layer_json.h"
#include "document/record.h"
#include "io/texture_folder.h"

namespace patina::cli {
namespace {

void apply(io::LoadedDocument& loaded, Document document) {
    loaded.document = std::make_shared<const Document>(std::move(document));
}

/// Splits at the last "@", unless it is part of a path that is there.
LayRequest path_request(const std::string& text) {
    const std::size_t at = text.rfind('@');
    std::error_code error;
    if (at == std::string::npos || std::filesystem::exists(text, error)) return {text, {}};
    return {text.substr(0, at), text.substr(at + 1)};
}

bool is_inline_json(std::string_view text) {
    return !text.empty() && (text.front() == '{' || text.front() == '[');
}

/// JSON itself may be followed by "@MATERIAL".
LayRequest layer_request(const std::string& text) {
    if (!is_inline_json(text)) return path_request(text);
    const std::size_t end = text.find_last_of("}]");
    if (end == std::string::npos || end + 1 >= text.size() || text[end + 1] != '@')
        return {text, {}};
    return {text.substr(0, end + 1), text.substr(end + 2)};
}

Status lay_on(io::LoadedDocument& loaded, const std::string& material_name,
              const std::vector<LayerPtr>& layers, const std::string& label) {
    const auto materials = named_materials(*loaded.document, material_name);
    if (!materials) return passed_on(materials);
    for (const MaterialPtr& material : *materials) {
        auto edited = add_layers(*material, layers, top_of_stack(), label).apply(*loaded.document);
        if (!edited) return passed_on(edited);
        apply(loaded, std::move(*edited));
    }
    return {};
}

Status apply_textures(io::LoadedDocument& loaded, const LayRequest& request, bool quiet,
                      const Progress& progress) {
    const auto folder = io::read_texture_folder(request.what, *loaded.images, progress);
    if (!folder) return passed_on(folder);
    if (!quiet)
        for (const io::TextureUseOfFile& file : folder->files)
            fmt::print(stderr, "patina: {}\n", file.described);
    Document with_images = *loaded.document;
    for (const ImageAssetPtr& image : folder->images)
        with_images.images.emplace(image->hash, image);
    apply(loaded, std::move(with_images));
    return lay_on(loaded, request.material, {std::make_shared<const Layer>(folder->layer)},
                  "Textures");
}

Result<std::vector<LayerPtr>> layers_of(const std::string& what) {
    const bool is_inline = is_inline_json(what);
    const std::string name = is_inline ? "--layer" : quoted_for_message(what);
    auto text = is_inline ? Result<std::string>(what) : read_text_file(what);
    if (!text) return passed_on(text);
    auto json = json_from_text(*text);
    if (!json) return failure("{}: {}", name, json.error().message);
    if (json->is_object() && json->contains("layers") && !json->contains("kind"))
        json = Json((*json)["layers"]);  // a preset's file
    if (json->is_object()) json = Json::array({*json});
    JsonFaults faults;
    auto layers = layers_from_json(*json, "", faults);
    if (faults.any())
        return failure("{}: {}; see 'patina preset show rusted-iron' for what layers look like",
                       name, faults.status().error().message);
    return layers;
}

void add_lay_option(CLI::App& app, const std::string& flag, std::vector<LayRequest>& requests,
                    LayRequest (*read)(const std::string&), const std::string& type,
                    const std::string& help) {
    app.add_option_function<std::vector<std::string>>(
           flag,
           [&requests, read](const std::vector<std::string>& texts) {
               for (const std::string& text : texts) requests.push_back(read(text));
           },
           help)
        ->allow_extra_args(false)
        ->type_name(type);
}

}  // namespace

void add_change_options(CLI::App& app, Changes& changes) {
    add_preset_options(app, changes.presets);
    add_lay_option(app, "--textures", changes.textures, path_request, "DIR[@MATERIAL]",
                   "A folder of textures as a layer; what each is for is guessed from its name\n"
                   "(_albedo, _rough, _metal, _orm, _nrm, _nor_dx, _ao, _disp ...) and printed;\n"
                   "DIR/NAME is the material of that name in a folder of several");
    add_lay_option(app, "--layer", changes.layers, layer_request, "JSON[@MATERIAL]",
                   "Layers as presets have them: a file, or the JSON itself");
    app.add_option_function<std::vector<std::string>>(
           "--set",
           [&changes](const std::vector<std::string>& texts) {
               for (const std::string& text : texts) {
                   auto setting = setting_from_text(text);
                   if (!setting) throw CLI::ValidationError("--set", setting.error().message);
                   changes.settings.push_back(std::move(*setting));
               }
           },
           "One value, after all else was laid on. Names are those that 'patina info' and presets\n"
           "show: Body/Rust/opacity=0.5, Body/Rust/base-color=#8a3b12,\n"
           "Body/Rust/roughness/scale=24, Body/Rust/mask/base=0, Body/resolution=1024;\n"
           "'*' is every material")
        ->allow_extra_args(false)
        ->type_name("MATERIAL/LAYER/PARAMETER=VALUE");
    app.add_option_function<std::vector<std::string>>(
           "--light",
           [&changes](const std::vector<std::string>& texts) {
               for (const std::string& text : texts) {
                   auto light = light_from_json(text);
                   if (!light) throw CLI::ValidationError("--light", light.error().message);
                   changes.lights.push_back(std::move(*light));
               }
           },
           "One more lamp, as JSON. Kinds: directional, point, spot, sphere, rectangle. Angles\n"
           "(inner-cone, outer-cone, turn) are in radians as in glTF, lengths in metres:\n"
           R"({"kind":"sphere","position":[1,2,1],"intensity":20,"radius":0.3})")
        ->allow_extra_args(false)
        ->type_name("JSON");
}

namespace {

Status apply_changes(io::LoadedDocument& loaded, const Changes& changes, bool quiet,
                     const Progress& progress) {
    for (const LayRequest& request : changes.textures)
        if (const Status done = apply_textures(loaded, request, quiet, progress); !done)
            return done;
    if (const Status done = apply_presets(loaded, changes.presets); !done) return done;
    for (const LayRequest& request : changes.layers) {
        const auto layers = layers_of(request.what);
        if (!layers) return passed_on(layers);
        if (const Status done = lay_on(loaded, request.material, *layers, "Layers"); !done)
            return done;
    }
    for (const Setting& setting : changes.settings) {
        auto edited = with_setting(*loaded.document, setting);
        if (!edited) return passed_on(edited);
        apply(loaded, std::move(*edited));
    }
    for (const Light& light : changes.lights) {
        auto edited = add_light(light).apply(*loaded.document);
        if (!edited) return passed_on(edited);
        apply(loaded, std::move(*edited));
    }
    return {};
}

}  // namespace

Result<io::LoadedDocument> changed_document(const std::filesystem::path& path,
                                            const Changes& changes, bool quiet,
                                            const Progress& progress) {
    auto loaded = opened_document(path, progress);
    if (!loaded) return passed_on(loaded);
    if (const Status applied = apply_changes(*loaded, changes, quiet, progress); !applied)
        return passed_on(applied);
    return loaded;
}

}  // namespace patina::cli
