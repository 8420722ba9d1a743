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

KnobRequest knob_request(const std::string& text) {
    const std::size_t equals = text.find('=');
    const std::string name = text.substr(0, equals);
    const std::size_t slash = name.rfind('/');
    KnobRequest request;
    if (slash != std::string::npos) request.preset = name.substr(0, slash);
    request.setting.id = name.substr(slash == std::string::npos ? 0 : slash + 1);
    const char* const from = text.data() + (equals == std::string::npos ? 0 : equals + 1);
    const char* const to = text.data() + text.size();
    const auto [end, error] = std::from_chars(from, to, request.setting.value);
    if (equals == std::string::npos || error != std::errc() || end != to)
        throw CLI::ValidationError(
            "--knob",
            fmt::format("'{}' is no knob and number such as rust=0.7 or rusted-iron/rust=0.7",
                        text));
    return request;
}

/// Whether the knob is one of the preset that was asked for.
bool is_of(const KnobRequest& knob, const PresetRequest& request, const Preset& preset) {
    const bool named = knob.preset.empty() || knob.preset == request.preset ||
                       knob.preset == preset.id ||
                       knob.preset == request.preset + "@" + request.material;
    return named && std::any_of(preset.knobs.begin(), preset.knobs.end(),
                                [&](const PresetKnob& own) { return own.id == knob.setting.id; });
}

/// The settings of the preset's knobs; those that name it are last, which makes them count.
/// `used` notes which of the knobs they are.
std::vector<KnobSetting> own_settings(const Preset& preset, const PresetRequest& request,
                                      const std::vector<KnobRequest>& knobs,
                                      std::vector<bool>& used) {
    std::vector<KnobSetting> own;
    for (const bool named : {false, true})
        for (std::size_t i = 0; i < knobs.size(); ++i)
            if (knobs[i].preset.empty() != named && is_of(knobs[i], request, preset)) {
                own.push_back(knobs[i].setting);
                used[i] = true;
            }
    return own;
}

/// Reads the presets and turns their knobs.
Result<std::vector<io::PresetFile>> turned_presets(const PresetRequests& requests) {
    std::vector<io::PresetFile> files;
    std::vector<bool> used(requests.knobs.size(), false);
    for (const PresetRequest& request : requests.presets) {
        auto file = io::find_preset(request.preset);
        if (!file) return passed_on(file);
        const auto own = own_settings(file->preset, request, requests.knobs, used);
        auto layers = turned_layers(file->preset, own);
        if (!layers) return passed_on(layers);
        if (!own.empty()) file->preset.layers = std::move(*layers);
        files.push_back(std::move(*file));
    }
    for (std::size_t i = 0; i < used.size(); ++i)
        if (const KnobRequest& knob = requests.knobs[i]; !used[i])
            return failure(
                "no preset that was given {}has a knob {}",
                knob.preset.empty() ? "" : fmt::format("as {} ", quoted_for_message(knob.preset)),
                quoted_for_message(knob.setting.id));
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
        for (const std::string& text : texts) requests.knobs.push_back(knob_request(text));
    };
    app.add_option_function<std::vector<std::string>>(
           "--knob", read_knobs,
           "Turn a knob of the presets, or of one of them, 0 to 1 ('patina preset knobs' says\n"
           "which there are); may be given several times: rust=0.3,\n"
           "rusted-iron/rust=0.7, rusted-iron@Body/rust=0.7")
        ->allow_extra_args(false)
        ->type_name("[PRESET/]NAME=VALUE");
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
