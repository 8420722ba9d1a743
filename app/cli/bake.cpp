// SPDX-License-Identifier: MIT
// patina bake: presets laid on, every stack baked, one glTF file written.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/input.h"
#include "cli/progress_bar.h"
#include "core/log.h"
#include "io/save.h"

namespace patina::cli {
namespace {

constexpr const char* kFooter =
    "Layers lie on top of what the material had; textures that no layer covers stay as they are.\n"
    "With nothing to change, the output is the input, byte for byte.\n"
    "\n"
    "Examples:\n"
    "  patina bake model.glb --preset rusted-iron@Body --size 2048 -o out.glb\n"
    "  patina bake model.glb --preset painted-wood --preset my/dust.json -o out.glb\n"
    "  patina bake painted.glb --maps maps --map-format tif -o out.glb";

struct BakeOptions {
    std::filesystem::path input;
    std::filesystem::path output;
    std::vector<PresetRequest> presets;
    io::SaveOptions save;
    WorkOptions work;
};

nlohmann::ordered_json to_json(const io::SaveReport& report) {
    nlohmann::ordered_json files = nlohmann::ordered_json::array();
    for (const auto& file : report.map_files) files.push_back(file.string());
    return {{"output", report.path.string()},
            {"bytes", report.bytes},
            {"materials_written", report.materials_written},
            {"maps_baked", report.maps_baked},
            {"map_files", files},
            {"warnings", report.warnings}};
}

void print(const io::SaveReport& report) {
    fmt::print("{}: {} bytes, {} materials written, {} maps baked\n", report.path.string(),
               report.bytes, report.materials_written, report.maps_baked);
    for (const auto& file : report.map_files) fmt::print("{}\n", file.string());
}

Status run_bake(const BakeOptions& options) {
    const ThreadScope threads(options.work);
    const Progress progress;
    Result<io::SaveReport> report;
    {
        const ProgressBar bar(progress, !options.work.quiet);
        auto loaded = opened_document(options.input, progress);
        if (!loaded) return passed_on(loaded);
        if (const Status applied = apply_presets(*loaded, options.presets); !applied)
            return applied;
        report = io::save_document(*loaded->document, *loaded->images, options.output, options.save,
                                   progress);
    }
    if (!report) return passed_on(report);
    for (const std::string& warning : report->warnings) log_warning("{}", warning);
    if (options.work.json)
        fmt::print("{}\n", to_json(*report).dump(2));
    else if (!options.work.quiet)
        print(*report);
    return {};
}

}  // namespace

void add_bake(CLI::App& app, Command& chosen) {
    auto* command =
        app.add_subcommand("bake", "Lay on presets, bake every stack, write a glTF file");
    command->footer(kFooter);
    auto options = std::make_shared<BakeOptions>();
    command->add_option("IN", options->input, "A .gltf or .glb file")->required()->type_name("");
    add_output_option(*command, options->output, {".glb", ".gltf"}, "The file to write");
    add_preset_option(*command, options->presets);
    command
        ->add_option("--size", options->save.size,
                     "Side of the baked maps; as each material says if unset")
        ->check(CLI::IsMember({256, 512, 1024, 2048, 4096, 8192}))
        ->type_name("256|512|1024|2048|4096|8192");
    command
        ->add_option("--maps", options->save.maps_folder,
                     "Also write each baked map as a file of its own into this folder")
        ->type_name("DIR");
    command->add_option("--map-format", options->save.map_format, "The format of those files")
        ->check(CLI::IsMember({"png", "tif"}))
        ->type_name("png|tif")
        ->capture_default_str();
    add_work_options(*command, options->work);
    command->callback([options, &chosen] { chosen = [options] { return run_bake(*options); }; });
}

}  // namespace patina::cli
