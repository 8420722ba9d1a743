// SPDX-License-Identifier: MIT
// patina render: a picture of a file, without a window.
#include <fmt/format.h>

#include <charconv>
#include <functional>
#include <nlohmann/json.hpp>

#include "cli/arguments.h"
#include "cli/changes.h"
#include "cli/commands.h"
#include "cli/input.h"
#include "cli/progress_bar.h"
#include "core/log.h"
#include "io/image_file.h"
#include "render/environment.h"
#include "render/offscreen.h"

namespace patina::cli {
namespace {

constexpr const char* kFooter =
    "World: right-handed, +Y up, metres. A direction (x, y, z) reads an environment at\n"
    "u = 0.5 + atan2(z, x) / 2pi, v = acos(y) / pi from the top row.\n"
    "A .png holds the exposed and tone-mapped picture; a .exr holds linear radiance without both,\n"
    "or with --channel the raw numbers. Filtered environments are kept for the next time in\n"
    "$XDG_CACHE_HOME/patina or ~/.cache/patina, at most 512 MiB.\n"
    "\n"
    "Examples:\n"
    "  patina render model.glb -o picture.png\n"
    "  patina render model.glb --shading split --divider 0.4 -o pbr-beside-phong.png\n"
    "  patina render model.glb --channel roughness --size 512x512 -o roughness.png\n"
    "  patina render model.glb --channel strip --size 320x240 -o channels.png\n"
    "  patina render model.glb --turntable 36 -o spin.png\n"
    "  patina render model.glb --shading difference --against pbr --against-path forward -o d.png\n"
    "  patina render model.glb --light "
    "'{\"kind\":\"sphere\",\"position\":[1,2,1],\"radius\":0.3}'\n"
    "      --samples 256 -o lamp.png\n"
    "  patina render model.glb --environment garden.hdr --background environment\n"
    "      --camera-position 2,1,3 --camera-target 0,0.5,0 --fov-y 35 --samples 64 -o picture.exr";

/// What --shading names: one model, or two against each other.
struct PictureKind {
    std::string_view id;
    render::CompareMode compare;
    render::ShadingModel left;
};
constexpr std::array kPictureKinds = {
    PictureKind{"pbr", render::CompareMode::Single, render::ShadingModel::Pbr},
    PictureKind{"phong", render::CompareMode::Single, render::ShadingModel::Phong},
    PictureKind{"blinn-phong", render::CompareMode::Single, render::ShadingModel::BlinnPhong},
    PictureKind{"split", render::CompareMode::Split, render::ShadingModel::Pbr},
    PictureKind{"two-views", render::CompareMode::TwoViews, render::ShadingModel::Pbr},
    PictureKind{"difference", render::CompareMode::Difference, render::ShadingModel::Pbr},
};

struct TermSet {
    std::string_view id;
    render::PbrTerms terms;
};
constexpr std::array kTermSets = {TermSet{"gltf", {}}, TermSet{"lecture", render::kLectureTerms}};

struct NamedDirection {
    std::string_view id;
    render::ViewDirection direction;
};
constexpr std::array kDirections = {
    NamedDirection{"three-quarter", render::ViewDirection::ThreeQuarter},
    NamedDirection{"front", render::ViewDirection::Front},
    NamedDirection{"back", render::ViewDirection::Back},
    NamedDirection{"left", render::ViewDirection::Left},
    NamedDirection{"right", render::ViewDirection::Right},
    NamedDirection{"top", render::ViewDirection::Top},
    NamedDirection{"bottom", render::ViewDirection::Bottom},
};

struct RenderOptions {
    std::filesystem::path input;
    std::filesystem::path output;
    Changes changes;
    std::string environment;  ///< a built-in name or a file; empty: as the document says
    std::optional<glm::vec3> camera_position;
    std::optional<glm::vec3> camera_target;
    std::optional<glm::vec3> camera_up;
    std::optional<render::RenderPath> against_path;
    std::optional<int> turntable;
    std::vector<std::function<void(render::PbrTerms&)>> term_changes;
    bool strip = false;
    render::OffscreenRequest request;
    WorkOptions work;
};

bool is_builtin(std::string_view environment) {
    for (const render::BuiltinEnvironment& entry : render::kBuiltinEnvironments)
        if (entry.id == environment) return true;
    return false;
}

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
    if (is_builtin(options.environment)) {
        name = options.environment;
    } else if (!options.environment.empty()) {
        const auto map = environment_map(options.environment);
        if (!map) return passed_on(map);
        request.environment = *map;
    } else if (!is_builtin(name)) {
        // A file may not make this program read another one.
        log_warning("{} was lit by '{}': give it with --environment; the studio is used",
                    quoted_for_message(options.input.string()), quoted_for_message(name));
        name = render::kBuiltinEnvironments.front().id;
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

void add_picture_options(CLI::App& command, RenderOptions& options) {
    render::View& view = options.request.view;
    add_size_option(command, "--size", options.request.size.width, options.request.size.height,
                    "Size of the picture, or of each channel of the strip");
    command
        .add_option("--samples", options.request.samples,
                    "Samples that are averaged; from 64 on the environment is sampled too")
        ->check(CLI::Range(1, 65536))
        ->type_name("N")
        ->capture_default_str();
    command
        .add_option_function<int>(
            "--bits",
            [&options](int bits) {
                options.request.sample_type = bits == 16 ? SampleType::U16 : SampleType::U8;
            },
            "Of each number of a .png or .tif")
        ->check(CLI::IsMember({8, 16}))
        ->type_name("8|16")
        ->default_str("8");
    command.add_option("--exposure", view.exposure_ev, "Exposure; light is multiplied by 2^EV")
        ->check(CLI::Range(-20.0, 20.0))
        ->type_name("EV")
        ->capture_default_str();
    add_choice_option(
        command, "--tone-map", render::kToneMaps,
        [&view](const auto& entry) { view.tone_map = entry.value; }, "How light becomes colour")
        ->default_str("pbr-neutral");
}

/// Terms by themselves, which go over those of --terms.
void add_term_options(CLI::App& command, RenderOptions& options) {
    using render::PbrTerms;
    const auto add = [&]<typename Table, typename Term>(const std::string& flag, const Table& table,
                                                        Term PbrTerms::*term,
                                                        const std::string& help) {
        add_choice_option(
            command, flag, table,
            [&options, term](const auto& entry) {
                options.term_changes.push_back(
                    [term, value = entry.value](PbrTerms& terms) { terms.*term = value; });
            },
            help);
    };
    add("--distribution", render::kDistributionTerms, &PbrTerms::distribution, "D of PBR");
    add("--geometry", render::kGeometryTerms, &PbrTerms::geometry, "G of PBR");
    add("--fresnel", render::kFresnelTerms, &PbrTerms::fresnel, "F of PBR");
    add("--diffuse", render::kDiffuseTerms, &PbrTerms::diffuse, "The diffuse term of PBR");
    command.add_flag_callback(
        "--multiple-scattering",
        [&options] {
            options.term_changes.push_back(
                [](PbrTerms& terms) { terms.multiple_scattering = true; });
        },
        "Give back the energy that single scattering loses");
}

void add_shading_options(CLI::App& command, RenderOptions& options) {
    render::View& view = options.request.view;
    add_choice_option(
        command, "--shading", kPictureKinds,
        [&view](const PictureKind& kind) {
            view.compare = kind.compare;
            view.left.model = kind.left;
        },
        "How surfaces are lit; the last three set PBR against --against")
        ->default_str("pbr");
    add_choice_option(
        command, "--against", render::kShadingModels,
        [&view](const auto& entry) { view.right.model = entry.value; }, "What PBR is compared with")
        ->default_str("phong");
    command.add_option("--divider", view.divider, "Where the split is, of the width")
        ->check(CLI::Range(0.0, 1.0))
        ->type_name("0-1")
        ->capture_default_str();
    add_choice_option(
        command, "--path", render::kRenderPaths,
        [&view](const auto& entry) { view.left.path = view.right.path = entry.value; },
        "How the picture is made: the same shading, at another cost")
        ->default_str("deferred");
    add_choice_option(
        command, "--against-path", render::kRenderPaths,
        [&options](const auto& entry) { options.against_path = entry.value; },
        "How the one that is compared is made; as --path if unset")
        ->type_name("deferred|forward");
    add_choice_option(
        command, "--terms", kTermSets,
        [&view](const TermSet& set) { view.left.terms = view.right.terms = set.terms; },
        "The terms of PBR; the lecture's lack 1/pi and energy balance")
        ->default_str("gltf");
    add_term_options(command, options);
}

/// --channel takes a channel's id or "strip" for ten of them side by side.
void add_channel_option(CLI::App& command, RenderOptions& options) {
    std::string ids = "strip";
    for (const render::ChannelViewInfo& entry : render::kChannelViews)
        ids += fmt::format("|{}", entry.id);
    const auto choose = [&options](const std::string& id) {
        options.strip = id == "strip";
        if (options.strip) return;
        const auto channel = render::channel_view_from_id(id);
        if (!channel)
            throw CLI::ValidationError("--channel", fmt::format("'{}' is no channel", id));
        options.request.view.channel = *channel;
    };
    command.add_option_function<std::string>("--channel", choose, "One channel, or ten in a strip")
        ->type_name(ids)
        ->default_str("final");
}

void add_light_options(CLI::App& command, RenderOptions& options) {
    render::View& view = options.request.view;
    std::string names;
    for (const render::BuiltinEnvironment& entry : render::kBuiltinEnvironments)
        names += fmt::format("{}|", entry.id);
    command
        .add_option(
            "--environment", options.environment,
            "An equirectangular .hdr or .exr file, or a built-in; as the file says if unset")
        ->type_name(names + "FILE");
    command
        .add_option("--environment-rotation", view.environment_rotation_degrees,
                    "Turn it about +Y, counter-clockwise from above")
        ->type_name("DEG")
        ->capture_default_str();
    command
        .add_option("--environment-intensity", view.environment_intensity,
                    "Multiply its light by this")
        ->check(CLI::Range(0.0, 100.0))
        ->type_name("X")
        ->capture_default_str();
    command.add_flag("!--no-normal-filter", view.filter_normals,
                     "Leave out of roughness what of normal maps is finer than a pixel; from 64 "
                     "samples on it is left out anyway");
    command.add_flag("!--no-shadows", view.shadows,
                     "Let suns of the environment, directional lights and the light of the "
                     "traditional models cast none");
}

/// Two hexadecimal digits at each of three places after '#'.
std::optional<glm::vec3> html_color(std::string_view text) {
    if (text.size() != 7 || text[0] != '#') return std::nullopt;
    glm::vec3 color(0.0f);
    for (int i = 0; i < 3; ++i) {
        unsigned byte = 0;
        const char* first = text.data() + 1 + 2 * static_cast<std::size_t>(i);
        const auto [end, error] = std::from_chars(first, first + 2, byte, 16);
        if (error != std::errc() || end != first + 2) return std::nullopt;
        color[i] = static_cast<float>(byte) / 255.0f;
    }
    return color;
}

void add_background_option(CLI::App& command, RenderOptions& options) {
    render::Background& background = options.request.view.background;
    const auto choose = [&background](const std::string& text) {
        if (const auto color = html_color(text)) {
            background = {.kind = render::Background::Kind::Color, .color_srgb = *color};
            return;
        }
        const auto* choice = render::choice_from_id(render::kBackgrounds, text);
        if (choice == nullptr || choice->value == render::Background::Kind::Color)
            throw CLI::ValidationError("--background", fmt::format("'{}' is no background", text));
        background.kind = choice->value;
    };
    command.add_option_function<std::string>("--background", choose, "What is behind the model")
        ->type_name("studio|environment|blurred|none|#rrggbb")
        ->default_str("studio");
}

void add_camera_options(CLI::App& command, RenderOptions& options) {
    auto* position = add_vector_option(command, "--camera-position", options.camera_position,
                                       "Where the camera stands; it frames the scene if unset");
    add_vector_option(command, "--camera-target", options.camera_target,
                      "What it looks at; the middle of the scene if unset")
        ->needs(position);
    add_vector_option(command, "--camera-up", options.camera_up, "What is up in the picture")
        ->default_str("0,1,0")
        ->needs(position);
    command
        .add_option("--fov-y", options.request.view.camera.fov_y_degrees,
                    "Field of view from top to bottom")
        ->check(CLI::Range(1.0, 160.0))
        ->type_name("DEG")
        ->capture_default_str();
    command
        .add_option("--orthographic", options.request.view.camera.orthographic_height,
                    "No perspective: metres from the bottom of the picture to its top")
        ->check(CLI::PositiveNumber)
        ->type_name("HEIGHT");
    command
        .add_option("--turntable", options.turntable,
                    "So many pictures all around the target: OUT-000.png, OUT-001.png ...")
        ->check(CLI::Range(1, 999))
        ->type_name("N");
    add_choice_option(
        command, "--view", kDirections,
        [&options](const NamedDirection& entry) {
            options.request.automatic_camera = entry.direction;
        },
        "From where the scene is framed")
        ->default_str("three-quarter")
        ->excludes(position);
}

}  // namespace

void add_render(CLI::App& app, Command& chosen) {
    auto* command = app.add_subcommand("render", "Draw a picture of a file, without a window");
    command->footer(kFooter);
    auto options = std::make_shared<RenderOptions>();
    command->add_option("IN", options->input, "A .gltf or .glb file")->required()->type_name("");
    add_output_option(*command, options->output, {".png", ".tif", ".exr"}, "The picture to write");
    add_change_options(*command, options->changes);
    add_picture_options(*command, *options);
    add_shading_options(*command, *options);
    add_channel_option(*command, *options);
    add_light_options(*command, *options);
    add_background_option(*command, *options);
    add_camera_options(*command, *options);
    add_work_options(*command, options->work);
    command->callback([options, &chosen] { chosen = [options] { return run_render(*options); }; });
}

}  // namespace patina::cli
