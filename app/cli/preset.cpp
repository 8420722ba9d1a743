// SPDX-License-Identifier: MIT
// patina preset: the material library.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/input.h"
#include "core/json.h"
#include "document/preset.h"
#include "io/preset_library.h"

namespace patina::cli {
namespace {

Json to_json(const io::PresetFile& file) {
    const Preset& preset = file.preset;
    Json knobs = Json::array();
    for (const PresetKnob& knob : preset.knobs)
        knobs.push_back({{"id", knob.id}, {"name", knob.name}, {"value", knob.value}});
    return {{"id", preset.id},           {"version", preset.version},
            {"name", preset.name},       {"category", preset.category},
            {"tags", preset.tags},       {"author", preset.author},
            {"licence", preset.licence}, {"description", preset.description},
            {"knobs", std::move(knobs)}, {"layers", preset.layers.size()},
            {"file", file.path.string()}};
}

Status run_list(bool json) {
    const auto presets = io::all_presets();
    if (!presets) return passed_on(presets);
    if (json) {
        Json list = Json::array();
        for (const io::PresetFile& file : *presets) list.push_back(to_json(file));
        fmt::print("{}\n", list.dump(2));
        return {};
    }
    for (const auto& [path, preset] : *presets)
        fmt::print("{:<20} {:<12} {}\n", preset.id, preset.category, preset.description);
    return {};
}

void add_list(CLI::App& app, Command& chosen) {
    auto* command = app.add_subcommand("list", "The presets that ship and your own");
    auto json = std::make_shared<bool>(false);
    command->add_flag("--json", *json, "Report as JSON");
    command->callback([json, &chosen] { chosen = [json] { return run_list(*json); }; });
}

/// The preset file itself is its fullest description.
Status run_show(const std::string& name) {
    const auto file = io::find_preset(name);
    if (!file) return passed_on(file);
    fmt::print("{}\n", preset_to_json(file->preset));
    return {};
}

void add_show(CLI::App& app, Command& chosen) {
    auto* command = app.add_subcommand("show", "Print a preset as JSON");
    auto name = std::make_shared<std::string>();
    command->add_option("PRESET", *name, "The name of one in the list, or a file")
        ->required()
        ->type_name("");
    command->callback([name, &chosen] { chosen = [name] { return run_show(*name); }; });
}

/// The knobs of those presets, or of all that ship.
Status run_knobs(const std::vector<std::string>& names) {
    std::vector<io::PresetFile> files;
    for (const std::string& name : names) {
        auto file = io::find_preset(name);
        if (!file) return passed_on(file);
        files.push_back(std::move(*file));
    }
    if (names.empty()) {
        auto shipped = io::shipped_presets();
        if (!shipped) return passed_on(shipped);
        files = std::move(*shipped);
    }
    for (const io::PresetFile& file : files)
        for (const PresetKnob& knob : file.preset.knobs)
            fmt::print("{:<32} {:<5} {}\n", file.preset.id + "/" + knob.id, knob.value, knob.name);
    return {};
}

void add_knobs(CLI::App& app, Command& chosen) {
    auto* command = app.add_subcommand("knobs", "What --knob can turn, and where it stands");
    auto names = std::make_shared<std::vector<std::string>>();
    command->add_option("PRESETS", *names, "Names of those that ship, or files; all if unset")
        ->type_name("");
    command->callback([names, &chosen] { chosen = [names] { return run_knobs(*names); }; });
}

struct PresetExportOptions {
    std::filesystem::path input;
    std::filesystem::path output;
    std::string material;
    Preset preset;
};

Status run_preset_export(const PresetExportOptions& options) {
    const auto loaded = opened_document(options.input, {});
    if (!loaded) return passed_on(loaded);
    const auto materials = named_materials(*loaded->document, options.material);
    if (!materials) return passed_on(materials);
    if (materials->size() > 1)
        return failure("{}: it has {} materials; pick one with --material",
                       quoted_for_message(options.input.string()), materials->size());
    Preset preset = options.preset;
    preset.layers = materials->front()->stack;
    if (preset.id.empty()) preset.id = options.output.stem().string();
    if (preset.name.empty()) preset.name = materials->front()->name;
    const auto written = io::write_preset(options.output, preset, *loaded->document);
    return written ? Status() : passed_on(written);
}

void add_export_preset(CLI::App& app, Command& chosen) {
    auto* command = app.add_subcommand("export", "Write a material's stack as a preset file");
    auto options = std::make_shared<PresetExportOptions>();
    command->add_option("IN", options->input, "A .gltf or .glb file")->required()->type_name("");
    add_output_option(*command, options->output, {".json"},
                      "The preset to write; images of its layers go beside it");
    const auto text = [&](const char* flag, std::string& value, const char* help) {
        command->add_option(flag, value, help)->type_name("TEXT");
    };
    text("--material", options->material, "Which one, where the file has several");
    text("--id", options->preset.id,
         "Lower-case letters, digits and hyphens; as the file is called");
    text("--name", options->preset.name, "For people; as the material is called");
    text("--category", options->preset.category, "Such as Metal");
    text("--author", options->preset.author, "Who made it");
    text("--licence", options->preset.licence, "An SPDX identifier, such as CC0-1.0");
    text("--description", options->preset.description, "A sentence");
    command->callback(
        [options, &chosen] { chosen = [options] { return run_preset_export(*options); }; });
}

Status run_check(const std::vector<std::filesystem::path>& paths) {
    std::size_t bad = 0;
    for (const auto& path : paths) {
        const auto file = io::read_preset(path);
        if (!file) {
            ++bad;
            fmt::print("{}\n", file.error().message);
            continue;
        }
        io::ImageStore images;
        if (const auto added = io::add_preset_images(*file, images); !added) {
            ++bad;
            fmt::print("{}\n", added.error().message);
        }
    }
    if (bad > 0) return failure("{} of {} presets are not good", bad, paths.size());
    fmt::print("{} good\n", paths.size());
    return {};
}

void add_check_presets(CLI::App& app, Command& chosen) {
    auto* command = app.add_subcommand("check", "Read preset files with their images, strictly");
    auto paths = std::make_shared<std::vector<std::filesystem::path>>();
    command->add_option("FILES", *paths, "Preset files")->required()->type_name("");
    command->callback([paths, &chosen] { chosen = [paths] { return run_check(*paths); }; });
}

}  // namespace

void add_preset(CLI::App& app, Command& chosen) {
    auto* command =
        app.add_subcommand("preset", "The material library: list, show, knobs, export, check");
    command->require_subcommand(1);
    command->footer(
        "Examples:\n"
        "  patina preset list\n"
        "  patina preset show rusted-iron > mine.json\n"
        "  patina preset knobs rusted-iron\n"
        "  patina preset check mine.json\n"
        "  patina preset export painted.glb --material Body --licence CC0-1.0 -o worn-paint.json");
    add_list(*command, chosen);
    add_show(*command, chosen);
    add_knobs(*command, chosen);
    add_export_preset(*command, chosen);
    add_check_presets(*command, chosen);
}

}  // namespace patina::cli
