// SPDX-License-Identifier: MIT
#include "cli/command_line.h"

#include <fmt/format.h>

#include <array>

#include "cli/arguments.h"
#include "cli/commands.h"

namespace patina::cli {
namespace {

constexpr std::array kCommands = {add_bake,    add_render, add_export, add_info,   add_explain,
                                  add_compare, add_check,  add_preset, add_sample, add_completion};

constexpr const char* kCommandLineFooter =
    "Examples:\n"
    "  patina model.glb                      open the editor on a model\n"
    "  patina sample -o ball.glb             write the sample scene\n"
    "  patina bake ball.glb --preset rusted-iron@Ball -o rusty.glb\n"
    "  patina render rusty.glb --shading split -o pbr-beside-phong.png\n"
    "\n"
    "Exit status: 0 done, 1 failed (one line says why), 2 wrong usage.\n"
    "Limits: files of 2 GiB, 1000000 nodes nested 1000 deep, JSON nested 64 deep, images of\n"
    "16384 texels a side and 2 GiB decoded in all, 1024 layers in a material.";

/// The command whose help is to be looked at: "patina", or "patina bake".
std::string innermost_command(const CLI::App& app) {
    std::string name = app.get_name();
    const CLI::App* at = &app;
    while (!at->get_subcommands().empty()) {
        at = at->get_subcommands().front();
        name += " " + at->get_name();
    }
    return name;
}

ExitStatus report(const CLI::App& app, const CLI::ParseError& error) {
    // Help and the version are errors of status 0 to CLI11.
    if (error.get_exit_code() == 0) return {app.exit(error)};
    fmt::print(stderr, "patina: {}; see '{} --help'\n", quoted_for_message(error.what()),
               innermost_command(app));
    return {2};
}

/// What may be said when there is no command.
void add_editor_options(CLI::App& app, EditorRequest& editor) {
    app.add_option("FILE", editor.file, "The model to open in the editor: .glb or .gltf")
        ->check(CLI::Validator(CLI::ExistingFile).description(""))
        ->type_name("");
    app.add_option("--ui-map", editor.ui_map,
                   "Keep this file up to date with every visible control of the editor, as JSON")
        ->type_name("FILE");
    app.add_option("--scale", editor.scale,
                   "Size of the editor's interface; as it was left, or as the monitor asks")
        ->check(CLI::Range(1.0, 2.5))
        ->type_name("X");
    app.add_option("--refine", editor.refining_draws,
                   "Samples that the editor's picture is averaged of while nothing moves: 256; 0 "
                   "keeps the first")
        ->check(CLI::Range(0, 65536))
        ->type_name("N");
    add_size_option(app, "--window", editor.window_width, editor.window_height,
                    "Size of the editor's window; as it was left");
}

}  // namespace

Invocation parse(int argc, char** argv) {
    CLI::App app("Patina, an editor for layered physically based materials in glTF files.");
    app.name("patina");
    app.set_version_flag("--version", "patina " PATINA_VERSION);
    app.footer(kCommandLineFooter);
    app.require_subcommand(0, 1);
    EditorRequest editor;
    add_editor_options(app, editor);
    Command chosen;
    for (const auto add : kCommands) add(app, chosen);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return report(app, error);
    }
    if (!chosen) return editor;
    return chosen;
}

int run(const std::function<Status()>& command) {
    const Status status = command();
    if (status) return 0;
    fmt::print(stderr, "patina: {}\n", status.error().message);
    return 1;
}

}  // namespace patina::cli
