// SPDX-License-Identifier: MIT
// patina bake: presets laid on, every stack baked, one glTF file written.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/changes.h"
#include "cli/commands.h"
#include "cli/input.h"
#include "cli/map_options.h"
#include "cli/progress_bar.h"
#include "cli/uv_report.h"
#include "core/log.h"
#include "document/material_warnings.h"
#include "io/save.h"

namespace patina::cli {
namespace {

constexpr const char* kBakeFooter =
    "Layers lie on top of what the material had; textures that no layer covers stay as they are.\n"
    "With nothing to change, the output is the input, byte for byte.\n"
    "\n"
    "Examples:\n"
    "  patina bake model.glb --preset rusted-iron@Body --size 2048 -o out.glb\n"
    "  patina bake model.glb --preset painted-wood --preset my/dust.json -o out.glb\n"
    "  patina bake model.glb --textures wood@Body --set Body/wood/opacity=0.8 -o out.glb\n"
    "  patina bake model.glb --layer '{\"name\": \"Gold\", \"channels\": {\"metalness\": "
    "{\"source\": 1}}}' -o out.glb\n"
    "  patina bake painted.glb --maps maps --map-format exr --packing separate -o out.glb\n"
    "  patina bake model.glb --preset rusted-iron --maps maps";

struct BakeOptions {
    std::filesystem::path input;
    std::filesystem::path output;  ///< empty: only the maps
    Changes changes;
    io::SaveOptions save;
    std::filesystem::path maps_folder;
    io::MapExportOptions maps;
    WorkOptions work;
};

struct BakeReport {
    io::SaveReport saved;
    std::vector<std::filesystem::path> map_files;
    std::vector<std::pair<std::string, UvLayout>> uvs;  ///< of each material, by its name
};

nlohmann::ordered_json to_json(const BakeReport& baked) {
    const io::SaveReport& report = baked.saved;
    nlohmann::ordered_json files = nlohmann::ordered_json::array();
    for (const auto& file : baked.map_files) files.push_back(file.string());
    nlohmann::ordered_json uvs = nlohmann::ordered_json::array();
    for (const auto& [name, layout] : baked.uvs) {
        uvs.push_back({{"material", name}});
        uvs.back().update(uv_layout_json(layout));
    }
    const bool written = !report.path.empty();
    return {{"output", written ? nlohmann::ordered_json(report.path.string()) : nullptr},
            {"bytes", report.bytes},
            {"materials_written", report.materials_written},
            {"maps_baked", report.maps_baked},
            {"map_files", files},
            {"uvs", uvs},
            {"warnings", report.warnings}};
}

void print(const BakeReport& baked) {
    const io::SaveReport& report = baked.saved;
    if (!report.path.empty())
        fmt::print("{}: {} bytes, {} materials written, {} maps baked\n", report.path.string(),
                   report.bytes, report.materials_written, report.maps_baked);
    for (const auto& file : baked.map_files) fmt::print("{}\n", file.string());
    for (const auto& [name, layout] : baked.uvs)
        if (layout.overlapped > 0.0 || !layout.measured)
            fmt::print("UVs of {}: {}\n", quoted_for_message(name), uv_layout_words(layout));
}

/// Nothing where only the maps are asked for, but what a save would say of the model.
Result<io::SaveReport> save(const BakeOptions& options, const Document& document,
                            ImageProvider& images, const Progress& progress) {
    if (options.output.empty()) {
        io::SaveReport nothing;
        for (const MaterialPtr& material : document.materials)
            for (std::string& line : warnings_of(document, *material))
                nothing.warnings.push_back(std::move(line));
        return nothing;
    }
    io::SaveOptions save = options.save;
    save.keep_maps = !options.maps_folder.empty();
    save.png_level = options.maps.png_level;
    return io::save_document(document, images, options.output, save, progress);
}

Result<BakeReport> bake(const BakeOptions& options, const Progress& progress) {
    auto loaded = changed_document(options.input, options.changes, options.work.quiet, progress);
    if (!loaded) return passed_on(loaded);
    auto saved = save(options, *loaded->document, *loaded->images, progress);
    if (!saved) return passed_on(saved);
    BakeReport report{.saved = std::move(*saved), .map_files = {}, .uvs = {}};
    const bool reported = options.work.json || !options.work.quiet;
    for (const MaterialPtr& material : loaded->document->materials)
        if (reported)
            report.uvs.emplace_back(material->name, uv_layout_of(*loaded->document, *material));
    if (options.maps_folder.empty()) return report;
    for (std::string& line : io::warnings_of(options.maps))
        report.saved.warnings.push_back(std::move(line));
    io::MapExportOptions maps = options.maps;
    maps.size = options.save.size;
    maps.baked = &report.saved.maps;
    auto files =
        io::export_maps(*loaded->document, *loaded->images, options.maps_folder, maps, progress);
    if (!files) return passed_on(files);
    report.saved.maps.clear();
    report.map_files = std::move(*files);
    return report;
}

Status run_bake(const BakeOptions& options) {
    const ThreadScope threads(options.work);
    const Progress progress;
    Result<BakeReport> report;
    {
        const ProgressBar bar(progress, !options.work.quiet);
        report = bake(options, progress);
    }
    if (!report) return passed_on(report);
    for (const std::string& warning : report->saved.warnings) log_warning("{}", warning);
    if (options.work.json)
        fmt::print("{}\n", to_json(*report).dump(2));
    else if (!options.work.quiet)
        print(*report);
    return {};
}

}  // namespace

void add_bake(CLI::App& app, Command& chosen) {
    auto* command = app.add_subcommand(
        "bake", "Lay on presets, textures and layers, bake every stack, write a glTF file");
    command->footer(kBakeFooter);
    auto options = std::make_shared<BakeOptions>();
    command->add_option("IN", options->input, "A .gltf or .glb file")->required()->type_name("");
    add_output_option(*command, options->output, {".glb", ".gltf"},
                      "The file to write; may be left out with --maps")
        ->required(false);
    add_change_options(*command, options->changes);
    add_map_size_option(*command, options->save.size);
    command
        ->add_option("--maps", options->maps_folder,
                     "Write every map of the result as a file of its own into this folder,\n"
                     "as 'patina export' does")
        ->type_name("DIR");
    add_map_options(*command, options->maps);
    add_work_options(*command, options->work);
    command->callback([options, &chosen] {
        if (options->output.empty() && options->maps_folder.empty())
            throw CLI::RequiredError("-o FILE, --maps DIR or both");
        if (const Status good = io::check_map_options(options->maps); !good)
            throw CLI::ValidationError("--map-format", good.error().message);
        chosen = [options] { return run_bake(*options); };
    });
}

}  // namespace patina::cli
