// SPDX-License-Identifier: MIT
// patina render: a picture of a file, without a window.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/input.h"
#include "cli/progress_bar.h"
#include "cli/render_options.h"
#include "core/log.h"
#include "io/image_file.h"
#include "render/environment.h"

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
    "  patina render model.glb --environment sky --sun-elevation 8 -o evening.png\n"
    "  patina render model.glb --turntable 36 -o spin.png\n"
    "  patina render model.glb --shading difference --against pbr --against-path forward -o d.png\n"
    "  patina render model.glb --light "
    "'{\"kind\":\"sphere\",\"position\":[1,2,1],\"radius\":0.3}'\n"
    "      --samples 256 -o lamp.png\n"
    "  patina render model.glb --environment garden.hdr --background environment\n"
    "      --camera-position 2,1,3 --camera-target 0,0.5,0 --fov-y 35 --samples 64 -o picture.exr";

Result<ImagePtr> environment_map(const std::filesystem::path& path) {
    const auto bytes = read_file(path);
    if (!bytes) return passed_on(bytes);
    auto map = io::decode_image(*bytes, path.string());
    if (!map) return failure("{}: {}", quoted_for_message(path.string()), map.error().message);
    return map;
}

/// Puts the environment that was asked for into the document or the request.
Status set_environment(const RenderOptions& options, io::LoadedDocument& loaded,
                       render::OffscreenRequest& request) {
    Document document = *loaded.document;
    std::string& name = document.environment.name;
    if (render::is_builtin_environment(options.environment)) {
        name = options.environment;
    } else if (!options.environment.empty()) {
        const auto map = environment_map(options.environment);
        if (!map) return passed_on(map);
        request.environment = *map;
    } else if (!render::is_builtin_environment(name)) {
        // A file may not make this program read another one.
        log_warning("{} was lit by '{}': give it with --environment; the studio is used",
                    quoted_for_message(options.input.string()), quoted_for_message(name));
        name = render::kBuiltinEnvironments.front().id;
    }
    if (options.sun_elevation_degrees) {
        if (request.environment || name != render::kSkyEnvironment)
            return failure("--sun-elevation moves the sun of the sky: add --environment {}",
                           render::kSkyEnvironment);
        document.environment.sun_elevation_degrees = *options.sun_elevation_degrees;
    }
    loaded.document = std::make_shared<const Document>(std::move(document));
    return {};
}

void set_camera(const RenderOptions& options, const Document& document,
                render::OffscreenRequest& request) {
    render::Camera& camera = request.view.camera;
    if (options.camera_up) camera.up = *options.camera_up;
    if (!options.camera_position) return;
    request.automatic_camera.reset();
    camera.position = *options.camera_position;
    camera.target = options.camera_target.value_or(document.scene->bounds_world.center());
}

/// Draws what was asked for, and hands each picture to `each`.
Status draw_pictures(const RenderOptions& options, const render::EachPicture& each,
                     const Progress& progress) {
    auto loaded = changed_document(options.input, options.changes, options.work.quiet, progress);
    if (!loaded) return passed_on(loaded);
    render::OffscreenRequest request = options.request;
    request.environment_cache = render::user_environment_cache();
    request.linear = io::image_format_of(options.output) == io::ImageFormat::Exr;
    if (const Status lit = set_environment(options, *loaded, request); !lit) return lit;
    set_camera(options, *loaded->document, request);
    for (const auto& change : options.term_changes) {
        change(request.view.left.terms);
        change(request.view.right.terms);
    }
    if (options.against_path) request.view.right.path = *options.against_path;
    if (!options.strip)
        return render::render_turntable_offscreen(*loaded->document, *loaded->images, request,
                                                  options.turntable.value_or(1), each, progress);
    auto strip = render::render_strip_offscreen(*loaded->document, *loaded->images, request,
                                                request.size, progress);
    if (!strip) return passed_on(strip);
    return each(0, *strip);
}

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
    }
}

Status run_render(const RenderOptions& options) {
    const ThreadScope threads(options.work);
    const Progress progress;
    nlohmann::ordered_json pictures = nlohmann::ordered_json::array();
    const auto write = [&](int index, render::RenderedImage& picture) {
        const std::filesystem::path path = output_path(options, index);
        pictures.push_back(to_json(path, picture));
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
    command->callback([options, &chosen] { chosen = [options] { return run_render(*options); }; });
}

}  // namespace patina::cli
