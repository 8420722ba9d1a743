// SPDX-License-Identifier: MIT
#include "cli/input.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "core/log.h"
#include "document/edits.h"
#include "io/preset_library.h"

namespace patina::cli {
namespace {

Status apply_preset_file(io::LoadedDocument& loaded, const io::PresetFile& file,
                         const std::vector<ImageAssetPtr>& images, const MaterialPtr& material) {
    const Edit edit = apply_preset(*material, file.preset, top_of_stack(), images);
    auto edited = edit.apply(*loaded.document);
    if (!edited) return passed_on(edited);
    loaded.document = std::make_shared<const Document>(std::move(*edited));
    return {};
}

PresetRequest preset_request(std::string_view text) {
    const std::size_t at = text.find('@');
    if (at == std::string_view::npos) return {.preset = std::string(text), .material = {}};
    return {.preset = std::string(text.substr(0, at)),
            .material = std::string(text.substr(at + 1))};
}

KnobSetting knob_setting(const std::string& text) {
    const std::size_t equals = text.find('=');
    KnobSetting setting{.id = text.substr(0, equals)};
    const char* const from = text.data() + (equals == std::string::npos ? 0 : equals + 1);
    const char* const to = text.data() + text.size();
    const auto [end, error] = std::from_chars(from, to, setting.value);
    if (equals == std::string::npos || error != std::errc() || end != to)
        throw CLI::ValidationError(
            "--knob", fmt::format("'{}' is no knob and number such as wear=0.7", text));
    return setting;
}

/// The settings of knobs that the preset has.
std::vector<KnobSetting> own_settings(const Preset& preset,
                                      const std::vector<KnobSetting>& settings) {
    std::vector<KnobSetting> own;
    for (const KnobSetting& setting : settings)
        if (std::any_of(preset.knobs.begin(), preset.knobs.end(),
                        [&](const PresetKnob& knob) { return knob.id == setting.id; }))
            own.push_back(setting);
    return own;
}

/// Reads the presets and turns their knobs.
Result<std::vector<io::PresetFile>> turned_presets(const PresetRequests& requests) {
    std::vector<io::PresetFile> files;
    std::vector<KnobSetting> unused = requests.knobs;
    for (const PresetRequest& request : requests.presets) {
        auto file = io::find_preset(request.preset);
        if (!file) return passed_on(file);
        const std::vector<KnobSetting> own = own_settings(file->preset, requests.knobs);
        auto layers = turned_layers(file->preset, own);
        if (!layers) return passed_on(layers);
        if (!own.empty()) file->preset.layers = std::move(*layers);
        for (const KnobSetting& setting : own)
            std::erase_if(unused, [&](const KnobSetting& each) { return each.id == setting.id; });
        files.push_back(std::move(*file));
    }
    if (!unused.empty())
        return failure("no preset that was given has a knob {}",
                       quoted_for_message(unused.front().id));
    return files;
}

}  // namespace

Result<io::LoadedDocument> opened_document(const std::filesystem::path& path,
                                           const Progress& progress) {
    auto loaded = io::load_document(path, {}, progress);
    if (loaded)
        for (const std::string& warning : loaded->warnings) log_warning("{}", warning);
    return loaded;
}

Result<std::vector<MaterialPtr>> named_materials(const Document& document, std::string_view name) {
    std::vector<MaterialPtr> found;
    std::string known;
    for (const MaterialPtr& material : document.materials) {
        if (name.empty() || material->name == name) found.push_back(material);
        known += (known.empty() ? "" : ", ") + quoted_for_message(material->name);
    }
    if (found.empty())
        return failure("no material is named '{}'; there are: {}", quoted_for_message(name),
                       known.empty() ? "none" : known);
    return found;
}

void add_preset_options(CLI::App& app, PresetRequests& requests) {
    const auto read = [&requests](const std::vector<std::string>& texts) {
        for (const std::string& text : texts) requests.presets.push_back(preset_request(text));
    };
    const auto read_knobs = [&requests](const std::vector<std::string>& texts) {
        for (const std::string& text : texts) requests.knobs.push_back(knob_setting(text));
    };
    app.add_option_function<std::vector<std::string>>(
           "--knob", read_knobs,
           "Turn a knob of the presets, 0 to 1 ('patina preset list --json' says which there\n"
           "are); may be given several times")
        ->allow_extra_args(false)
        ->type_name("NAME=VALUE");
    app.add_option_function<std::vector<std::string>>(
           "--preset,--material-preset", read,
           "A preset for the material of that name, or for all: the name of one that ships\n"
           "(see 'patina preset list') or a file; may be given several times")
        ->allow_extra_args(false)
        ->type_name("NAME[@MATERIAL]");
}

Status apply_presets(io::LoadedDocument& loaded, const PresetRequests& requests) {
    const auto files = turned_presets(requests);
    if (!files) return passed_on(files);
    for (std::size_t i = 0; i < files->size(); ++i) {
        const io::PresetFile& file = (*files)[i];
        const auto images = io::add_preset_images(file, *loaded.images);
        if (!images) return passed_on(images);
        const auto materials = named_materials(*loaded.document, requests.presets[i].material);
        if (!materials) return passed_on(materials);
        for (const MaterialPtr& material : *materials)
            if (const Status applied = apply_preset_file(loaded, file, *images, material); !applied)
                return applied;
    }
    return {};
}

}  // namespace patina::cli
