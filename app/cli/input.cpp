// SPDX-License-Identifier: MIT
#include "cli/input.h"

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

void add_preset_option(CLI::App& app, std::vector<PresetRequest>& requests) {
    const auto read = [&requests](const std::vector<std::string>& texts) {
        for (const std::string& text : texts) requests.push_back(preset_request(text));
    };
    app.add_option_function<std::vector<std::string>>(
           "--preset", read,
           "A preset for the material of that name, or for all: the name of one that ships\n"
           "(see 'patina preset list') or a file; may be given several times")
        ->allow_extra_args(false)
        ->type_name("NAME[@MATERIAL]");
}

Status apply_presets(io::LoadedDocument& loaded, const std::vector<PresetRequest>& requests) {
    for (const PresetRequest& request : requests) {
        const auto file = io::find_preset(request.preset);
        if (!file) return passed_on(file);
        const auto images = io::add_preset_images(*file, *loaded.images);
        if (!images) return passed_on(images);
        const auto materials = named_materials(*loaded.document, request.material);
        if (!materials) return passed_on(materials);
        for (const MaterialPtr& material : *materials)
            if (const Status applied = apply_preset_file(loaded, *file, *images, material);
                !applied)
                return applied;
    }
    return {};
}

}  // namespace patina::cli
