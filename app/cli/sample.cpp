// SPDX-License-Identifier: MIT
// patina sample: the scene that ships as code.
#include "cli/arguments.h"
#include "cli/commands.h"
#include "io/mesh_to_glb.h"
#include "scene/shapes.h"

namespace patina::cli {
namespace {

struct SampleOptions {
    Shape shape = Shape::ShaderBall;
    std::filesystem::path output;
};

Status run_sample(const SampleOptions& options) {
    return write_file_atomically(options.output, io::shape_to_glb(options.shape));
}

}  // namespace

void add_sample(CLI::App& app, Command& chosen) {
    auto* command =
        app.add_subcommand("sample", "Write a sample scene, made by the program itself");
    command->footer(
        "Materials of the shader ball: Ball, Stand. Other shapes have one, named as the shape.\n"
        "\n"
        "Example:\n"
        "  patina sample --shape torus -o torus.glb");
    auto options = std::make_shared<SampleOptions>();
    add_choice_option(
        *command, "--shape", kShapes,
        [options](const ShapeInfo& entry) { options->shape = entry.shape; }, "The mesh to write")
        ->default_str("shader-ball");
    add_output_option(*command, options->output, {".glb"}, "The file to write");
    command->callback([options, &chosen] { chosen = [options] { return run_sample(*options); }; });
}

}  // namespace patina::cli
