// SPDX-License-Identifier: MIT
// patina export: the maps of a file as images, packed as another program wants them.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/input.h"
#include "cli/map_options.h"
#include "cli/progress_bar.h"
#include "core/log.h"

namespace patina::cli {
namespace {

constexpr const char* kExportFooter =
    "A file MATERIAL_MAP.png for each map in which something varies, whether it was baked from\n"
    "layers or came with the model. Colours are sRGB-encoded, in 32 bits and in exr linear.\n"
    "\n"
    "Examples:\n"
    "  patina export painted.glb -o maps\n"
    "  patina export painted.glb --packing unreal --size 4096 -o maps\n"
    "  patina export painted.glb --packing separate --map-format exr -o maps\n"
    "  patina export painted.glb --map-format base-color=jpg --jpg-quality 85 -o maps";

struct ExportOptions {
    std::filesystem::path input;
    std::filesystem::path folder;
    io::MapExportOptions maps;
    WorkOptions work;
};

Status run_export(const ExportOptions& options) {
    const ThreadScope threads(options.work);
    const Progress progress;
    Result<std::vector<std::filesystem::path>> files;
    {
        const ProgressBar bar(progress, !options.work.quiet);
        const auto loaded = opened_document(options.input, progress);
        if (!loaded) return passed_on(loaded);
        files = io::export_maps(*loaded->document, *loaded->images, options.folder, options.maps,
                                progress);
    }
    if (!files) return passed_on(files);
    for (const std::string& line : io::warnings_of(options.maps)) log_warning("{}", line);
    if (options.work.json) {
        nlohmann::ordered_json json = {{"map_files", nlohmann::ordered_json::array()}};
        for (const auto& file : *files) json["map_files"].push_back(file.string());
        fmt::print("{}\n", json.dump(2));
    } else if (!options.work.quiet) {
        for (const auto& file : *files) fmt::print("{}\n", file.string());
        if (files->empty()) fmt::print("nothing varies: no map is needed\n");
    }
    return {};
}

}  // namespace

void add_export(CLI::App& app, Command& chosen) {
    auto* command = app.add_subcommand("export", "Write the maps as images, packed for a program");
    command->footer(kExportFooter);
    auto options = std::make_shared<ExportOptions>();
    command->add_option("IN", options->input, "A .gltf or .glb file")->required()->type_name("");
    command->add_option("-o,--output", options->folder, "The folder for the maps")
        ->required()
        ->type_name("DIR");
    add_map_size_option(*command, options->maps.size);
    add_map_options(*command, options->maps);
    add_work_options(*command, options->work);
    command->callback([options, &chosen] {
        if (const Status good = io::check_map_options(options->maps); !good)
            throw CLI::ValidationError("--map-format", good.error().message);
        chosen = [options] { return run_export(*options); };
    });
}

}  // namespace patina::cli
