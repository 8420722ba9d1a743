// SPDX-License-Identifier: MIT
// patina render: a picture of a file, without a window.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/progress_bar.h"
#include "cli/render_conflicts.h"
#include "cli/render_options.h"
#include "cli/render_pictures.h"
#include "io/image_file.h"

namespace patina::cli {
namespace {

constexpr const char* kRenderFooter =
    "World: right-handed, +Y up, metres. A direction (x, y, z) reads an environment at\n"
    "u = 0.5 + atan2(z, x) / 2pi, v = acos(y) / pi from the top row.\n"
    "A .png holds the exposed and tone-mapped picture; a .exr holds linear radiance without both,\n"
    "or with --channel the raw numbers. Filtered environments are kept for the next time in\n"
    "$XDG_CACHE_HOME/patina or ~/.cache/patina, at most 512 MiB.\n"
    "\n"
    "Examples:\n"
    "  patina render model.glb -o picture.png\n"
    "  patina render model.glb --split 0.4 -o pbr-beside-phong.png\n"
    "  patina render model.glb --shading blinn-phong --phong-exponent 60 --phong-specular #ffd080\n"
    "      -o shiny.png\n"
    "  patina render model.glb --channel roughness --size 512x512 -o roughness.png\n"
    "  patina render model.glb --channel strip --size 320x240 -o channels.png\n"
    "  patina render model.glb --channel all --split 0.5 --size 640x480 --samples 64\n"
    "      -o everything.png\n"
    "  patina render model.glb --channel final,normal,diffuse-ambient --columns 1 -o three.png\n"
    "  patina render model.glb --environment sky --sun-elevation 8 -o evening.png\n"
    "  patina render model.glb --turntable 36 -o spin.png\n"
    "  patina render model.glb --split 0.5 --left phong --against blinn-phong -o two-phongs.png\n"
    "  patina render model.glb --shading two-views --against-terms lecture -o gltf-lecture.png\n"
    "  patina render model.glb --shading difference --against pbr --against-path forward -o d.png\n"
    "  patina render model.glb --shading difference --difference-range 0.2 --samples 256 -o d.png\n"
    "  patina render model.glb --light "
    "'{\"kind\":\"sphere\",\"position\":[1,2,1],\"radius\":0.3}'\n"
    "      --samples 256 -o lamp.png\n"
    "  patina render model.glb --camera 0 -o as-the-file-looks.png\n"
    "  patina render model.glb --environment garden.hdr --background environment\n"
    "      --camera-position 2,1,3 --camera-target 0,0.5,0 --fov-y 35 --samples 64 -o picture.exr";

/// The file of one picture of a turntable: spin.png becomes spin-000.png.
std::filesystem::path output_path(const RenderOptions& options, int index) {
    if (!options.turntable) return options.output;
    std::filesystem::path path = options.output;
    path.replace_filename(fmt::format("{}-{:03}{}", options.output.stem().string(), index,
                                      options.output.extension().string()));
    return path;
}

nlohmann::ordered_json to_json(const render::SideCost& cost) {
    nlohmann::ordered_json passes;
    for (const render::PassCost& pass : cost.passes) passes[std::string(pass.name)] = pass.gpu_ms;
    return {{"frame_ms", cost.frame_ms},
            {"passes_ms", passes},
            {"gbuffer_bytes", cost.gbuffer_bytes},
            {"environment_bytes", cost.environment_bytes}};
}

nlohmann::ordered_json to_json(const std::filesystem::path& path,
                               const render::RenderedImage& picture) {
    nlohmann::ordered_json json = {{"output", path.string()},
                                   {"width", picture.image.width},
                                   {"height", picture.image.height},
                                   {"triangles", picture.stats.triangles},
                                   {"material_texture_bytes", picture.stats.material_texture_bytes},
                                   {"bake_ms", picture.bake_ms},
                                   {"environment_ms", picture.environment_ms},
                                   {"render_ms", picture.render_ms},
                                   {"left", to_json(picture.stats.left)}};
    if (picture.stats.right) json["right"] = to_json(*picture.stats.right);
    return json;
}

void print(const nlohmann::ordered_json& pictures, const RenderOptions& options) {
    if (options.work.json) {
        fmt::print("{}\n", (options.turntable ? pictures : pictures.front()).dump(2));
    } else if (!options.work.quiet) {
        for (const auto& picture : pictures)
            fmt::print("{}: {}x{}, {:.0f} ms\n", picture["output"].get<std::string>(),
                       picture["width"].get<int>(), picture["height"].get<int>(),
                       picture["bake_ms"].get<double>() + picture["environment_ms"].get<double>() +
                           picture["render_ms"].get<double>());
        if (is_heat_map(options))
            fmt::print(
                "black is no difference, pale yellow one of {:g} and more, in exposed "
                "luminance\n",
                options.request.view.difference_range);
    }
}

Status run_render(const RenderOptions& options) {
    const ThreadScope threads(options.work);
    const Progress progress;
    nlohmann::ordered_json pictures = nlohmann::ordered_json::array();
    const auto write = [&](int index, render::RenderedImage& picture) {
        const std::filesystem::path path = output_path(options, index);
        pictures.push_back(to_json(path, picture));
        if (is_heat_map(options))
            pictures.back()["difference_range"] = options.request.view.difference_range;
        if (const auto sheet = sheet_of(options)) pictures.back()["cells"] = to_json(*sheet);
        return io::write_image_file(path, picture.image);
    };
    {
        const ProgressBar bar(progress, !options.work.quiet);
        if (const Status drawn = draw_pictures(options, write, progress); !drawn) return drawn;
    }
    print(pictures, options);
    return {};
}

}  // namespace

void add_render(CLI::App& app, Command& chosen) {
    auto* command = app.add_subcommand("render", "Draw a picture of a file, without a window");
    command->footer(kRenderFooter);
    auto options = std::make_shared<RenderOptions>();
    command->add_option("IN", options->input, "A .gltf or .glb file")->required()->type_name("");
    add_output_option(*command, options->output, {".png", ".tif", ".exr"}, "The picture to write");
    add_change_options(*command, options->changes);
    add_view_options(*command, *options);
    add_work_options(*command, options->work);
    command->callback([command, options, &chosen] {
        if (const std::string_view conflict = conflict_in(*command, *options); !conflict.empty())
            throw CLI::ValidationError(std::string(conflict));
        chosen = [options] { return run_render(*options); };
    });
}

}  // namespace patina::cli
